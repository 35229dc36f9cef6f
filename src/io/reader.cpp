// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "src/engine/errors.hpp"
#include "src/io/file_parts.hpp"
#include "src/io/gas_datasets.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/layouts.hpp"
#include "src/io/readers_box.hpp"

namespace sphk {

namespace {

/// Collects the gas of all parts of one file set.
class Reader {
 public:
  explicit Reader(NonFinite non_finite) : non_finite_(non_finite) {}

  void add_part(const hdf5::File& file) {
    const hdf5::Group header = file.group("Header");
    if (first_) read_first(file);
    first_ = false;
    const auto counts = header.numbers_or("NumPart_ThisFile", {});
    count_other_types(file, counts);
    const std::size_t before = gas_.size();
    if (file.has("PartType0")) {
      found_gas_ = true;
      add_gas(gas_, file.group("PartType0"), header.number_or("MassTable", 0), non_finite_);
      undo_shift(file, std::span(gas_.x).subspan(before));
    }
    if (!counts.empty()) require_count(header.where(), "NumPart_ThisFile", counts[0], gas_.size() - before);
  }

  ReadResult finish() {
    if (!found_gas_) throw InputError(where_ + ": there is no gas: no group PartType0; sphk computes nothing else");
    if (total_) require_count(where_ + ": /Header", "NumPart_Total", *total_, gas_.size());
    set_dimension();
    set_box();
    fill_gaps();
    if (!gas_.u.empty() && std::ranges::all_of(gas_.u, [](double u) { return u == 0; }))
      remark("all specific thermal energies are 0: the gas is cold, unless ic.pressure sets a pressure");
    for (const auto& [type, count] : others_)
      remark(
          fmt::format("{:.0f} particles of PartType{} are left out: sphk computes gas (PartType0) only", count, type));
    if (gas_.alpha.size() != gas_.size()) gas_.alpha.clear();
    return std::move(result_);
  }

 private:
  void read_first(const hdf5::File& file) {
    const hdf5::Group header = file.group("Header");
    where_ = file.where();
    if (header.number_or("Flag_Entropy_ICs", 0) != 0)
      throw InputError(header.where() +
                       ": Flag_Entropy_ICs says that InternalEnergy holds entropies; write specific "
                       "thermal energies and set the flag to 0");
    gas_.time = header.number_or("Time", 0);
    if (!std::isfinite(gas_.time))
      throw InputError(header.where() + ": Time is not a finite number; set the attribute");
    read_total(header);
    facts_ = facts_of(file);
    result_.units = facts_.units;
    if (!result_.units && !file.has("sphk"))
      remark("the file does not say its units: all numbers are taken as code units");
    read_gamma();
    read_box(file, header);
  }

  void read_gamma() {
    if (!facts_.gamma)
      remark("the file does not say its adiabatic index: sph.gamma says which is used");
    else if (*facts_.gamma > 1 && std::isfinite(*facts_.gamma))
      result_.gamma = facts_.gamma;
    else
      remark(fmt::format("the file's adiabatic index {} is not above 1: sph.gamma says which is used", *facts_.gamma));
  }

  /// Of all parts; refused here, before anything is read, where no run could count them.
  void read_total(const hdf5::Group& header) {
    const auto low = header.numbers_or("NumPart_Total", {}), high = header.numbers_or("NumPart_Total_HighWord", {0});
    if (low.empty()) return;
    total_ = low[0] + std::exp2(32) * high[0];
    if (*total_ > most_particles)
      throw InputError(fmt::format("{}: {:.0f} gas particles are more than sphk can count, {}; take fewer",
                                   header.where(), *total_, most_particles));
  }

  static void require_count(const std::string& where, const char* name, double said, std::size_t found) {
    if (said == static_cast<double>(found)) return;
    throw InputError(
        fmt::format("{}: {} says {:.0f} gas particles, PartType0/Coordinates has {}; correct the attribute or write "
                    "the file again",
                    where, name, said, found));
  }

  void read_box(const hdf5::File& file, const hdf5::Group& header) {
    if (file.has("sphk")) return read_own_box(file.group("sphk"));
    dimension_ = facts_.dimension;
    box_size_ = header.numbers_or("BoxSize", {});
    for (const double size : box_size_)
      if (!(size >= 0 && std::isfinite(size)))
        throw InputError(fmt::format("{}: BoxSize has the value {}; set it to the length of the box, or to 0 for none",
                                     header.where(), size));
  }

  void read_own_box(const hdf5::Group& own) {
    const auto lower = own.numbers("BoxLower"), size = own.numbers("BoxSize"), periodic = own.numbers("Periodic");
    if (lower.size() != 3 || size.size() != 3 || periodic.size() != 3)
      throw InputError(own.where() + ": BoxLower, BoxSize and Periodic must have 3 values; write the file again");
    Box& box = gas_.box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = lower[k];
      box.size[k] = size[k];
      box.periodic[k] = periodic[k] != 0;
    }
    dimension_ = own.number_or("Dimension", 3);
    result_.own_snapshot = true;
  }

