#include "src/report/html.hpp"

#include <gtest/gtest.h>

#include "src/engine/errors.hpp"
#include "tests/temporary_folder.hpp"

namespace sphk {
namespace {

// The test vectors of RFC 4648 sec 10.
TEST(Html, ImagesAreEmbeddedInBase64) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> vectors[] = {{"f", "Zg=="},         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},       {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    std::ofstream(folder.path() / "f.png") << bytes;
    EXPECT_EQ(html_image(folder.path() / "f.png", "a \"b\""),
              "<img alt=\"a &quot;b&quot;\" src=\"data:image/png;base64," + std::string(text) + "\">");
  }
  EXPECT_THROW(html_image(folder.path() / "none.png", ""), InputError);
}

TEST(Html, APageNeedsNothingBesideIt) {
  const std::string page = html_page("a < b", "<p>text</p>");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page.find("<title>a &lt; b</title>"), std::string::npos);
  for (const char* link : {"http:", "https:", "url(", "<script", "<link"})
    EXPECT_EQ(page.find(link), std::string::npos) << link;
}

}  // namespace
}  // namespace sphk
