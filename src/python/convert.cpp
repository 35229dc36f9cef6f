// SPDX-License-Identifier: BSD-3-Clause
#include "src/python/convert.hpp"

namespace sphk::python {

Array array_of(const FieldArray& field) {
  auto* const kept = new KeptMemory{field.memory};
  const nb::capsule owner(kept, [](void* memory) noexcept { delete static_cast<KeptMemory*>(memory); });
  const std::size_t shape[2] = {field.n, field.components};
  const auto row = static_cast<std::int64_t>(field.row_stride),
             component = static_cast<std::int64_t>(field.component_stride);
  const std::int64_t strides[2] = {row, component};
  return {field.data, field.rows ? 2u : 1u, shape, owner, strides};
}

Array array_of(std::vector<double> numbers, std::size_t components, bool rows) {
  const auto kept = std::make_shared<const std::vector<double>>(std::move(numbers));
  return array_of({kept->data(), kept->size() / components, components, components, 1, rows, kept});
}

Array points_of(const std::vector<Array3>& points, int dimension) {
  std::vector<double> numbers;
  numbers.reserve(points.size() * static_cast<std::size_t>(dimension));
  for (const Array3& x : points) numbers.insert(numbers.end(), x.begin(), x.begin() + dimension);
  return array_of(std::move(numbers), static_cast<std::size_t>(dimension), true);
}

}  // namespace sphk::python
