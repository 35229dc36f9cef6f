// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels/cells/tile.hpp"
#include "kernels/core/compress.hpp"

namespace sphk {

/// Which side's support decides that a pair takes part.
enum class Reach {
  gather,    ///< r < h_i
  symmetric  ///< r < max(h_i, h_j)
};

/// One cell of at most 64 particles and the three levels of candidates that its pair loops narrow down: everything near
/// the cell, of that everything near one of its sub-cells, and, where that pays, of that the neighbours of one
/// particle. Lives on one thread of the host; its tiles are team scratch. Only the cell's targets are served: boxes and
/// reaches are theirs.
template <class T, int D, class FieldList, Reach mode, class C>
class TiledCell {
 public:
  using CellTile = Tile<T, D, Union<List<Position>, FieldList>>;
  static constexpr int width = native_lanes<T>;
  using Pack = simd<T, width>;

  static constexpr std::size_t scratch_bytes() { return 3 * CellTile::entries * sizeof(T) + 3 * page; }

  /// `targets`: a bit for each particle of the cell, the first the lowest.
  TiledCell(void* scratch, const CellTree<D>& tree, const C& columns, int cell, TargetMask targets,
            const Sources<C>& sources)
      : tree_(tree), columns_(columns), sources_(sources), cell_(cell), targets_(targets) {
    const auto from = reinterpret_cast<std::uintptr_t>(scratch);
    near_.data = reinterpret_cast<T*>((from + 63) / 64 * 64);
    sub_.data = after(near_.data, page / 2);
    list_.data = after(sub_.data, 3 * page / 4);
    bound_targets();
    const int first = begin() + std::countr_zero(targets), last = begin() + 63 - std::countl_zero(targets);
    const int middle = is_target((first + last) / 2) ? (first + last) / 2 : first;
    frame_ = Frame<D>::of(bounds_, columns, first, middle, last);
  }

  int begin() const { return cell_ * cell_size; }
  int end() const { return sphk::min(begin() + cell_size, tree_.n); }
  bool is_target(int i) const { return targets_ >> (i - begin()) & 1; }
  TargetMask targets() const { return targets_; }
  /// The box and largest support of the targets.
  const Bounds<D>& bounds() const { return bounds_; }
  const Bounds<D>& sub_bounds(int sub_cell) const { return sub_bounds_[sub_cell - first_sub_cell()]; }
  int first_sub_cell() const { return cell_ * fan_out; }
  int last_sub_cell() const { return sphk::min(first_sub_cell() + fan_out, tree_.count(0)); }
  /// Those of the `count` particles from i on, i's bit the lowest.
  TargetMask targets_of(int i, int count) const { return targets_ >> (i - begin()) & ((TargetMask(1) << count) - 1); }
  /// Is there but one target? What is collected are its neighbours, then.
  bool has_one_target() const { return std::has_single_bit(targets_); }
  const Frame<D>& frame() const { return frame_; }
  /// What select() and list() have made.
  const CellTile& candidates() const { return candidates_; }
  const CellTile& neighbours() const { return list_; }

  /// Collects what comes within `reach` of the targets and calls flush(whole) each time the tile is full and at the
  /// end; `whole` says that the tile holds all there is.
  template <class Flush>
  void collect(double reach, Flush&& flush) {
    near_.count = 0;
    reach_ = reach;
    bool whole = true;
    walk(
        sources_.tree, root(sources_.tree), bounds(), [&](const auto& h) { return reach_with(h); },
        [&](int sub_cell, const double* shift) {
          if (near_.count + sub_cell_size > CellTile::capacity - width) {
            whole = false;
            near_.template pad<Pack>(out_of_reach(near_, reach_));
            flush(false);
            near_.count = 0;
          }
          append(sub_cell, shift);
        });
    near_.template pad<Pack>(out_of_reach(near_, reach_));
    flush(whole);
  }

  /// Calls visit(i, tile, from, to) for every target and entries of a tile that hold its neighbours: those of a list of
  /// its own where `listed`, else, block by block, its sub-cell's candidates, in and out of reach. Then, once a
  /// sub-cell is through, done(i); several times where the tile does not hold all there is.
  template <class Visit, class Done>
  void for_each_target(bool listed, Visit&& visit, Done&& done) {
    collect(bounds_.h_max, [&](bool) {
      for (int s = first_sub_cell(); s < last_sub_cell(); ++s) {
        const int first = s * sub_cell_size;
        const TargetMask targets = targets_of(first, sub_cell_size);
        if (targets == 0) continue;
        const bool lists = (!select(s, sub_bounds(s).h_max) || listed) && !has_one_target();
        const int count = candidates_.count, block = lists || has_one_target() ? CellTile::capacity : block_size;
        if (count == 0) continue;
        for (int from = 0; from < count; from += block)
          for_each_of(targets, first, [&](int i) {
            if (lists) list(i);
            visit(i, lists ? list_ : candidates_, from, lists ? list_.count : sphk::min(from + block, count));
          });
        for_each_of(targets, first, done);
      }
    });
  }

