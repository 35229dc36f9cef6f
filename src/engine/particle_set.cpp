#include "src/engine/particle_set.hpp"

#include <algorithm>
#include <stdexcept>

namespace sphk {

namespace {
auto find(const std::vector<Field>& fields, const std::string& name) {
  return std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
}
}  // namespace

const Field& Snapshot::field(const std::string& name) const {
  const auto it = find(fields, name);
  if (it == fields.end()) throw std::out_of_range("the snapshot has no field \"" + name + "\"");
  return *it;
}

bool Snapshot::has(const std::string& name) const {
  return find(fields, name) != fields.end();
}

}  // namespace sphk
