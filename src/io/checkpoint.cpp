#include "src/io/checkpoint.hpp"

#include <fmt/format.h>

#include "src/engine/checksum.hpp"
#include "src/engine/errors.hpp"
#include "src/io/hdf5_file.hpp"
#include "src/io/snapshot_groups.hpp"

namespace sphk {

namespace {

constexpr const char* group_name = "Checkpoint";
constexpr const char* loop_name = "Loop";

std::uint64_t checksum_of(const Checkpoint& checkpoint) {
  Checksum sum;
  for (const auto& [name, bytes] : checkpoint.state) {
    sum.add(name.data(), name.size());
    sum.add(bytes.data(), bytes.size());
  }
  sum.add(checkpoint.loop.data(), checkpoint.loop.size());
  return sum.value();
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const Snapshot& snapshot,
                      const SnapshotInfo& info) {
  hdf5::File file = snapshot_file(snapshot, info, Compression::none);
  hdf5::Group group = file.group("sphk").create_group(group_name);
  for (const auto& [name, bytes] : checkpoint.state) group.write(name, bytes);
  group.write(loop_name, std::vector<std::uint8_t>(checkpoint.loop.begin(), checkpoint.loop.end()));
  group.write("Checksum", std::vector<std::uint64_t>{checksum_of(checkpoint)});
  file.save(path);
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const hdf5::File file = hdf5::File::open(path);
  if (!file.has("sphk") || !file.group("sphk").has(group_name))
    throw InputError(fmt::format("{} is no checkpoint", path.string()));
  const hdf5::Group group = file.group("sphk").group(group_name);
  Checkpoint checkpoint;
  std::uint64_t checksum = 0;
  for (const std::string& name : group.members()) {
    if (name == "Checksum") {
      const auto values = group.dataset(name).read<std::uint64_t>();
      checksum = values.empty() ? 0 : values[0];
      continue;
    }
    std::vector<std::uint8_t> bytes = group.dataset(name).read<std::uint8_t>();
    if (name == loop_name)
      checkpoint.loop.assign(bytes.begin(), bytes.end());
    else
      checkpoint.state[name] = std::move(bytes);
  }
  if (checksum != checksum_of(checkpoint)) throw InputError(fmt::format("{} is damaged", path.string()));
  return checkpoint;
}

}  // namespace sphk
