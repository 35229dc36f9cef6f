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
constexpr const char* history_name = "History";
constexpr const char* layout_name = "Layout";

std::uint64_t checksum_of(const Checkpoint& checkpoint) {
  Checksum sum;
  for (const auto& [name, bytes] : checkpoint.state) {
    sum.add(name.data(), name.size());
    sum.add(bytes.data(), bytes.size());
  }
  for (const std::string* text : {&checkpoint.loop, &checkpoint.history, &checkpoint.scene})
    sum.add(text->data(), text->size());
  return sum.value();
}

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

/// Throws InputError where the checkpoint is laid out in another way, before anything of it is taken.
void require_layout(const std::filesystem::path& path, const hdf5::File& file, const hdf5::Group& group) {
  const double layout = group.number_or(layout_name, 0);
  if (layout == checkpoint_layout) return;
  const std::string version = file.has("Code") && file.group("Code").has_attribute("Code Version")
                                  ? " (" + file.group("Code").text("Code Version") + ")"
                                  : "";
  throw InputError(
      fmt::format("its layout is version {} and this sphk reads version {}: go on with the sphk that wrote it{}, or "
                  "start a new run from it as from a snapshot, with sphk run {} --t-end T",
                  layout, checkpoint_layout, version, path.string()));
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::function<Checkpoint()>& make, Snapshot snapshot,
                      const SnapshotInfo& info) {
  hdf5::File file = snapshot_file(std::move(snapshot), info, Compression::none);
  Checkpoint checkpoint = make();
  const std::uint64_t checksum = checksum_of(checkpoint);
  hdf5::Group group = file.group("sphk").create_group(group_name);
  for (auto& [name, bytes] : checkpoint.state) {
    group.write(name, bytes);
    bytes = std::vector<std::uint8_t>();
  }
  group.set(layout_name, std::int32_t{checkpoint_layout});
  group.write(loop_name, bytes_of(checkpoint.loop));
  group.write(history_name, bytes_of(checkpoint.history));
  group.write("Checksum", std::vector<std::uint64_t>{checksum});
  file.save(path);
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const hdf5::File file = hdf5::File::open(path);
  if (!file.has("sphk") || !file.group("sphk").has(group_name))
    throw InputError(fmt::format("{} is no checkpoint", path.string()));
  const hdf5::Group group = file.group("sphk").group(group_name);
  require_layout(path, file, group);
  Checkpoint checkpoint;
  checkpoint.scene = file.group("sphk").text("SceneText");
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
    else if (name == history_name)
      checkpoint.history.assign(bytes.begin(), bytes.end());
    else
      checkpoint.state[name] = std::move(bytes);
  }
  if (checksum != checksum_of(checkpoint)) throw InputError(fmt::format("{} is damaged", path.string()));
  return checkpoint;
}

}  // namespace sphk
