// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>

#include "src/engine/errors.hpp"
#include "src/io/atomic_file.hpp"
#include "src/io/disk_driver.hpp"
#include "src/io/hdf5_number.hpp"
#include "src/io/input_file.hpp"

namespace sphk::hdf5 {

namespace {

/// Longest attribute that is read, bytes: a mutilated file may claim any length.
constexpr std::size_t max_attribute_size = std::size_t{1} << 24;

std::string hdf5_reason() {
  std::string reason;
  const auto innermost = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t {
    if (error->desc && *error->desc) *static_cast<std::string*>(text) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, innermost, &reason);
  return reason;
}

[[noreturn]] void refuse(const std::string& reason, const std::string& message) {
  throw InputError(reason.empty() ? message : fmt::format("{} (HDF5: {})", message, reason));
}

/// Why a file cannot be opened, beyond what HDF5 says: another program holds its lock, or its file system has none.
std::string lock_remark(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  const bool locked = flock(file, LOCK_SH | LOCK_NB) != 0;
  close(file);
  return locked ? ": it is locked, by a program that writes it or by a file system without locks; wait for the program "
                  "to end, or set HDF5_USE_FILE_LOCKING=FALSE in the environment"
                : "";
}

void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string name_of(hid_t object, ssize_t (*get)(hid_t, char*, std::size_t)) {
  const ssize_t length = get(object, nullptr, 0);
  if (length <= 0) return {};
  std::string name(static_cast<std::size_t>(length), '\0');
  get(object, name.data(), name.size() + 1);
  return name;
}

Handle string_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);  // null-terminated would cost a last character in some readers
  return type;
}

Handle space(const std::vector<hsize_t>& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose};
}

}  // namespace

void Object::fail(const std::string& what) const {
  const std::string reason = hdf5_reason();  // first: other calls clear HDF5's error stack
  refuse(reason, where() + ": " + what);
}

std::string Object::where() const {
  return fmt::format("{}: {}", name_of(id_.get(), H5Fget_name), name_of(id_.get(), H5Iget_name));
}

std::uint64_t Object::address() const {
  H5O_info_t info{};
  if (H5Oget_info(id_.get(), &info) < 0) fail("its place in the file is unknown");
  return info.addr;
}

bool Object::has_attribute(const std::string& name) const {
  return H5Aexists(id_.get(), name.c_str()) > 0;
}

