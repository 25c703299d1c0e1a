// The pages in the program are those of the tree.
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "components/viewer/adaptor/help/help_pages.hpp"
#include "runtime/remote/web/content_coding.hpp"

namespace bw::viewer {
namespace {

TEST(Help, HasThePagesThatTheListNames) {
  ASSERT_GT(help_pages().size(), 50U);
  std::set<std::string_view> topics;
  for (const HelpPage& page : help_pages()) {
    EXPECT_TRUE(topics.insert(page.topic).second) << page.topic << " twice";
    std::ifstream in(std::string(BANDWAGON_SOURCE_DIR) + "/" + std::string(page.file), std::ios::binary);
    ASSERT_TRUE(in) << page.file;
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    EXPECT_EQ(web::inflated(page.gzip), text) << page.file;
  }
}

// A page that changed has another tag: browsers keep what has the same.
TEST(Help, IsServedUnderItsTopic) {
  const auto site = help_site();
  ASSERT_EQ(site.size(), help_pages().size());
  std::set<std::string_view> tags;
  for (std::size_t i = 0; i < site.size(); ++i) {
    EXPECT_EQ(site[i].path, "/help/" + std::string(help_pages()[i].topic));
    EXPECT_THAT(std::string(site[i].etag), testing::MatchesRegex("\"[0-9a-f]{16}\""));
    tags.insert(site[i].etag);
  }
  EXPECT_EQ(tags.size(), site.size());
}

}  // namespace
}  // namespace bw::viewer