  void count_other_types(const hdf5::File& file, const std::vector<double>& counts) {
    for (std::size_t type = 1; type < counts.size(); ++type)
      if (counts[type] > 0) others_[static_cast<int>(type)] += counts[type];
    for (const std::string& name : file.members()) {
      if (!name.starts_with("PartType") || name.size() != 9 || name[8] < '1' || name[8] > '9') continue;
      const int type = name[8] - '0';
      if (static_cast<std::size_t>(type) < counts.size() || !file.group(name).has("Coordinates")) continue;
      const auto shape = file.group(name).dataset("Coordinates").shape();
      if (!shape.empty()) others_[type] += static_cast<double>(shape[0]);
    }
  }

  void set_dimension() {
    if (!dimension_ && box_size_.size() == 2) dimension_ = std::min(gas_.dimension, 2);
    const double wanted = dimension_.value_or(gas_.dimension);
    if (!(wanted == 1 || wanted == 2 || wanted == 3) || wanted > gas_.dimension)
      throw InputError(fmt::format("{}: Dimension is {}, but Coordinates has {} columns; they must agree", where_,
                                   wanted, gas_.dimension));
    result_.dimension_said = dimension_.has_value();
    const std::size_t dropped = drop_axes(gas_, static_cast<int>(wanted));
    if (dropped)
      remark(fmt::format("{} rows of Coordinates and Velocities were not 0 beyond {} dimensions and now are", dropped,
                         wanted));
  }

  void set_box() {
    if (result_.own_snapshot) return;
    std::string made;
    for (std::size_t k = 0; k < static_cast<std::size_t>(gas_.dimension); ++k) {
      const double size = (box_size_.empty() ? 0 : box_size_[std::min(k, box_size_.size() - 1)]) * facts_.stretch[k];
      gas_.box.periodic[k] = size > 0 && facts_.periodic.value_or(true);
      if (size > 0)
        gas_.box.size[k] = size;
      else if (!gas_.x.empty())
        made += "xyz"[k];
      if (!gas_.box.periodic[k]) hold_all(k, size > 0);
    }
    if (facts_.periodic.value_or(false) && !made.empty())
      throw InputError(
          fmt::format("{}: /Header: the box is said to be periodic, but there is no BoxSize along {}; set "
                      "it to the length of the box",
                      where_, made));
    if (!made.empty())
      remark(fmt::format("there is no BoxSize along {}: taken as open, as wide as the particles", made));
    else if (!facts_.periodic)
      remark("the file does not say whether the box is periodic: taken as periodic");
  }

  /// An open axis as wide as the particles, and as the box where the file has one.
  void hold_all(std::size_t axis, bool has_size) {
    if (gas_.x.empty()) return;
    const auto [low, high] = std::ranges::minmax(gas_.x, {}, [axis](const Array3& x) { return x[axis]; });
    double& lower = gas_.box.lower[axis];
    double& size = gas_.box.size[axis];
    const double from = has_size ? std::min(lower, low[axis]) : low[axis];
    const double to = has_size ? std::max(lower + size, high[axis]) : high[axis];
    lower = from;
    size = to > from ? to - from : 1;
  }

  void fill_gaps() {
    const std::size_t n = gas_.x.size();
    if (!gas_.id.empty() && gas_.id.size() != n)
      throw InputError(where_ + ": some parts of the file set have ParticleIDs, some have not; add or remove them all");
    if (gas_.id.empty() && n > 0) {
      gas_.id.resize(n);
      std::iota(gas_.id.begin(), gas_.id.end(), std::uint64_t{1});
      remark("there are no ParticleIDs: numbered from 1 in the file's order");
    }
    const auto unknown = std::ranges::count(gas_.h, 0.0);
    if (gas_.h.size() != n || unknown == static_cast<std::ptrdiff_t>(n)) {
      gas_.h.clear();
      remark("there are no smoothing lengths: they will be found");
      return;
    }
    if (!result_.own_snapshot) remark("smoothing lengths are not used: support radii are found anew");
    if (unknown > 0) remark(fmt::format("smoothing lengths of 0 ({} of {}) will be found", unknown, n));
  }

  void remark(std::string_view text) { result_.remarks.emplace_back(text); }

  NonFinite non_finite_;
  ReadResult result_;
  ParticleSet& gas_ = result_.particles;  ///< in the dimension of the file's rows, until it is set
  bool first_ = true, found_gas_ = false;
  std::string where_;  ///< of the first part
  FileFacts facts_;
  std::optional<double> dimension_, total_;
  std::vector<double> box_size_;
  std::map<int, double> others_;  ///< particles of each type that is not gas
};

}  // namespace

std::size_t drop_axes(ParticleSet& gas, int dimension) {
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < gas.size(); ++i) {
    bool changed = false;
    for (auto k = static_cast<std::size_t>(dimension); k < 3; ++k) {
      changed |= gas.x[i][k] != 0 || gas.v[i][k] != 0;
      gas.x[i][k] = gas.v[i][k] = 0;
    }
    dropped += changed;
  }
  for (auto k = static_cast<std::size_t>(dimension); k < 3; ++k)
    gas.box.lower[k] = 0, gas.box.size[k] = 1, gas.box.periodic[k] = false;
  gas.dimension = dimension;
  return dropped;
}

ReadResult read_particles(const std::filesystem::path& path, NonFinite non_finite) {
  Reader reader(non_finite);
  for (const std::filesystem::path& part : file_parts(path)) reader.add_part(hdf5::File::open(part));
  return reader.finish();
}

}  // namespace sphk
