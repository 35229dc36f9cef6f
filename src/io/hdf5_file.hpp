// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#define H5_USE_110_API  // HDF5 1.12 and newer then offer the functions of 1.10, which Debian 12 has
#include <hdf5.h>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphk {
class NewFile;
}

/// A thin owner of HDF5's C API: only what snapshots need. Every failure is an InputError that names the file, the
/// object and HDF5's own reason; HDF5 itself prints nothing.
namespace sphk::hdf5 {

template <class T>
concept Number = std::integral<T> || std::floating_point<T>;

/// Owns one HDF5 identifier of any kind.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// The native HDF5 type of T.
template <Number T>
hid_t native_type() {
  if constexpr (std::floating_point<T>)
    return sizeof(T) == 4 ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
  else if constexpr (sizeof(T) == 1)
    return std::signed_integral<T> ? H5T_NATIVE_INT8 : H5T_NATIVE_UINT8;
  else if constexpr (sizeof(T) == 2)
    return std::signed_integral<T> ? H5T_NATIVE_INT16 : H5T_NATIVE_UINT16;
  else if constexpr (sizeof(T) == 4)
    return std::signed_integral<T> ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT32;
  else
    return std::signed_integral<T> ? H5T_NATIVE_INT64 : H5T_NATIVE_UINT64;
}

/// Anything that carries attributes: a group (the file's root included) or a dataset.
class Object {
 public:
  bool has_attribute(const std::string& name) const;
  /// All numbers of an attribute, scalar or array, of any numeric type.
  std::vector<double> numbers(const std::string& name) const;
  /// The same, or its first number, of an attribute that may be missing or empty.
  std::vector<double> numbers_or(const std::string& name, std::vector<double> missing) const;
  double number_or(const std::string& name, double missing) const { return numbers_or(name, {missing})[0]; }
  bool is_text(const std::string& name) const;
  /// A string attribute of fixed or variable length, without padding.
  std::string text(const std::string& name) const;

  /// A string of fixed length, as C and every reader has it.
  void set(const std::string& name, std::string_view text);
  void set(const std::string& name, const char* text) { set(name, std::string_view(text)); }
  /// A one-dimensional array; one number is an array of one element.
  template <Number T>
  void set(const std::string& name, const std::vector<T>& values) {
    set_numbers(name, native_type<T>(), values.data(), values.size());
  }
  template <Number T>
  void set(const std::string& name, T value) {
    set_numbers(name, native_type<T>(), &value, 1);
  }

  /// Where the object lies in the file: equal for hard links to the same one.
  std::uint64_t address() const;
  /// "FILE: object", to begin a message with.
  std::string where() const;

 protected:
  explicit Object(Handle id) : id_(std::move(id)) {}
  [[noreturn]] void fail(const std::string& what) const;
  Handle id_;

 private:
  Handle attribute(const std::string& name) const;
  void read_attribute(const std::string& name, const Handle& attribute, hid_t type, void* values) const;
  void write_attribute(const std::string& name, hid_t type, const Handle& extent, const void* values);
  void set_numbers(const std::string& name, hid_t type, const void* values, std::size_t count);
};

class Dataset : public Object {
 public:
  explicit Dataset(Handle id) : Object(std::move(id)) {}

  std::vector<hsize_t> shape() const;
  bool is_number() const;
  bool is_integer() const { return H5Tget_class(type().get()) == H5T_INTEGER; }
  bool is_signed() const { return H5Tget_sign(type().get()) == H5T_SGN_2; }  ///< of an integer
  /// Whether its data lie in other files, and it says where.
  bool is_virtual() const { return H5Pget_layout(properties().get()) == H5D_VIRTUAL; }
  Handle properties() const { return {H5Dget_create_plist(id_.get()), H5Pclose}; }
  std::filesystem::path file() const;  ///< that it was opened in
  /// Throws InputError where the file does not hold as much as the shape says, or not in a form that can be read.
  void require_stored() const;

  /// All values, row by row, converted to T. Fails when the file does not hold as many as the shape says.
  template <Number T>
  std::vector<T> read() const {
    require_stored();
    std::vector<T> values(size());
    read_into(native_type<T>(), values.data());
    return values;
  }

 private:
  Handle type() const { return {H5Dget_type(id_.get()), H5Tclose}; }
  std::size_t size() const;
  void read_into(hid_t type, void* values) const;
};

class Group : public Object {
 public:
  explicit Group(Handle id) : Object(std::move(id)) {}

  bool has(const std::string& name) const;
  /// Names of all members, in alphabetical order.
  std::vector<std::string> members() const;
  Group group(const std::string& name) const;
  Group create_group(const std::string& name);
  Dataset dataset(const std::string& name) const;

  /// Writes `values`, of shape rows x columns, or one-dimensional when columns is 0; gzip and shuffle if `compressed`.
  template <Number T>
  Dataset write(const std::string& name, const std::vector<T>& values, hsize_t columns = 0, bool compressed = false) {
    return write_dataset(name, native_type<T>(), values.data(), values.size() / (columns ? columns : 1), columns,
                         compressed);
  }

  Dataset write(const std::string& name, std::span<const std::uint8_t> bytes) {
    return write_dataset(name, native_type<std::uint8_t>(), bytes.data(), bytes.size(), 0, false);
  }

  /// Makes `name` a second name of the object at `path`, absolute within the file: a hard link, no copy.
  void link(const std::string& name, const std::string& path);

 private:
  Dataset write_dataset(const std::string& name, hid_t type, const void* values, hsize_t rows, hsize_t columns,
                        bool compressed);
};

/// An open file; its root group is the file itself.
class File : public Group {
 public:
  static File open(const std::filesystem::path& path);
  /// A new file that is to be `path` once it is saved, and grows on the disk; errors as for NewFile.
  static File replacing(const std::filesystem::path& path);
  /// A new file without a name, in memory that is not the process's own.
  static File create();
  /// The same without what its datasets hold, for the size that it would have.
  static File rehearsed();

  File(File&& other) noexcept;
  ~File();
  double bytes() const;
  /// The file is complete: it replaces the one of its name, all or nothing. Throws InputError.
  void save() const;
  /// Writes a file without a name to `path`, all or nothing; errors as for write_atomically.
  void save(const std::filesystem::path& path) const;

 private:
  struct Output;
  File(Handle id, std::unique_ptr<Output> output);
  static File created(const std::string& name, std::unique_ptr<Output> output);
  static File in_memory(bool drops_values);
  /// Everything is handed over to the system; the size of the file. Throws InputError where that failed.
  std::size_t finish(const NewFile& file) const;

  std::unique_ptr<Output> output_;  ///< of a new file
};

}  // namespace sphk::hdf5
