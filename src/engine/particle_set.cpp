// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/particle_set.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sphk {

namespace {
auto find(std::vector<Field>& fields, const std::string& name) {
  return std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
}
}  // namespace

std::vector<int> tags_by_id(const ParticleSet& particles) {
  std::vector<std::size_t> order(particles.tag.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!particles.id.empty())
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return particles.id[a] < particles.id[b]; });
  std::vector<int> tags(order.size());
  std::ranges::transform(order, tags.begin(), [&](std::size_t i) { return particles.tag[i]; });
  return tags;
}

Field phase_tags(const ParticleSet& particles) {
  const std::vector<int> tags = tags_by_id(particles);
  return {.name = "PhaseTags",
          .description = "Where the gas was at the start",
          .units = {},
          .values = {tags.begin(), tags.end()}};
}

const Field& Snapshot::field(const std::string& name) const {
  const auto it = find(fields, name);
  if (it == fields.end()) throw std::out_of_range("the snapshot has no field \"" + name + "\"");
  it->fill();
  return *it;
}

void Snapshot::let_go() const {
  for (Field& field : fields) field.let_go();
}

bool Snapshot::has(const std::string& name) const {
  return find(fields, name) != fields.end();
}

}  // namespace sphk
