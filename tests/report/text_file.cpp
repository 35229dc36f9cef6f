#include "src/report/text_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

TEST(TextFile, MakesAndReplacesFilesAlone) {
  const TemporaryFolder folder;
  write_text(folder.path() / "a", "one");
  write_text(folder.path() / "a", "two");
  EXPECT_EQ(read_text(folder.path() / "a"), "two");
  mkfifo((folder.path() / "pipe").c_str(), 0600);  // as a device would be
  EXPECT_THROW(write_text(folder.path() / "pipe", "text"), InputError);
  EXPECT_TRUE(std::filesystem::is_fifo(folder.path() / "pipe"));
  EXPECT_THROW(write_text(folder.path() / "nowhere" / "a", "text"), InputError);
}

}  // namespace
}  // namespace sphk
