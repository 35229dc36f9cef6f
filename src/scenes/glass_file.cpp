#include "src/scenes/glass_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "src/engine/checksum.hpp"

namespace sphk {

namespace {

/// What a file begins with; the positions follow, three doubles each.
struct Header {
  char magic[8] = {'s', 'p', 'h', 'k', 'g', 'l', 's', '2'};
  std::int64_t dimension = 0, counts[3] = {};
  std::uint64_t checksum = 0;  ///< of the positions
};

Header header_of(int dimension, const Counts& counts, const std::vector<Array3>& points) {
  Header header;
  header.dimension = dimension;
  for (int axis = 0; axis < 3; ++axis) header.counts[axis] = counts[axis];
  Checksum sum;
  sum.add(points.data(), points.size() * sizeof(Array3));
  header.checksum = sum.value();
  return header;
}

}  // namespace

std::string glass_file_name(int dimension, const Counts& counts) {
  std::string name = fmt::format("glass-{}d-{}", dimension, counts[0]);
  for (int axis = 1; axis < dimension; ++axis) name += fmt::format("x{}", counts[axis]);
  return name + "-v1.bin";
}

std::optional<std::vector<Array3>> read_glass(const std::filesystem::path& file, int dimension, const Counts& counts) {
  std::ifstream in(file, std::ios::binary);
  Header header;
  std::vector<Array3> points(Block{.dimension = dimension, .counts = counts}.particles());
  in.read(reinterpret_cast<char*>(&header), sizeof(header));
  in.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(Array3)));
  const Header wanted = header_of(dimension, counts, points);
  if (!in || in.peek() != EOF || std::memcmp(&header, &wanted, sizeof(header)) != 0) return std::nullopt;
  return points;
}

void write_glass(const std::filesystem::path& file, int dimension, const Counts& counts,
                 const std::vector<Array3>& points) {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  const std::filesystem::path partial = file.string() + fmt::format(".{}", getpid());
  const Header header = header_of(dimension, counts, points);
  std::ofstream out(partial, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&header), sizeof(header));
  out.write(reinterpret_cast<const char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(Array3)));
  out.close();
  if (out)
    std::filesystem::rename(partial, file, failed);
  else
    std::filesystem::remove(partial, failed);
}

}  // namespace sphk
