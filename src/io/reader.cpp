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
    if (!file.has("PartType0")) return;
    found_gas_ = true;
    const std::size_t before = gas_.size();
    add_gas(gas_, file.group("PartType0"), header.number_or("MassTable", 0), non_finite_);
    if (!counts.empty() && counts[0] != static_cast<double>(gas_.size() - before))
      throw InputError(
          fmt::format("{}: NumPart_ThisFile says {:.0f} gas particles, PartType0/Coordinates has {}; "
                      "correct the attribute or write the file again",
                      header.where(), counts[0], gas_.size() - before));
  }

  ReadResult finish() {
    if (!found_gas_) throw InputError(where_ + ": there is no gas: no group PartType0; sphk computes nothing else");
    set_dimension();
    set_box();
    fill_gaps();
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
    refuse_other_physics(file, header);
    gas_.time = header.number_or("Time", 0);
    if (!std::isfinite(gas_.time))
      throw InputError(header.where() + ": Time is not a finite number; set the attribute");
    if (file.has("HydroScheme")) {
      const auto gamma = file.group("HydroScheme").numbers_or("Adiabatic index", {});
      if (!gamma.empty() && gamma[0] > 1 && std::isfinite(gamma[0]))
        result_.gamma = gamma[0];
      else if (!gamma.empty())
        remark(fmt::format("the file's adiabatic index {} is not above 1: sph.gamma says which is used", gamma[0]));
    }
    if (!file.has("Units")) remark("there is no Units group: all numbers are taken as code units");
    read_box(file, header);
  }

  void refuse_other_physics(const hdf5::File& file, const hdf5::Group& header) const {
    if (file.has("Cosmology") && file.group("Cosmology").number_or("Cosmological run", 0) != 0)
      throw InputError(where_ +
                       ": the file is in comoving units of a cosmological run, which sphk does not know; "
                       "convert it to physical units and set the attribute \"Cosmological run\" of Cosmology "
                       "to 0");
    if (header.number_or("Flag_Entropy_ICs", 0) != 0)
      throw InputError(header.where() +
                       ": Flag_Entropy_ICs says that InternalEnergy holds entropies; write specific "
                       "thermal energies and set the flag to 0");
  }

  void read_box(const hdf5::File& file, const hdf5::Group& header) {
    Box& box = gas_.box;
    if (file.has("sphk")) {
      const hdf5::Group own = file.group("sphk");
      const auto lower = own.numbers("BoxLower"), size = own.numbers("BoxSize"), periodic = own.numbers("Periodic");
      if (lower.size() != 3 || size.size() != 3 || periodic.size() != 3)
        throw InputError(own.where() + ": BoxLower, BoxSize and Periodic must have 3 values; write the file again");
      for (std::size_t k = 0; k < 3; ++k) {
        box.lower[k] = lower[k];
        box.size[k] = size[k];
        box.periodic[k] = periodic[k] != 0;
      }
      dimension_ = own.number_or("Dimension", 3);
      result_.own_snapshot = true;
      return;
    }
    if (header.has_attribute("Dimension")) dimension_ = header.number_or("Dimension", 3);
    box_size_ = header.numbers_or("BoxSize", {});
    for (const double size : box_size_)
      if (!(size >= 0 && std::isfinite(size)))
        throw InputError(fmt::format("{}: BoxSize has the value {}; set it to the length of the box, or to 0 for none",
                                     header.where(), size));
    if (file.has("RuntimePars") && file.group("RuntimePars").has_attribute("PeriodicBoundariesOn"))
      periodic_ = file.group("RuntimePars").number_or("PeriodicBoundariesOn", 1) != 0;
    const double redshift = header.number_or("Redshift", 0);
    if (redshift != 0)
      remark(fmt::format("Redshift is {}: it is not used, the numbers are taken as physical", redshift));
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
    const double wanted = dimension_.value_or(std::min(gas_.dimension, box_size_.size() == 2 ? 2 : 3));
    if (!(wanted == 1 || wanted == 2 || wanted == 3) || wanted > gas_.dimension)
      throw InputError(fmt::format("{}: Dimension is {}, but Coordinates has {} columns; they must agree", where_,
                                   wanted, gas_.dimension));
    const int dimension = gas_.dimension = static_cast<int>(wanted);
    std::size_t dropped = 0;
    for (std::size_t i = 0; i < gas_.size(); ++i) {
      bool changed = false;
      for (auto k = static_cast<std::size_t>(dimension); k < 3; ++k) {
        changed |= gas_.x[i][k] != 0 || gas_.v[i][k] != 0;
        gas_.x[i][k] = gas_.v[i][k] = 0;
      }
      dropped += changed;
    }
    if (dropped)
      remark(fmt::format("{} rows of Coordinates and Velocities were not 0 beyond {} dimensions and now are", dropped,
                         dimension));
    const auto last = static_cast<std::size_t>(dimension - 1);
    const auto differs = [last](const Array3& a, const Array3& b) { return a[last] != b[last]; };
    if (last > 0 && gas_.x.size() > 1 && std::ranges::adjacent_find(gas_.x, differs) == gas_.x.end())
      remark(
          fmt::format("all particles have the same {}: gas that is meant to be {}D needs the attribute Dimension of "
                      "Header set to {}",
                      "xyz"[last], last, last));
  }

  void set_box() {
    if (result_.own_snapshot) return;
    Box& box = gas_.box;
    std::string made;
    for (std::size_t k = 0; k < static_cast<std::size_t>(gas_.dimension); ++k) {
      const double size = box_size_.empty() ? 0 : box_size_[std::min(k, box_size_.size() - 1)];
      box.periodic[k] = size > 0 && periodic_.value_or(true);
      if (size > 0) {
        box.size[k] = size;
      } else if (!gas_.x.empty()) {
        const auto [low, high] = std::minmax_element(gas_.x.begin(), gas_.x.end(),
                                                     [k](const Array3& a, const Array3& b) { return a[k] < b[k]; });
        box.lower[k] = (*low)[k];
        box.size[k] = (*high)[k] > (*low)[k] ? (*high)[k] - (*low)[k] : 1;
        made += "xyz"[k];
      }
    }
    if (!made.empty())
      remark(fmt::format("there is no BoxSize along {}: taken as open, as wide as the particles", made));
    else if (!periodic_)
      remark("the file does not say whether the box is periodic: taken as periodic");
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
    if (!result_.own_snapshot) remark("smoothing lengths are taken as a first guess of the support radius");
    if (unknown > 0) remark(fmt::format("smoothing lengths of 0 ({} of {}) will be found", unknown, n));
  }

  void remark(std::string_view text) { result_.remarks.emplace_back(text); }

  NonFinite non_finite_;
  ReadResult result_;
  ParticleSet& gas_ = result_.particles;  ///< in the dimension of the file's rows, until it is set
  bool first_ = true, found_gas_ = false;
  std::string where_;  ///< of the first part
  std::optional<double> dimension_;
  std::vector<double> box_size_;
  std::optional<bool> periodic_;
  std::map<int, double> others_;  ///< particles of each type that is not gas
};

}  // namespace

ReadResult read_particles(const std::filesystem::path& path, NonFinite non_finite) {
  Reader reader(non_finite);
  for (const std::filesystem::path& part : file_parts(path)) reader.add_part(hdf5::File::open(part));
  return reader.finish();
}

}  // namespace sphk
