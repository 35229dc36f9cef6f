// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_number.hpp"

namespace sphk::hdf5 {

namespace {

constexpr std::size_t longest_integer = 8, longest_real = 16;         // bytes
constexpr std::size_t longest_exponent = 15, longest_mantissa = 112;  // bits, as in IEEE's quadruple precision

/// `size` bits from `position` on.
struct Bits {
  std::size_t position = 0, size = 0;
  std::size_t end() const { return position + size; }
  bool meet(const Bits& other) const { return position < other.end() && other.position < end(); }
};

/// Bytes in one direction, and significant bits that lie within them.
bool is_laid_out(hid_t type, std::size_t most_bytes) {
  const H5T_order_t order = H5Tget_order(type);
  const std::size_t bytes = H5Tget_size(type), precision = H5Tget_precision(type);
  const int offset = H5Tget_offset(type);
  return (order == H5T_ORDER_LE || order == H5T_ORDER_BE) && bytes >= 1 && bytes <= most_bytes && precision >= 1 &&
         offset >= 0 && static_cast<std::size_t>(offset) + precision <= 8 * bytes;
}

bool is_real(hid_t type) {
  Bits sign{0, 1}, exponent, mantissa;
  if (!is_laid_out(type, longest_real) ||
      H5Tget_fields(type, &sign.position, &exponent.position, &exponent.size, &mantissa.position, &mantissa.size) < 0)
    return false;
  const std::size_t bits = 8 * H5Tget_size(type);
  return exponent.size >= 1 && exponent.size <= longest_exponent && mantissa.size >= 1 &&
         mantissa.size <= longest_mantissa && sign.end() <= bits && exponent.end() <= bits && mantissa.end() <= bits &&
         !sign.meet(exponent) && !sign.meet(mantissa) && !exponent.meet(mantissa) &&
         H5Tget_ebias(type) < std::size_t{1} << exponent.size;
}

}  // namespace

bool is_number(hid_t type) {
  switch (H5Tget_class(type)) {
    case H5T_INTEGER:
      return is_laid_out(type, longest_integer);
    case H5T_FLOAT:
      return is_real(type);
    case H5T_ENUM: {
      const hid_t super = H5Tget_super(type);
      const bool sound = super >= 0 && H5Tget_class(super) == H5T_INTEGER && is_laid_out(super, longest_integer);
      if (super >= 0) H5Tclose(super);
      return sound;
    }
    default:
      return false;
  }
}

}  // namespace sphk::hdf5
