#include "src/engine/host_columns.hpp"

#include <algorithm>
#include <numeric>

namespace sphk {

HostNumbers on_host(const Numbers& numbers) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, numbers);
}

HostRows::HostRows(const Numbers& numbers, int row_length, const Ids& of)
    : order(of.extent(0)), data(on_host(numbers)), stride(static_cast<std::size_t>(row_length)) {
  const auto host_ids = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, of);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return host_ids(a) < host_ids(b); });
  for (const int i : order) ids.push_back(host_ids(i));
}

Field HostRows::field(std::string name, std::string description, UnitExponents units, int components, int row, int rows,
                      int first) const {
  Field out{std::move(name), std::move(description), units, components, {}};
  out.values.assign(order.size() * static_cast<std::size_t>(components), 0.0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int k = 0; k < rows; ++k)
      out.values[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(first + k)] =
          at(static_cast<int>(i), row + k);
  return out;
}

}  // namespace sphk