  /// Calls visit(j) for packs of the entries [from, to) of a tile as neighbours of i. Whether any of a pack is in reach
  /// is not asked: half of many are, and to ask costs more.
  template <class Visit>
  KOKKOS_FORCEINLINE_FUNCTION static void for_each_pack(const CellTile& tile, int from, int to, const auto& i,
                                                        Visit&& visit) {
    for (int k = from; k < to; k += width) visit(tile.template neighbours<Pack>(k, i.x));
  }

  /// Makes candidates those of the collected ones that come within `reach` of the sub-cell's targets; for one or two
  /// targets that does not pay, and all collected ones stay candidates. Tells whether they are no more than those near
  /// the sub-cell's targets.
  bool select(int sub_cell, double reach) {
    candidates_ = near_;
    const TargetMask targets = targets_of(sub_cell * sub_cell_size, sub_cell_size);
    if (std::popcount(targets) <= 2) return targets << (sub_cell * sub_cell_size - begin()) == targets_;
    const Bounds<D>& b = sub_bounds(sub_cell);
    T centre[D], half[D];
    for (int d = 0; d < D; ++d) {
      const double lo = b.lo[d] - frame_.x[d], hi = b.hi[d] - frame_.x[d];
      centre[d] = static_cast<T>(0.5 * (lo + hi));
      half[d] = static_cast<T>(0.5 * (hi - lo));
    }
    const T* from = near_.data;
    T* to = sub_.data;
    for (int k = 0, n = near_.count; k < n; k += width, from += width) {
      Pack x[D];
      for (int d = 0; d < D; ++d) x[d] = at<Position>(from, d) - Pack(centre[d]);
      Pack reach_of = static_cast<T>(reach);
      if constexpr (mode == Reach::symmetric) reach_of = sphk::max(reach_of, Pack(T(1)) / at<InverseSupport>(from));
      to += copy(from, within(x, half, reach_of), to);
    }
    sub_.count = static_cast<int>(to - sub_.data);
    sub_.template pad<Pack>(out_of_reach(sub_, reach));
    candidates_ = sub_;
    return true;
  }

  /// Makes neighbours() those of the candidates with r < reach from x, or r < h_j where pairs are symmetric.
  void list(const Vec<Pack, D>& x, double reach) {
    const Pack reach2 = static_cast<T>(reach * reach);
    const T* from = candidates_.data;
    T* to = list_.data;
    for (int k = 0, n = candidates_.count; k < n; k += width, from += width) {
      Vec<Pack, D> r_ij;
      for (int d = 0; d < D; ++d) r_ij[d] = x[d] - at<Position>(from, d);
      const Pack r2 = dot(r_ij, r_ij);
      unsigned bits = mask_bits(r2 < reach2);
      if constexpr (mode == Reach::symmetric) {
        const Pack h_inv = at<InverseSupport>(from);
        bits |= mask_bits(r2 * h_inv * h_inv < Pack(T(1)));
      }
      if (bits != 0) to += copy(from, bits, to);
    }
    list_.count = static_cast<int>(to - list_.data);
    list_.template pad<Pack>(out_of_reach(list_, reach));
  }

 private:
  /// Packs of at most a sub-cell, for the particles of one.
  static constexpr int narrow = width < sub_cell_size ? width : sub_cell_size;
  using NarrowPack = simd<T, narrow>;

  /// A load waits for an earlier store whose address has the same low 12 bits: tiles that are made of each other start
  /// far from each other within such a page.
  static constexpr std::size_t page = 4096;
  /// Where a tile starts that follows another one, `apart` bytes further in its page.
  static T* after(T* tile, std::size_t apart) {
    constexpr std::size_t bytes = CellTile::entries * sizeof(T);
    return tile + (bytes + (page + apart - bytes % page) % page) / sizeof(T);
  }
  /// Entries whose rows stay in a host's first cache while the targets of a sub-cell pass over them.
  static constexpr int block_size = 16384 / (CellTile::rows * static_cast<int>(sizeof(T))) / width * width;

  static constexpr unsigned first_lanes(int n) { return n >= 32 ? ~0u : (1u << n) - 1; }

