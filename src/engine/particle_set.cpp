#include "src/engine/particle_set.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sphk {

namespace {
auto find(const std::vector<Field>& fields, const std::string& name) {
  return std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
}
}  // namespace

Field phase_tags(const ParticleSet& particles) {
  Field field{.name = "PhaseTags", .description = "Where the gas was at the start", .units = {}, .values = {}};
  std::vector<std::size_t> order(particles.tag.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!particles.id.empty())
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return particles.id[a] < particles.id[b]; });
  for (const std::size_t i : order) field.values.push_back(particles.tag[i]);
  return field;
}

const Field& Snapshot::field(const std::string& name) const {
  const auto it = find(fields, name);
  if (it == fields.end()) throw std::out_of_range("the snapshot has no field \"" + name + "\"");
  return *it;
}

bool Snapshot::has(const std::string& name) const {
  return find(fields, name) != fields.end();
}

}  // namespace sphk
