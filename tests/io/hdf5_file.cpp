// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/hdf5_file.hpp"

#include <fstream>

#include "tests/io/example.hpp"

namespace sphk::hdf5 {
namespace {

using Hdf5File = Scratch;

TEST_F(Hdf5File, AttributesComeBackAsTheyWere) {
  auto made = File::create();
  made.set("text", "some words");
  made.set("empty", "");
  made.set("number", 1.5);
  made.set("whole", std::vector<std::int64_t>{1, -2, 3});
  made.save(file("a.hdf5"));
  const auto read = File::open(file("a.hdf5"));
  EXPECT_EQ(read.text("text"), "some words");
  EXPECT_EQ(read.text("empty"), "");
  EXPECT_EQ(read.numbers("number"), std::vector<double>{1.5});
  EXPECT_EQ(read.numbers("whole"), (std::vector<double>{1, -2, 3}));
  EXPECT_TRUE(read.has_attribute("text"));
  EXPECT_FALSE(read.has_attribute("texts"));
}

TEST_F(Hdf5File, DatasetsKeepTypeShapeAndValues) {
  auto made = File::create();
  made.write("table", std::vector<std::uint64_t>{~0ull, 1, 2, 3, 4, 5}, 3, true);
  made.write("nothing", std::vector<double>{}, 3, true);
  made.create_group("group").link("again", "/table");
  made.save(file("a.hdf5"));
  const auto read = File::open(file("a.hdf5"));
  const Dataset table = read.dataset("table");
  EXPECT_EQ(table.shape(), (std::vector<hsize_t>{2, 3}));
  EXPECT_TRUE(table.is_integer());
  EXPECT_FALSE(table.is_signed());
  EXPECT_EQ(table.read<std::uint64_t>(), (std::vector<std::uint64_t>{~0ull, 1, 2, 3, 4, 5}));
  EXPECT_EQ(read.dataset("nothing").shape(), (std::vector<hsize_t>{0, 3}));
  EXPECT_TRUE(read.dataset("nothing").read<double>().empty());
  EXPECT_EQ(read.dataset("group/again").address(), table.address());
  EXPECT_EQ(read.members(), (std::vector<std::string>{"group", "nothing", "table"}));
}

/// A new file takes its name when it is saved; one that is not leaves nothing.
TEST_F(Hdf5File, ANewFileReplacesTheOldOneWhenItIsSaved) {
  const std::vector<double> values(100000, 1.5);
  for (const bool saved : {false, true}) {
    std::ofstream(file("a.hdf5")) << "old";
    {
      auto made = File::replacing(file("a.hdf5"));
      made.write("values", values);
      EXPECT_EQ(std::filesystem::file_size(file("a.hdf5")), 3u);
      if (saved) made.save();
    }
    EXPECT_EQ(std::filesystem::file_size(file("a.hdf5")) > 3, saved);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
  }
  EXPECT_EQ(File::open(file("a.hdf5")).dataset("values").read<double>(), values);
}

TEST_F(Hdf5File, ARehearsedOneHasTheSizeOfTheFile) {
  const auto fill = [](File& made) {
    made.set("text", "some words");
    Group group = made.create_group("group");
    for (int k = 0; k < 20; ++k)
      group.write("values " + std::to_string(k), std::vector<double>(5000 * k, 1.5), 0, k == 7);
  };
  auto made = File::replacing(file("a.hdf5")), rehearsed = File::rehearsed();
  fill(made), fill(rehearsed);
  made.save();
  EXPECT_EQ(rehearsed.bytes(), static_cast<double>(std::filesystem::file_size(file("a.hdf5"))));
}

TEST_F(Hdf5File, ErrorsNameFileAndObjectAndPrintNothing) {
  auto made = File::create();
  made.create_group("group").set("word", "x");
  made.save(file("a.hdf5"));
  testing::internal::CaptureStderr();
  const auto read = File::open(file("a.hdf5"));
  EXPECT_TRUE(mentions(input_error([&] { read.dataset("none"); }), {"a.hdf5", "\"none\"", "HDF5:"}));
  EXPECT_TRUE(mentions(input_error([&] { read.group("group").numbers("word"); }), {"/group", "\"word\"", "number"}));
  EXPECT_TRUE(mentions(input_error([&] { read.group("group").text("other"); }), {"/group", "\"other\""}));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Hdf5File, EqualContentsGiveEqualBytes) {
  for (const char* name : {"a.hdf5", "b.hdf5"}) {
    auto made = File::create();
    made.create_group("g").write("x", std::vector<double>{1, 2, 3});
    made.save(file(name));
  }
  const auto bytes = [&](const char* name) {
    std::ifstream stream(file(name), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  EXPECT_EQ(bytes("a.hdf5"), bytes("b.hdf5"));
}

}  // namespace
}  // namespace sphk::hdf5
