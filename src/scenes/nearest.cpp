// SPDX-License-Identifier: BSD-3-Clause
#include "src/scenes/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "src/scenes/block.hpp"
#include "src/scenes/scene.hpp"

namespace sphk {

NearestParticle::NearestParticle(const Snapshot& snapshot)
    : dimension_(snapshot.dimension), box_(snapshot.box), x_(rows(snapshot.field("Coordinates"))) {
  double volume = 1;
  for (int axis = 0; axis < dimension_; ++axis) volume *= box_.size[axis];
  const double spacing = std::pow(volume / static_cast<double>(x_.size()), 1.0 / dimension_);
  edge_ = std::numeric_limits<double>::infinity();
  std::size_t cells = 1;
  for (int axis = 0; axis < dimension_; ++axis) {
    counts_[axis] = std::max(static_cast<int>(box_.size[axis] / spacing), 1);
    edge_ = std::min(edge_, box_.size[axis] / counts_[axis]);
    cells *= static_cast<std::size_t>(counts_[axis]);
  }
  first_.resize(cells + 1);
  rows_.resize(x_.size());
  for (const Array3& x : x_) ++first_[cell_of(cell_at(x))];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (std::size_t i = x_.size(); i-- > 0;) rows_[--first_[cell_of(cell_at(x_[i]))]] = static_cast<std::uint32_t>(i);
}

/// Shell after shell of cells around that of x, until all that is nearer than the best has been seen.
double NearestParticle::distance(const Array3& x, std::size_t self) const {
  const std::array<int, 3> home = cell_at(x);
  const int most = std::ranges::max(counts_);
  double best = std::numeric_limits<double>::infinity();
  for (int shell = 0; shell <= most / 2 + 1 && best > (shell - 1) * edge_; ++shell) {
    const int J = dimension_ > 1 ? shell : 0, K = dimension_ > 2 ? shell : 0;
    for (int i = -shell; i <= shell; ++i)
      for (int j = -J; j <= J; ++j)
        for (int k = -K; k <= K; ++k)
          if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == shell)
            best = std::min(best, nearest_in(cell_of({home[0] + i, home[1] + j, home[2] + k}), x, self));
  }
  return best;
}

double NearestParticle::nearest_in(std::size_t cell, const Array3& x, std::size_t self) const {
  double best = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
    const std::size_t row = rows_[k];
    if (row == self) continue;
    double r2 = 0;
    for (int axis = 0; axis < dimension_; ++axis) {
      const double d = x_[row][axis] - x[axis], image = d - box_.size[axis] * std::round(d / box_.size[axis]);
      r2 += image * image;
    }
    best = std::min(best, r2);
  }
  return std::sqrt(best);
}

std::array<int, 3> NearestParticle::cell_at(const Array3& x) const {
  std::array<int, 3> cell{};
  for (int axis = 0; axis < dimension_; ++axis)
    cell[axis] =
        static_cast<int>(wrapped(x[axis] - box_.lower[axis], box_.size[axis]) / box_.size[axis] * counts_[axis]);
  return cell;
}

std::size_t NearestParticle::cell_of(const std::array<int, 3>& cell) const {
  std::size_t index = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int inside = (cell[axis] % counts_[axis] + counts_[axis]) % counts_[axis];
    index = index * static_cast<std::size_t>(counts_[axis]) + static_cast<std::size_t>(inside);
  }
  return index;
}

}  // namespace sphk
