// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/checkpoint.hpp"

#include <fmt/format.h>

#include <memory>

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
constexpr const char* checksum_name = "Checksum";
constexpr const char* scene_name = "Scene";

/// The sum of a part; that of all parts, in whatever order, is the file's.
std::uint64_t checksum_of(std::string_view name, std::span<const std::uint8_t> bytes) {
  Checksum sum;
  sum.add(name.data(), name.size());
  sum.add(bytes.data(), bytes.size());
  return sum.value();
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
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

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& around,
                      const std::function<void(const TakeBlock&)>& save, Snapshot snapshot, const SnapshotInfo& info) {
  hdf5::File file = hdf5::File::replacing(path);
  write_snapshot(file, std::move(snapshot), info, Compression::none);
  hdf5::Group group = file.group("sphk").create_group(group_name);
  group.set(layout_name, std::int32_t{checkpoint_layout});
  std::uint64_t checksum = checksum_of(scene_name, bytes_of(around.scene));
  const TakeBlock put = [&](const std::string& name, std::span<const std::uint8_t> bytes) {
    group.write(name, bytes);
    checksum += checksum_of(name, bytes);
  };
  save(put);
  put(loop_name, bytes_of(around.loop));
  put(history_name, bytes_of(around.history));
  group.write(checksum_name, std::vector<std::uint64_t>{checksum});
  file.save();
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const auto file = std::make_shared<const hdf5::File>(hdf5::File::open(path));
  if (!file->has("sphk") || !file->group("sphk").has(group_name))
    throw InputError(fmt::format("{} is no checkpoint", path.string()));
  const hdf5::Group group = file->group("sphk").group(group_name);
  require_layout(path, *file, group);
  Checkpoint checkpoint;
  checkpoint.scene = file->group("sphk").text("SceneText");
  std::uint64_t checksum = checksum_of(scene_name, bytes_of(checkpoint.scene));
  for (const std::string& name : group.members()) {
    if (name == checksum_name) continue;
    const std::vector<std::uint8_t> bytes = group.dataset(name).read<std::uint8_t>();
    checksum += checksum_of(name, bytes);
    if (name == loop_name) checkpoint.loop.assign(bytes.begin(), bytes.end());
    if (name == history_name) checkpoint.history.assign(bytes.begin(), bytes.end());
  }
  const auto written = group.dataset(checksum_name).read<std::uint64_t>();
  if (written != std::vector{checksum}) throw InputError(fmt::format("{} is damaged", path.string()));
  checkpoint.simulation = [file](const std::string& name) {
    const hdf5::Group blocks = file->group("sphk").group(group_name);
    if (!blocks.has(name)) throw InputError(fmt::format("the saved state has no \"{}\"", name));
    return blocks.dataset(name).read<std::uint8_t>();
  };
  return checkpoint;
}

}  // namespace sphk
