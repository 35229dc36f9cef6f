// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/example.hpp"

#include <cmath>
#include <numeric>

namespace sphk {

namespace {

Field field(const char* name, int components, UnitExponents units, std::size_t n, double offset, int dimension) {
  Field f{name, std::string("Example of ") + name, units, components, {}};
  f.values.assign(n * static_cast<std::size_t>(components), 0.0);
  const int used = components == 1 ? 1 : dimension;
  for (std::size_t i = 0; i < f.values.size(); ++i)
    if (static_cast<int>(i) % components < used)
      f.values[i] = offset + 0.5 + 0.49 * std::sin(1.7 * static_cast<double>(i) + offset);
  return f;
}

}  // namespace

Snapshot example_snapshot(int dimension, std::size_t n) {
  Snapshot s;
  s.dimension = dimension;
  s.time = 1.0 / 3;
  s.step = 17;
  s.gamma = 1.4;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    s.box.lower[k] = 0.2 - 0.1 * static_cast<double>(k);
    s.box.size[k] = 1.5;
    s.box.periodic[k] = true;
  }
  s.id.resize(n);
  std::iota(s.id.begin(), s.id.end(), std::uint64_t{1} << 40);  // more than 32 bits
  const double D = dimension;
  s.fields = {field("Coordinates", 3, {1, 0, 0}, n, 0, dimension),
              field("Velocities", 3, {1, 0, -1}, n, -2, dimension),
              field("Masses", 1, {0, 1, 0}, n, 1, dimension),
              field("Densities", 1, {-D, 1, 0}, n, 2, dimension),
              field("InternalEnergies", 1, {2, 0, -2}, n, 3, dimension),
              field("Pressures", 1, {2 - D, 1, -2}, n, 4, dimension),
              field("SmoothingLength", 1, {1, 0, 0}, n, 5, dimension),
              field("Entropies", 1, {2 + 0.4 * D, -0.4, -2}, n, 6, dimension)};
  return s;
}

SnapshotInfo example_info() {
  SnapshotInfo info;
  info.scene = "example";
  info.backend = "Serial";
  info.version = "0.1.0";
  info.git_revision = "none";
  info.scene_text = "scene = \"example\"\n";
  info.settings.declare({"sph.kernel", std::string("cs"), "", {}});
  info.settings.declare({"time.courant", 0.4, "", {}});
  return info;
}

hdf5::File ExampleIc::make() const {
  auto file = hdf5::File::create();
  auto header = file.create_group("Header");
  header.set("BoxSize", 2.0);
  header.set("NumPart_ThisFile", std::vector<std::int32_t>{static_cast<std::int32_t>(n), 0, 0, 0, 0, 0});
  auto gas = file.create_group("PartType0");
  const auto c = static_cast<std::size_t>(columns);
  std::vector<double> x(n * c), v(n * c), m(n), u(n);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i) / 64, v[i] = static_cast<double>(i) / 8;
  for (std::size_t i = 0; i < n; ++i) m[i] = 1 + static_cast<double>(i) / 4, u[i] = 2 + static_cast<double>(i) / 2;
  gas.write("Coordinates", x, static_cast<hsize_t>(columns));
  gas.write("Velocities", v, static_cast<hsize_t>(columns));
  gas.write("Masses", m);
  gas.write("InternalEnergy", u);
  return file;
}

std::string input_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

testing::AssertionResult mentions(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos)
      return testing::AssertionFailure() << "\"" << text << "\" does not mention \"" << part << "\"";
  return testing::AssertionSuccess();
}

}  // namespace sphk
