// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/disk_driver.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace sphk::hdf5 {

namespace {

/// What a file's access list hands to `open`.
struct Access {
  Target* target;
};

/// HDF5's own part comes first.
struct OpenFile {
  H5FD_t own{};
  Target* target;
  haddr_t allocated = 0, end = 0;
};

OpenFile& of(H5FD_t* file) {
  return *reinterpret_cast<OpenFile*>(file);
}
const OpenFile& of(const H5FD_t* file) {
  return *reinterpret_cast<const OpenFile*>(file);
}

/// Moves all bytes by a call such as pwrite; 0, or errno.
template <class Move, class Byte>
int move_all(const Move& move, int file, Byte* bytes, std::size_t size, haddr_t at) {
  while (size > 0) {
    const ssize_t moved = move(file, bytes, size, static_cast<off_t>(at));
    if (moved < 0 && errno == EINTR) continue;
    if (moved <= 0) return moved < 0 ? errno : EIO;
    bytes += moved, size -= static_cast<std::size_t>(moved), at += static_cast<haddr_t>(moved);
  }
  return 0;
}

H5FD_t* open(const char*, unsigned flags, hid_t access, haddr_t) {
  if (!(flags & H5F_ACC_CREAT)) return nullptr;  // HDF5 asks first whether there is one
  const auto* asked = static_cast<const Access*>(H5Pget_driver_info(access));
  return asked ? &(new OpenFile{.target = asked->target})->own : nullptr;
}

herr_t close(H5FD_t* file) {
  delete &of(file);
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  return of(a).target < of(b).target ? -1 : of(a).target > of(b).target;
}

herr_t query(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t allocated(const H5FD_t* file, H5FD_mem_t) {
  return of(file).allocated;
}

herr_t allocate(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  of(file).allocated = end;
  return 0;
}

haddr_t end(const H5FD_t* file, H5FD_mem_t) {
  return of(file).end;
}

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* bytes) {
  std::memset(bytes, 0, size);  // what a failed write has left out, and holes
  move_all(pread, of(file).target->file, static_cast<char*>(bytes), size, at);
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t kind, hid_t, haddr_t at, std::size_t size, const void* bytes) {
  OpenFile& open = of(file);
  Target& target = *open.target;
  open.end = std::max(open.end, at + size);
  if (target.error == 0 && !(target.drops_values && kind == H5FD_MEM_DRAW))
    target.error = move_all(pwrite, target.file, static_cast<const char*>(bytes), size, at);
  return 0;
}

H5FD_class_t driver() {
  H5FD_class_t own{};
#if H5_VERSION_GE(1, 13, 0)
  own.version = H5FD_CLASS_VERSION;
  own.value = static_cast<H5FD_class_value_t>(511);  // from 256 on they are nobody's
#endif
  own.name = "sphk";
  own.maxaddr = (haddr_t{1} << 62) - 1;
  own.fc_degree = H5F_CLOSE_WEAK;
  own.fapl_size = sizeof(Access);
  own.open = open;
  own.close = close;
  own.cmp = compare;
  own.query = query;
  own.get_eoa = allocated;
  own.set_eoa = allocate;
  own.get_eof = end;
  own.read = read;
  own.write = write;
  constexpr H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::ranges::copy(kinds, own.fl_map);
  return own;
}

}  // namespace

hid_t access_to(Target& target) {
  static const H5FD_class_t ours = driver();
  static const hid_t registered = H5FDregister(&ours);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  const Access asked{&target};
  H5Pset_driver(access, registered, &asked);
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);  // nothing of the file outlives it, and so the target
  return access;
}

}  // namespace sphk::hdf5
