// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/virtual_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "src/engine/errors.hpp"

namespace sphk::hdf5 {

namespace fs = std::filesystem;

namespace {

std::string name_of(hid_t properties, std::size_t part, ssize_t (*get)(hid_t, std::size_t, char*, std::size_t)) {
  const ssize_t length = get(properties, part, nullptr, 0);
  if (length <= 0) return {};
  std::string name(static_cast<std::size_t>(length), '\0');
  get(properties, part, name.data(), name.size() + 1);
  return name;
}

/// Where HDF5 looks for a part: as it is named, in the folders of HDF5_VDS_PREFIX, beside the file that names it.
std::optional<fs::path> find_part(const fs::path& name, const fs::path& file) {
  std::vector<fs::path> places{name};
  const fs::path relative = name.is_absolute() ? name.filename() : name;
  if (const char* folders = std::getenv("HDF5_VDS_PREFIX")) {
    std::istringstream list(folders);
    for (std::string folder; std::getline(list, folder, ':');) places.push_back(fs::path(folder) / relative);
  }
  std::error_code error;
  places.push_back(file.parent_path() / relative);
  places.push_back(fs::canonical(file, error).parent_path() / relative);
  const auto found = std::ranges::find_if(places, [&](const fs::path& place) { return fs::exists(place, error); });
  return found == places.end() ? std::nullopt : std::optional(*found);
}

/// Whether the part's dataset reaches as far as what is taken of it: all of it, as many values as it is mapped to, or a
/// selection, whose far corner is known.
bool holds(const std::vector<hsize_t>& shape, const Handle& taken, hssize_t mapped) {
  if (H5Sget_select_type(taken.get()) == H5S_SEL_ALL) {
    double size = 1;
    for (const hsize_t rows : shape) size *= static_cast<double>(rows);
    return size == static_cast<double>(mapped);
  }
  std::vector<hsize_t> first(shape.size()), last(shape.size());
  return H5Sget_simple_extent_ndims(taken.get()) == static_cast<int>(shape.size()) &&
         H5Sget_select_bounds(taken.get(), first.data(), last.data()) >= 0 &&
         std::ranges::equal(last, shape, std::ranges::less{});
}

/// One part of `dataset`: its file, its dataset there, and that this is as long as it should be.
void require_part(const Dataset& dataset, const fs::path& file, const Handle& properties, std::size_t part,
                  hssize_t mapped) {
  const std::string name = name_of(properties.get(), part, H5Pget_virtual_filename);
  const std::string inside = name_of(properties.get(), part, H5Pget_virtual_dsetname);
  const auto place = name == "." ? file : find_part(name, file);
  if (!place)
    throw InputError(
        fmt::format("{}: the file {}, in which a part of it lies, is missing; put it into the folder of {}",
                    dataset.where(), name, file.string()));
  const Dataset source = File::open(*place).dataset(inside);
  const Handle taken(H5Pget_virtual_srcspace(properties.get(), part), H5Sclose);
  if (source.is_virtual() || !holds(source.shape(), taken, mapped))
    throw InputError(fmt::format(
        "{}: it does not have as many rows as {} takes from it, or they lie in other files again; copy or write "
        "the part again",
        source.where(), dataset.where()));
  source.require_stored();
}

}  // namespace

void require_parts(const Dataset& dataset) {
  const Handle properties = dataset.properties();
  std::size_t parts = 0;
  H5Pget_virtual_count(properties.get(), &parts);
  double wanted = 1, mapped = 0;
  for (const hsize_t rows : dataset.shape()) wanted *= static_cast<double>(rows);
  for (std::size_t part = 0; part < parts; ++part) {
    const Handle place(H5Pget_virtual_vspace(properties.get(), part), H5Sclose);
    const hssize_t points = H5Sget_select_npoints(place.get());
    mapped += static_cast<double>(points);
    require_part(dataset, dataset.file(), properties, part, points);
  }
  if (mapped < wanted)
    throw InputError(fmt::format("{}: its parts hold {:.0f} of its {:.0f} values; write the file that joins them again",
                                 dataset.where(), mapped, wanted));
}

}  // namespace sphk::hdf5
