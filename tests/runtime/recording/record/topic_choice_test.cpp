// Which topics are recorded, by the options of `ros2 bag record` and by nodes.
#include "runtime/recording/record/topic_choice.hpp"

#include <stdexcept>

#include <gmock/gmock.h>

namespace bw::record {
namespace {

using ::testing::HasSubstr;

std::string said_about(const TopicChoiceOptions& options) {
  try {
    const TopicChoice choice(options);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(TopicChoice, TakesTopicsByNameWithOrWithoutTheFirstSlash) {
  const TopicChoice choice({.topics = {"odom", "/robot1/scan", "/_hidden"}});
  EXPECT_TRUE(choice.wants("/odom", {}));
  EXPECT_TRUE(choice.wants("/robot1/scan", {}));
  EXPECT_TRUE(choice.wants("/_hidden", {})) << "named, it is wanted";
  EXPECT_FALSE(choice.wants("/scan", {}));
}

TEST(TopicChoice, AllIsEverythingButHiddenTopics) {
  const TopicChoice all({.all = true});
  EXPECT_TRUE(all.wants("/odom", {}));
  EXPECT_TRUE(all.wants("/rosout", {}));
  EXPECT_TRUE(all.wants("/a_b", {}));
  EXPECT_FALSE(all.wants("/navigate/_action/status", {}));
  EXPECT_TRUE(TopicChoice({.all = true, .hidden = true}).wants("/navigate/_action/status", {}));
}

TEST(TopicChoice, ExcludeIsSearchedInTheName) {
  const TopicChoice choice({.all = true, .exclude = std::regex("image|^/debug")});
  EXPECT_FALSE(choice.wants("/camera/image_raw", {}));
  EXPECT_FALSE(choice.wants("/debug/x", {}));
  EXPECT_TRUE(choice.wants("/a/debug", {}));
}

TEST(TopicChoice, ANodeBringsWhatItWritesAndReads) {
  const TopicChoice choice({.exclude = std::regex("rosout"), .nodes = {"planner"}});
  EXPECT_TRUE(choice.wants("/odom", {"/base", "/planner"}));
  EXPECT_FALSE(choice.wants("/odom", {"/base", "/robot1/planner"}));
  EXPECT_FALSE(choice.wants("/rosout", {"/planner"}));
}

TEST(TopicChoice, RefusesWhatMakesNoSense) {
  EXPECT_THAT(said_about({}), HasSubstr("name topics, --node or --all"));
  EXPECT_THAT(said_about({.topics = {"/a"}, .all = true}), HasSubstr("--all is everything"));
  EXPECT_THAT(said_about({.topics = {"/a"}, .exclude = std::regex("b")}),
              HasSubstr("--exclude needs --all or --node"));
  EXPECT_THAT(said_about({.topics = {"/1a"}}), HasSubstr("/1a: must be a topic name"));
}

}  // namespace
}  // namespace bw::record
