// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace sphk {

/// A shared object that was compiled against this sphk; it stays loaded until the program ends.
class SharedObject {
 public:
  /// Throws InputError where the file is none, or was compiled against another sphk.
  explicit SharedObject(const std::filesystem::path& file);

  /// Throws InputError where there is no function of that name.
  template <class F>
  F* function(const char* name) const {
    return reinterpret_cast<F*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;
  std::filesystem::path file_;
  void* handle_;
};

/// Whether the file is there and one, without loading it: what is loaded stays, whatever becomes of the file.
bool fits_this_build(const std::filesystem::path& file);

}  // namespace sphk
