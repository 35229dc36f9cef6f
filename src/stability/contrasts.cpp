// SPDX-License-Identifier: BSD-3-Clause
#include "src/stability/contrasts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace sphk {

namespace {

constexpr std::size_t most = 16;    // particles in a box that is not halved
constexpr double one_pressure = 3;  // pressures that differ by less count as one
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The gas of a box and where that ends.
struct Leaf {
  Array3 lower{}, upper{};
  double density = 0, pressure = 0;  ///< the latter over gamma - 1
  double least_mass = infinity, largest_mass = 0;
};

double ratio(double a, double b) {
  const auto [low, high] = std::minmax(a, b);
  return low == high ? 1 : high / low;
}

/// A tree of boxes, each halved at the middle particle along the axis on which its particles spread most, until few are
/// left. The whole is as long as the box along periodic axes, and as the gas along others.
class Boxes {
 public:
  explicit Boxes(const ParticleSet& gas) : gas_(gas), dimension_(static_cast<std::size_t>(gas.dimension)), x_(gas.x) {
    for (std::size_t d = 0; d < dimension_; ++d) find_ends(d);
    std::vector<std::size_t> rows(gas.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    grow(rows, {lower_, upper_});
  }

  const std::vector<Leaf>& leaves() const { return leaves_; }

  /// The box beyond the middle of that side; this one where the gas ends there.
  const Leaf& beside(const Leaf& leaf, std::size_t axis, bool above) const {
    const double edge = above ? leaf.upper[axis] : leaf.lower[axis];
    const bool at_end = edge == (above ? upper_ : lower_)[axis];
    if (at_end && !gas_.box.periodic[axis]) return leaf;
    Array3 x{};
    for (std::size_t d = 0; d < dimension_; ++d) x[d] = 0.5 * (leaf.lower[d] + leaf.upper[d]);
    x[axis] = at_end ? (above ? lower_ : upper_)[axis] : above ? edge : std::nextafter(edge, -infinity);
    std::size_t node = 0;
    while (nodes_[node].leaf == none) node = nodes_[node].children[x[nodes_[node].axis] >= nodes_[node].plane];
    return leaves_[nodes_[node].leaf];
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  using Rows = std::span<std::size_t>;
  struct Node {
    std::size_t leaf = none, axis = 0;
    double plane = 0;
    std::array<std::size_t, 2> children{};
  };
  struct Ends {
    Array3 lower, upper;
  };

  void find_ends(std::size_t d) {
    if (gas_.box.periodic[d]) {
      const double size = gas_.box.size[d];
      lower_[d] = gas_.box.lower[d], upper_[d] = lower_[d] + size;
      for (Array3& x : x_) x[d] -= size * std::floor((x[d] - lower_[d]) / size);
      return;
    }
    const auto [least, largest] = std::ranges::minmax(x_, {}, [d](const Array3& x) { return x[d]; });
    lower_[d] = least[d], upper_[d] = largest[d];
  }

  /// The axis along which the particles spread most, and how far that is.
  std::pair<std::size_t, double> widest(Rows rows) const {
    std::pair<std::size_t, double> found{0, 0};
    for (std::size_t d = 0; d < dimension_; ++d) {
      double least = infinity, largest = -infinity;
      for (const std::size_t row : rows) least = std::min(least, x_[row][d]), largest = std::max(largest, x_[row][d]);
      if (largest - least > found.second) found = {d, largest - least};
    }
    return found;
  }

  std::size_t grow(Rows rows, const Ends& ends) {
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    const auto [axis, spread] = widest(rows);
    if (rows.size() <= most || !(spread > 0)) {
      nodes_[node].leaf = leaves_.size();
      leaves_.push_back(filled(rows, ends));
      return node;
    }
    const auto place = [&](std::size_t row) { return x_[row][axis]; };
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
    std::ranges::nth_element(rows, middle, {}, place);
    const double median = place(*middle);
    auto upper = std::ranges::partition(rows, [&](std::size_t row) { return place(row) < median; });
    if (upper.size() == rows.size())  // the least place is that of more than half of them
      upper = std::ranges::partition(rows, [&](std::size_t row) { return place(row) <= median; });
    const Rows above(upper.begin(), upper.end()), below = rows.first(rows.size() - above.size());
    const double plane =
        0.5 * (place(*std::ranges::max_element(below, {}, place)) + place(*std::ranges::min_element(above, {}, place)));
    Ends low = ends, high = ends;
    low.upper[axis] = high.lower[axis] = plane;
    nodes_[node].axis = axis, nodes_[node].plane = plane;
    const std::size_t first = grow(below, low), second = grow(above, high);
    nodes_[node].children = {first, second};
    return node;
  }

  Leaf filled(Rows rows, const Ends& ends) const {
    Leaf leaf{ends.lower, ends.upper};
    double mass = 0, heat = 0, volume = 1;
    for (const std::size_t row : rows) {
      mass += gas_.m[row], heat += gas_.m[row] * gas_.u[row];
      leaf.least_mass = std::min(leaf.least_mass, gas_.m[row]);
      leaf.largest_mass = std::max(leaf.largest_mass, gas_.m[row]);
    }
    for (std::size_t d = 0; d < dimension_; ++d)
      if (ends.upper[d] > ends.lower[d]) volume *= ends.upper[d] - ends.lower[d];
    leaf.density = mass / volume, leaf.pressure = heat / volume;
    return leaf;
  }

  const ParticleSet& gas_;
  std::size_t dimension_;
  std::vector<Array3> x_;  ///< inside the box along periodic axes
  Array3 lower_{}, upper_{};
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace

Contrasts contrasts(const ParticleSet& gas) {
  Contrasts found;
  found.without_heat = static_cast<std::size_t>(std::ranges::count(gas.u, 0.0));
  if (gas.size() < 2) return found;
  const Boxes boxes(gas);
  std::vector<const Leaf*> star;  // a box and those beside it: gas changes over more than one where the change cuts it
  for (const Leaf& leaf : boxes.leaves()) {
    star = {&leaf};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(gas.dimension); ++axis)
      for (const bool above : {false, true}) star.push_back(&boxes.beside(leaf, axis, above));
    for (const Leaf* a : star)
      for (const Leaf* b : star) {
        const double pressure = ratio(a->pressure, b->pressure);
        found.pressure = std::max(found.pressure, pressure);
        if (pressure < one_pressure) found.density = std::max(found.density, ratio(a->density, b->density));
        found.mass = std::max(found.mass, a->largest_mass / b->least_mass);
      }
  }
  return found;
}

}  // namespace sphk
