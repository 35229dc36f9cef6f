// SPDX-License-Identifier: BSD-3-Clause
#include "src/run/toml_file.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

class TomlFile : public testing::Test {
 protected:
  toml::value parse(const std::string& text) {
    std::ofstream(path(), std::ios::binary) << text;
    return parse_toml(path(), "file");
  }
  /// What the parser says about such a file, from the line number on.
  std::string complaint(const std::string& text) {
    try {
      parse(text);
    } catch (const InputError& error) {
      const std::string what = error.what(), start = path().string() + ":";
      return what.starts_with(start) ? what.substr(start.size()) : what;
    }
    return "";
  }
  std::filesystem::path path() const { return folder.path() / "file.toml"; }
  TemporaryFolder folder;
};

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

// toml11 3.7 takes a pointer into one buffer for one into another when a string is no UTF-8.
TEST_F(TomlFile, BytesThatAreNoUtf8AreRefusedWithTheirPlace) {
  EXPECT_TRUE(complaint("a = 1\nb = 'hoc\x8c\xd4'\n").starts_with("2:9: this is not UTF-8"));
  for (const char* bad : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf0\x82\x82\xac",
                          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82"})
    EXPECT_TRUE(complaint(std::string("# ") + bad + "\n").starts_with("1:3: ")) << bad;
  for (const std::string good : {"\u00e9", "\u20ac", "\uffff", "\U0001f600", "\U0010ffff", "\ud7ff"})
    EXPECT_EQ(toml::find<std::string>(parse("a = '" + good + "'"), "a"), good);
}

// Each level is a call or more for toml11: a few kilobytes of brackets fill its stack.
TEST_F(TomlFile, EndlessNestingIsRefused) {
  for (const char* open : {"[", "{a=", "[\n"})
    EXPECT_NE(complaint("a = " + repeated(open, 100000)).find("nested too deeply"), std::string::npos) << open;
  for (const std::string start : {"", "[", "a = { "})
    EXPECT_NE(complaint(start + repeated("a.", 100000) + "a = 1\n").find("too many dots"), std::string::npos) << start;
}

TEST_F(TomlFile, BracketsAndDotsInTextsDoNotCount) {
  const std::string many = repeated("[{.", 50);
  const toml::value file = parse("# " + many + "\na = \"\\\"" + many + "\" # " + many + "\nb = '" + many +
                                 "'\nc = \"\"\"\n\"" + many + "\"\"\"\nd = '''\n'" + many + "'''\ne = [[1], [2, 3]]\n");
  EXPECT_EQ(toml::find<std::string>(file, "a"), "\"" + many);
  EXPECT_EQ(toml::find<std::string>(file, "b"), many);
  EXPECT_EQ(toml::find<std::string>(file, "c"), "\"" + many);
  EXPECT_EQ(toml::find<std::string>(file, "d"), "'" + many);
  EXPECT_EQ(toml::find(file, "e").size(), 2u);
}

TEST_F(TomlFile, AFolderOrNothingCannotBeRead) {
  for (const auto& path : {folder.path(), folder.path() / "missing"}) {
    try {
      parse_toml(path, "study file");
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("cannot read the study file")) << error.what();
    }
  }
}

}  // namespace
}  // namespace sphk
