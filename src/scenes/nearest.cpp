#include "src/scenes/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/scenes/block.hpp"

namespace sphk {

NearestParticle::NearestParticle(const Snapshot& snapshot) : dimension_(snapshot.dimension), box_(snapshot.box) {
  const std::vector<double>& x = snapshot.field("Coordinates").values;
  double volume = 1;
  for (int axis = 0; axis < dimension_; ++axis) volume *= box_.size[axis];
  const double spacing = std::pow(volume / static_cast<double>(snapshot.size()), 1.0 / dimension_);
  edge_ = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < dimension_; ++axis) {
    counts_[axis] = std::max(static_cast<int>(box_.size[axis] / spacing), 1);
    edge_ = std::min(edge_, box_.size[axis] / counts_[axis]);
  }
  std::vector<std::size_t> cells(snapshot.size());
  begin_.assign(std::size_t(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    ++begin_[(cells[i] = cell_of(cell_at({x[3 * i], x[3 * i + 1], x[3 * i + 2]}))) + 1];
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  x_.resize(cells.size());
  row_.resize(cells.size());
  std::vector<std::size_t> next = begin_;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t to = next[cells[i]]++;
    x_[to] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
    row_[to] = i;
  }
}

/// Shell after shell of cells around that of x, until all that is nearer than the best has been seen.
double NearestParticle::distance(const Array3& x, std::size_t self) const {
  const std::array<int, 3> home = cell_at(x);
  const int most = std::ranges::max(counts_);
  double best = std::numeric_limits<double>::infinity();
  for (int shell = 0; shell <= most / 2 + 1 && best > (shell - 1) * edge_; ++shell) {
    const int J = dimension_ > 1 ? shell : 0, K = dimension_ > 2 ? shell : 0;
    for (int i = -shell; i <= shell; ++i)
      for (int j = -J; j <= J; ++j) {
        const bool all = std::max(std::abs(i), std::abs(j)) == shell;  // else the two ends along the last axis only
        for (int k = -K; k <= K; k += all || K == 0 ? 1 : 2 * K)
          if (all || K > 0)
            best = std::min(best, nearest_in(cell_of({home[0] + i, home[1] + j, home[2] + k}), x, self));
      }
  }
  return best;
}

double NearestParticle::nearest_in(std::size_t cell, const Array3& x, std::size_t self) const {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t p = begin_[cell]; p < begin_[cell + 1]; ++p) {
    if (row_[p] == self) continue;
    double r2 = 0;
    for (int axis = 0; axis < dimension_; ++axis) {
      const double d = x_[p][axis] - x[axis], image = d - box_.size[axis] * std::round(d / box_.size[axis]);
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
    index = index * counts_[axis] + inside;
  }
  return index;
}

}  // namespace sphk
