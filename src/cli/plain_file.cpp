#include "src/cli/plain_file.hpp"

#include <numeric>
#include <span>

#include "src/io/hdf5_file.hpp"

namespace sphk {

namespace {

void write_vectors(hdf5::Group& group, const char* name, const std::vector<Array3>& rows) {
  std::vector<double> values;
  for (const Array3& row : rows) values.insert(values.end(), row.begin(), row.end());
  group.write(name, values, 3);
}

}  // namespace

void write_plain_file(const std::filesystem::path& path, const ParticleSet& gas) {
  hdf5::File file = hdf5::File::create();
  hdf5::Group header = file.create_group("Header");
  header.set("BoxSize", std::span<const double>(gas.box.size));
  header.set("Dimension", gas.dimension);
  header.set("Time", gas.time);
  file.create_group("RuntimePars").set("PeriodicBoundariesOn", gas.box.periodic[0] ? 1 : 0);
  hdf5::Group part = file.create_group("PartType0");
  write_vectors(part, "Coordinates", gas.x);
  write_vectors(part, "Velocities", gas.v);
  part.write("Masses", gas.m);
  part.write("InternalEnergies", gas.u);
  if (!gas.h.empty()) part.write("SmoothingLengths", gas.h);
  std::vector<std::uint64_t> ids = gas.id;
  if (ids.empty()) ids.resize(gas.size()), std::iota(ids.begin(), ids.end(), std::uint64_t{1});
  part.write("ParticleIDs", ids);
  file.save(path);
}

}  // namespace sphk