Handle Object::attribute(const std::string& name) const {
  Handle attribute(H5Aopen(id_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (attribute.get() < 0) fail(fmt::format("there is no attribute \"{}\"", name));
  return attribute;
}

void Object::read_attribute(const std::string& name, const Handle& attribute, hid_t type, void* values) const {
  if (H5Aread(attribute.get(), type, values) < 0) fail(fmt::format("the attribute \"{}\" cannot be read", name));
}

std::vector<double> Object::numbers_or(const std::string& name, std::vector<double> missing) const {
  if (!has_attribute(name)) return missing;
  auto values = numbers(name);
  return values.empty() ? missing : values;
}

std::vector<double> Object::numbers(const std::string& name) const {
  const Handle attribute = this->attribute(name);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  if (!hdf5::is_number(type.get())) fail(fmt::format("the attribute \"{}\" is not a number", name));
  const Handle extent(H5Aget_space(attribute.get()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(extent.get());
  if (count < 0 || static_cast<std::size_t>(count) > max_attribute_size / sizeof(double))
    fail(fmt::format("the attribute \"{}\" has an impossible size", name));
  std::vector<double> values(static_cast<std::size_t>(count));
  if (count > 0) read_attribute(name, attribute, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

bool Object::is_text(const std::string& name) const {
  const Handle type(H5Aget_type(attribute(name).get()), H5Tclose);
  return H5Tget_class(type.get()) == H5T_STRING;
}

std::string Object::text(const std::string& name) const {
  const Handle attribute = this->attribute(name);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Handle extent(H5Aget_space(attribute.get()), H5Sclose);
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Sget_simple_extent_npoints(extent.get()) != 1 ||
      size > max_attribute_size)
    fail(fmt::format("the attribute \"{}\" is not one string", name));
  if (H5Tis_variable_str(type.get()) > 0) {
    char* chars = nullptr;
    read_attribute(name, attribute, type.get(), &chars);
    if (!chars) fail(fmt::format("the attribute \"{}\" cannot be read", name));
    std::string value(chars);
    H5free_memory(chars);
    return value;
  }
  std::string value(size, '\0');
  read_attribute(name, attribute, type.get(), value.data());
  value.resize(std::min(size, value.find('\0')));
  return value;
}

void Object::set(const std::string& name, std::string_view text) {
  const Handle type = string_type(text.size());
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  write_attribute(name, type.get(), {H5Screate(H5S_SCALAR), H5Sclose}, padded.data());
}

void Object::set_numbers(const std::string& name, hid_t type, const void* values, std::size_t count) {
  write_attribute(name, type, space({count}), values);
}

void Object::write_attribute(const std::string& name, hid_t type, const Handle& extent, const void* values) {
  const Handle attribute(H5Acreate2(id_.get(), name.c_str(), type, extent.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (attribute.get() < 0 || H5Awrite(attribute.get(), type, values) < 0)
    fail(fmt::format("the attribute \"{}\" cannot be written", name));
}

bool Dataset::is_number() const {
  return hdf5::is_number(type().get());
}

std::vector<hsize_t> Dataset::shape() const {
  const Handle extent(H5Dget_space(id_.get()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(extent.get());
  if (rank < 0) fail("its shape cannot be read");
  std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(extent.get(), dims.data(), nullptr);
  return dims;
}

std::filesystem::path Dataset::file() const {
  return name_of(id_.get(), H5Fget_name);
}

std::size_t Dataset::size() const {
  std::size_t count = 1;
  for (const hsize_t rows : shape()) count *= rows;
  return count;
}

void Dataset::read_into(hid_t type, void* values) const {
  if (H5Dread(id_.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    fail("it cannot be read; the file is damaged: copy or write it again");
}

bool Group::has(const std::string& name) const {
  return H5Lexists(id_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Group::members() const {
  std::vector<std::string> names;
  hsize_t position = 0;
  const auto append = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  if (H5Literate(id_.get(), H5_INDEX_NAME, H5_ITER_INC, &position, append, &names) < 0)
    fail("its members cannot be listed");
  return names;
}

Group Group::group(const std::string& name) const {
  Handle id(H5Gopen2(id_.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (id.get() < 0) fail(fmt::format("there is no group \"{}\"", name));
  return Group(std::move(id));
}

Group Group::create_group(const std::string& name) {
  Handle id(H5Gcreate2(id_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  if (id.get() < 0) fail(fmt::format("the group \"{}\" cannot be made", name));
  return Group(std::move(id));
}

Dataset Group::dataset(const std::string& name) const {
  Handle id(H5Dopen2(id_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (id.get() < 0) fail(fmt::format("there is no dataset \"{}\"", name));
  return Dataset(std::move(id));
}

Dataset Group::write_dataset(const std::string& name, hid_t type, const void* values, hsize_t rows, hsize_t columns,
                             bool compressed) {
  constexpr hsize_t rows_per_chunk = 1 << 16;
  constexpr unsigned gzip_level = 4;
  std::vector<hsize_t> shape{rows};
  if (columns) shape.push_back(columns);
  const Handle extent = space(shape);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);  // equal runs give equal bytes
  if (compressed && rows > 0) {
    std::vector<hsize_t> chunk = shape;
    chunk[0] = std::min(rows, rows_per_chunk);
    H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(properties.get());
    H5Pset_deflate(properties.get(), gzip_level);
  }
  Handle id(H5Dcreate2(id_.get(), name.c_str(), type, extent.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            H5Dclose);
  if (id.get() < 0 || (rows > 0 && H5Dwrite(id.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0))
    fail(fmt::format("the dataset \"{}\" cannot be written", name));
  return Dataset(std::move(id));
}

void Group::link(const std::string& name, const std::string& path) {
  if (H5Lcreate_hard(id_.get(), path.c_str(), id_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0)
    fail(fmt::format("\"{}\" cannot be made a link to \"{}\"", name, path));
}

/// Where a new file goes: to the disk, or to memory of the system's.
struct File::Output {
  std::optional<NewFile> disk;
  Target target;
  ~Output() {
    if (!disk) close(target.file);
  }
};

File::File(Handle id, std::unique_ptr<Output> output) : Group(std::move(id)), output_(std::move(output)) {}

File::File(File&& other) noexcept = default;

File::~File() {
  id_ = Handle();  // HDF5 writes what it has left before its target goes
}

File File::created(const std::string& name, std::unique_ptr<Output> output) {
  silence();
  const Handle access(access_to(output->target), H5Pclose);
  Handle id(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
  if (id.get() < 0) refuse(hdf5_reason(), name + ": no HDF5 file can be made");
  return File(std::move(id), std::move(output));
}

File File::replacing(const std::filesystem::path& path) {
  auto output = std::make_unique<Output>();
  output->target.file = output->disk.emplace(path).descriptor();
  return created(path.string(), std::move(output));
}

File File::in_memory(bool drops_values) {
  auto output = std::make_unique<Output>();
  output->target = {.file = memfd_create("HDF5 file", MFD_CLOEXEC), .drops_values = drops_values};
  return created("file in memory", std::move(output));
}

File File::create() {
  return in_memory(false);
}

File File::rehearsed() {
  return in_memory(true);
}

File File::open(const std::filesystem::path& path) {
  silence();
  require_file(path);
  Handle id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (id.get() < 0) {
    const std::string reason = hdf5_reason(), locked = lock_remark(path);
    refuse(reason,
           path.string() + (locked.empty() ? ": this is no readable HDF5 file; copy or write it anew" : locked));
  }
  return File(std::move(id), nullptr);
}

double File::bytes() const {
  hsize_t size = 0;
  if (H5Fflush(id_.get(), H5F_SCOPE_LOCAL) < 0 || H5Fget_filesize(id_.get(), &size) < 0) fail("its size cannot be had");
  return static_cast<double>(size);
}

std::size_t File::finish(const NewFile& file) const {
  const double size = bytes();
  const Target& target = output_->target;
  if (target.error != 0) file.fail(size, target.error);
  if (ftruncate(target.file, static_cast<off_t>(size)) != 0) file.fail(size, errno);
  return static_cast<std::size_t>(size);
}

void File::save() const {
  finish(*output_->disk);
  output_->disk->complete();
}

void File::save(const std::filesystem::path& path) const {
  NewFile copy(path);
  const auto size = static_cast<off_t>(finish(copy));
  for (off_t moved = 0; moved < size;)  // sendfile counts on
    if (sendfile(copy.descriptor(), output_->target.file, &moved, static_cast<std::size_t>(size - moved)) <= 0)
      copy.fail(static_cast<double>(size), errno);
  copy.complete();
}

}  // namespace sphk::hdf5
