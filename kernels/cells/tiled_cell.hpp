#pragma once

#include "kernels/cells/pair.hpp"
#include "kernels/cells/tile.hpp"

namespace sphk {

/// Which side's support decides that a pair takes part.
enum class Reach {
  gather,    ///< r < h_i
  symmetric  ///< r < max(h_i, h_j)
};

/// One cell of at most 64 particles and the two levels of candidates that its pair loops run over: everything near the cell,
/// and of that everything near one of its sub-cells. Lives on one thread of the host; its tiles are team scratch.
template <class T, int D, class FieldList, Reach mode, class C>
class TiledCell {
 public:
  using CellTile = Tile<T, D, FieldList>;
  static constexpr int width = native_lanes<T>;
  using Pack = simd<T, width>;

  static constexpr std::size_t scratch_bytes() {
    return (2 * CellTile::entries + CellTile::capacity) * sizeof(T) + CellTile::capacity * sizeof(int) + 64;
  }

  TiledCell(void* scratch, const CellTree<D>& tree, const C& columns, int cell)
      : tree_(tree), columns_(columns), cell_(cell) {
    T* memory = reinterpret_cast<T*>((reinterpret_cast<std::uintptr_t>(scratch) + 63) / 64 * 64);
    near_.data = memory;
    sub_.data = memory + CellTile::entries;
    gap2_ = memory + 2 * CellTile::entries;
    index_ = reinterpret_cast<int*>(gap2_ + CellTile::capacity);
    frame_ = Frame<D>::of(bounds(), columns, begin());
  }

  int begin() const { return cell_ * cell_size; }
  int end() const { return sphk::min(begin() + cell_size, tree_.n); }
  const Bounds<D>& bounds() const { return tree_.node(1, cell_); }
  int first_sub_cell() const { return cell_ * fan_out; }
  int last_sub_cell() const { return sphk::min(first_sub_cell() + fan_out, tree_.count(0)); }
  const Frame<D>& frame() const { return frame_; }
  const CellTile& candidates() const { return sub_; }

  /// Collects what comes within `reach` of the cell and calls flush(whole) each time the tile is full and at the end;
  /// `whole` says that the tile holds all there is.
  template <class Flush>
  void collect(const Bounds<D>& all, double reach, Flush&& flush) {
    near_.count = 0;
    reach_ = reach;
    bool whole = true;
    walk(tree_, all, bounds(), [&](double h) { return reach_with(h); }, [&](int sub_cell, const double* shift) {
      if (near_.count + sub_cell_size > CellTile::capacity - width) {
        whole = false;
        flush(false);
        near_.count = 0;
      }
      append(sub_cell, shift);
    });
    flush(whole);
  }

  /// Makes candidates() those of the collected ones that come within `reach` of the sub-cell, padded to whole packs.
  void select(int sub_cell, double reach) {
    const Bounds<D>& b = tree_.node(0, sub_cell);
    T centre[D], half[D];
    for (int d = 0; d < D; ++d) {
      const double lo = b.lo[d] - frame_.x[d], hi = b.hi[d] - frame_.x[d];
      centre[d] = static_cast<T>(0.5 * (lo + hi));
      half[d] = static_cast<T>(0.5 * (hi - lo) * (1 + rounding));
    }
    measure_gaps(centre, half);
    const T reach2 = static_cast<T>(reach * reach * (1 + rounding));
    int n = 0;
    for (int k = 0; k < near_.count; ++k) {
      index_[n] = k;
      n += gap2_[k] < reach2;
    }
    sub_.assign(near_, index_, n);
    if (n > 0) sub_.pad(width, far_away(sub_));
  }

 private:
  static constexpr double rounding = 8 * std::numeric_limits<T>::epsilon();

  double reach_with(double h) const { return mode == Reach::symmetric ? sphk::max(reach_, h) : reach_; }

  /// Squared distance of every collected candidate from a box; where pairs are symmetric, zero inside its own support.
  void measure_gaps(const T* centre, const T* half) {
    const T* x[D];
    for (int d = 0; d < D; ++d) x[d] = near_.template row<Position>(d);
    const int n = near_.count;
    const Pack zero(T(0));
    for (int k = 0; k < n; k += width) {
      Pack gap2 = zero;
      for (int d = 0; d < D; ++d) {
        const Pack gap = sphk::max(sphk::abs(sphk::load<Pack>(x[d] + k) - Pack(centre[d])) - Pack(half[d]), zero);
        gap2 = gap2 + gap * gap;
      }
      if constexpr (mode == Reach::symmetric) {
        const Pack h_inv = sphk::load<Pack>(near_.template row<InverseSupport>() + k);
        gap2 = sphk::select(gap2 * h_inv * h_inv < Pack(T(1 + rounding)), zero, gap2);
      }
      sphk::store(gap2_ + k, gap2);
    }
  }

  /// Appends the particles of a sub-cell that come within reach of the cell.
  void append(int sub_cell, const double* shift) {
    const Frame<D> image = frame_.shifted(shift);
    const Bounds<D>& b = bounds();
    const int j0 = sub_cell * sub_cell_size, n = sphk::min(sub_cell_size, tree_.n - j0);
    double gap2[sub_cell_size] = {};
    for (int d = 0; d < D; ++d) {
      const double* x = columns_.template row<Position>(d) + j0;
      const double half = 0.5 * (b.hi[d] - b.lo[d]);
      for (int k = 0; k < sub_cell_size; ++k) {
        const double gap = sphk::max(sphk::abs(x[k] - image.x[d]) - half, 0.0);
        gap2[k] += gap * gap;
      }
    }
    const double* h = columns_.template row<Support>() + j0;
    int index[sub_cell_size], kept = 0;
    for (int k = 0; k < n; ++k) {
      const double distance = reach_with(h[k]);
      index[kept] = k;
      kept += gap2[k] < distance * distance * (1 + rounding);
    }
    near_.append(columns_, image, j0, index, kept);
  }

  /// A place that no particle of the cell and no candidate reaches.
  T far_away(const CellTile& tile) const {
    double h = reach_;
    if constexpr (mode == Reach::symmetric)
      h = sphk::max(h, 1.0 / static_cast<double>(tile.template row<InverseSupport>()[tile.count - 1]));
    const Bounds<D>& b = bounds();
    return static_cast<T>(b.hi[0] - b.lo[0] + 4 * h);
  }

  const CellTree<D>& tree_;
  const C& columns_;
  int cell_;
  Frame<D> frame_;
  double reach_ = 0;
  CellTile near_, sub_;
  T* gap2_;
  int* index_;
};

}  // namespace sphk
