#pragma once

#include "kernels/cells/tile.hpp"
#include "kernels/core/compress.hpp"

namespace sphk {

/// Which side's support decides that a pair takes part.
enum class Reach {
  gather,    ///< r < h_i
  symmetric  ///< r < max(h_i, h_j)
};

/// One cell of at most 64 particles and the two levels of candidates that its pair loops run over: everything near the
/// cell, and of that everything near one of its sub-cells. Lives on one thread of the host; its tiles are team scratch.
template <class T, int D, class FieldList, Reach mode, class C>
class TiledCell {
 public:
  using CellTile = Tile<T, D, FieldList>;
  static constexpr int width = native_lanes<T>;
  using Pack = simd<T, width>;

  static constexpr std::size_t scratch_bytes() { return 2 * CellTile::entries * sizeof(T) + 64; }

  TiledCell(void* scratch, const CellTree<D>& tree, const C& columns, int cell)
      : tree_(tree), columns_(columns), cell_(cell) {
    T* memory = reinterpret_cast<T*>((reinterpret_cast<std::uintptr_t>(scratch) + 63) / 64 * 64);
    near_.data = memory;
    sub_.data = memory + CellTile::entries;
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
    walk(
        tree_, all, bounds(), [&](double h) { return reach_with(h); },
        [&](int sub_cell, const double* shift) {
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
      half[d] = static_cast<T>(0.5 * (hi - lo));
    }
    sub_.count = 0;
    for (int k = 0; k < near_.count; k += width) {
      Pack x[D];
      for (int d = 0; d < D; ++d) x[d] = sphk::load<Pack>(near_.template row<Position>(d) + k) - Pack(centre[d]);
      Pack reach_of = static_cast<T>(reach);
      if constexpr (mode == Reach::symmetric)
        reach_of = sphk::max(reach_of, Pack(T(1)) / sphk::load<Pack>(near_.template row<InverseSupport>() + k));
      const unsigned bits = within(x, half, reach_of) & first_lanes(near_.count - k);
      const Compress<Pack> chosen(bits);
      for (int row = 0; row < CellTile::rows; ++row) {
        const int start = row * CellTile::stride;
        chosen.store(sub_.data + start + sub_.count, sphk::load<Pack>(near_.data + start + k));
      }
      sub_.count += chosen.count();
    }
    if (sub_.count > 0) sub_.pad(width, far_away(sub_));
  }

 private:
  /// Packs of at most a sub-cell, for the particles of one.
  static constexpr int narrow = width < sub_cell_size ? width : sub_cell_size;
  using NarrowPack = simd<T, narrow>;

  static constexpr unsigned first_lanes(int n) { return n >= 32 ? ~0u : (1u << n) - 1; }

  double reach_with(double h) const { return mode == Reach::symmetric ? sphk::max(reach_, h) : reach_; }

  /// A bit a lane: does a particle at x come within `reach` of the box [-half, half]? Errs on the side of yes.
  template <class P>
  static unsigned within(const P* x, const T* half, const P& reach) {
    P gap2 = P(T(0));
    for (int d = 0; d < D; ++d) {
      const P gap = sphk::max(sphk::abs(x[d]) - P(half[d]), P(T(0)));
      gap2 = gap2 + gap * gap;
    }
    constexpr T margin = 1 + 32 * std::numeric_limits<T>::epsilon();
    return mask_bits(gap2 < reach * reach * P(margin));
  }

  /// Appends the particles of a sub-cell that come within reach of the cell.
  void append(int sub_cell, const double* shift) {
    const Frame<D> image = frame_.shifted(shift);
    const Bounds<D>& b = bounds();
    T half[D];
    for (int d = 0; d < D; ++d) half[d] = static_cast<T>(0.5 * (b.hi[d] - b.lo[d]));
    const int j0 = sub_cell * sub_cell_size, n = sphk::min(sub_cell_size, tree_.n - j0);
    for (int k = 0; k < n; k += narrow) {
      NarrowPack x[D];
      for (int d = 0; d < D; ++d) x[d] = load_relative_pack<Position>(d, image, j0 + k);
      NarrowPack reach_of = static_cast<T>(reach_);
      if constexpr (mode == Reach::symmetric)
        reach_of = sphk::max(reach_of, load_relative_pack<Support>(0, image, j0 + k));
      const Compress<NarrowPack> chosen(within(x, half, reach_of) & first_lanes(n - k));
      if (chosen.count() == 0) continue;
      for_each_type(FieldList{}, [&]<class F>() {
        for (int c = 0; c < components<F, D>; ++c)
          chosen.store(near_.template row<F>(c) + near_.count, load_relative_pack<F>(c, image, j0 + k));
      });
      near_.count += chosen.count();
    }
  }

  /// A component of field F of the particles from j on, in T and relative to the frame.
  template <class F>
  NarrowPack load_relative_pack(int component, const Frame<D>& frame, int j) const {
    const double* from = columns_.template row<F>(component) + j;
    const double reference = frame.template reference<F>(component);
    alignas(64) T relative[narrow];
    for (int lane = 0; lane < narrow; ++lane) relative[lane] = static_cast<T>(from[lane] - reference);
    return sphk::load<NarrowPack>(relative);
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
};

}  // namespace sphk
