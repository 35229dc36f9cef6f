// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/virtual_dataset.hpp"

namespace sphk::hdf5 {

namespace {

/// deflate cannot shrink data by more than this factor (zlib's technical notes: 1032:1). Filters that store the offset
/// from a chunk's least value can, where all values are one.
constexpr double max_deflation = 1032, max_compression = max_deflation * max_deflation;

/// Bytes that a dataset takes in the file: what its header says, but no more than the file has. Only data in other
/// files may be more, those of external storage.
double stored_size(hid_t dataset, hid_t properties) {
  const auto said = static_cast<double>(H5Dget_storage_size(dataset));
  if (H5Pget_external_count(properties) > 0) return said;
  const Handle file(H5Iget_file_id(dataset), H5Fclose);
  hsize_t size = 0;
  return H5Fget_filesize(file.get(), &size) < 0 ? said : std::min(said, static_cast<double>(size));
}

/// By how much filters may have made stored data smaller. Throws InputError naming a filter that this HDF5 lacks.
double most_compression(const std::string& where, hid_t properties) {
  if (H5Pget_layout(properties) != H5D_CHUNKED) return 1;
  double most = max_deflation;
  for (int k = 0; k < H5Pget_nfilters(properties); ++k) {
    char name[64] = "";
    std::size_t values = 0;
    unsigned flags = 0, config = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(properties, static_cast<unsigned>(k), &flags, &values, nullptr, sizeof(name), name, &config);
    if (filter > 0 && H5Zfilter_avail(filter) <= 0)
      throw InputError(
          fmt::format("{}: it is compressed with the filter {} ({}), which this HDF5 does not have; write it with gzip "
                      "or without compression",
                      where, filter, name));
    if (filter == H5Z_FILTER_SCALEOFFSET || filter == H5Z_FILTER_NBIT) most = max_compression;
  }
  return most;
}

}  // namespace

void Dataset::require_stored() const {
  if (!is_number()) fail("it does not hold numbers");
  if (is_virtual()) return require_parts(*this);
  double bytes = static_cast<double>(H5Tget_size(type().get()));
  for (const hsize_t rows : shape()) bytes *= static_cast<double>(rows);
  const Handle created = properties();
  const double stored = stored_size(id_.get(), created.get());
  if (bytes > most_compression(where(), created.get()) * stored)
    fail(
        fmt::format("its shape asks for {:.0f} bytes, but the file holds {:.0f}: the file is damaged or was never "
                    "finished; copy or write it again",
                    bytes, stored));
}

}  // namespace sphk::hdf5