  /// The list of target i.
  void list(int i) {
    Vec<Pack, D> x;
    for (int d = 0; d < D; ++d) x[d] = Pack(static_cast<T>(columns_.template at<Position>(i, d) - frame_.x[d]));
    list(x, columns_.template at<Support>(i));
  }

  /// A pack of a component of field F in a tile, one of whose entries is the first of the pack.
  template <class F>
  static Pack at(const T* first, int component = 0) {
    return sphk::load<Pack>(first + CellTile::template offset<F>(component));
  }
  /// Copies the chosen of a pack of entries; tells how many.
  KOKKOS_FORCEINLINE_FUNCTION static int copy(const T* from, unsigned bits, T* to) {
    const Compress<Pack> chosen(bits);
#pragma GCC unroll 64
    for (int row = 0; row < CellTile::rows; ++row)
      chosen.store(to + row * CellTile::stride, sphk::load<Pack>(from + row * CellTile::stride));
    return chosen.count();
  }

  /// A place along the first axis from which neither `reach` nor the support of the last entry gets to any target.
  T out_of_reach(const CellTile& tile, double reach) const {
    if constexpr (mode == Reach::symmetric)
      if (tile.count > 0)
        reach = sphk::max(reach, 1.0 / static_cast<double>(tile.template row<InverseSupport>()[tile.count - 1]));
    return static_cast<T>(0.5 * (bounds_.hi[0] - bounds_.lo[0]) + 2 * reach);
  }

  template <class P>
  P reach_with(const P& h) const {
    return mode == Reach::symmetric ? sphk::max(P(reach_), h) : P(reach_);
  }

  void bound_targets() {
    bounds_ = tree_.node(1, cell_);
    const bool all = targets_ == all_targets(tree_, cell_);
    if (!all) bounds_ = Bounds<D>::empty();
    for (int s = first_sub_cell(); s < last_sub_cell(); ++s) {
      Bounds<D>& b = sub_bounds_[s - first_sub_cell()];
      b = all ? tree_.node(0, s) : Bounds<D>::empty();
      if (all) continue;
      const int first = s * sub_cell_size;
      for_each_of(targets_of(first, sub_cell_size), first, [&](int i) { b.include(point(columns_, i)); });
      bounds_.include(b);
    }
  }

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

  /// Appends the particles of a sub-cell that come within reach of the targets.
  void append(int sub_cell, const double* shift) {
    const Frame<D> image = frame_.shifted(shift);
    T half[D];
    for (int d = 0; d < D; ++d) half[d] = static_cast<T>(0.5 * (bounds_.hi[d] - bounds_.lo[d]));
    const int j0 = sub_cell * sub_cell_size, n = sphk::min(sub_cell_size, sources_.tree.n - j0);
    T* to = near_.data + near_.count;
    for (int k = 0; k < n; k += narrow) {
      NarrowPack x[D];
      for (int d = 0; d < D; ++d) x[d] = load_relative_pack<Position>(d, image, j0 + k);
      NarrowPack reach_of = static_cast<T>(reach_);
      if constexpr (mode == Reach::symmetric)
        reach_of = sphk::max(reach_of, NarrowPack(T(1)) / load_relative_pack<InverseSupport>(0, image, j0 + k));
      const Compress<NarrowPack> chosen(within(x, half, reach_of) & first_lanes(n - k));
      if (chosen.count() == 0) continue;
      for (int d = 0; d < D; ++d) chosen.store(to + CellTile::template offset<Position>(d), x[d]);
      for_each_type(FieldList{}, [&]<class F>() {
        if constexpr (!std::is_same_v<F, Position>)
          for (int c = 0; c < components<F, D>; ++c)
            chosen.store(to + CellTile::template offset<F>(c), load_relative_pack<F>(c, image, j0 + k));
      });
      to += chosen.count();
    }
    near_.count = static_cast<int>(to - near_.data);
  }

  /// A component of field F of the particles from j on, in T and relative to the frame.
  template <class F>
  NarrowPack load_relative_pack(int component, const Frame<D>& frame, int j) const {
    const double* from = sources_.columns.template row<F>(component) + j;
    const double reference = frame.template reference<F>(component);
    alignas(64) T relative[narrow];
    for (int lane = 0; lane < narrow; ++lane) relative[lane] = static_cast<T>(from[lane] - reference);
    return sphk::load<NarrowPack>(relative);
  }

  const CellTree<D>& tree_;
  const C& columns_;
  Sources<C> sources_;
  int cell_;
  TargetMask targets_;
  Frame<D> frame_;
  Bounds<D> bounds_, sub_bounds_[fan_out];
  double reach_ = 0;
  CellTile near_, sub_, candidates_, list_;
};

}  // namespace sphk
