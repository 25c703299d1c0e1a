// Who is told when, from endpoints as discovery shows them.
#include "runtime/host/command_watch.hpp"

#include <gmock/gmock.h>

namespace bw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const WatchedTopic kTopic{.topic = "/cmd_vel",
                          .type = "geometry_msgs/msg/Twist",
                          .owner = "/collision_monitor",
                          .open = {"/cmd_vel_teleop"}};

dds::Endpoint writer(std::uint8_t id, std::vector<std::string> partitions = {}) {
  return {.guid = {id}, .is_writer = true, .topic = "rt/cmd_vel", .partitions = std::move(partitions)};
}
dds::Endpoint owner(std::uint8_t id) { return writer(id, {"", command_partition("/collision_monitor")}); }
Time at(double seconds) { return Time::seconds(100.0 + seconds); }

struct Domain {
  std::map<dds::Guid, std::string> names;
  CommandWatch watch{{kTopic}};

  std::vector<std::string> look(double t, const std::vector<dds::Endpoint>& present,
                                const std::vector<dds::Endpoint>& departed = {}, bool refuses = false) {
    std::vector<std::string> texts;
    const auto node_of = [this](const dds::Guid& guid) {
      return names.contains(guid) ? names.at(guid) : std::string();
    };
    for (const auto& news :
         watch.look(present, departed, node_of, at(t), [refuses](const std::string&) { return refuses; }))
      texts.push_back(news.text);
    return texts;
  }
  CommandWatch::State state() const { return watch.states().at("/cmd_vel"); }
};

TEST(CommandWatch, AStrangerIsToldOnceByNameWithTheWayThatIsOpen) {
  Domain domain;
  domain.names[{2}] = "/teleop";
  EXPECT_THAT(domain.look(0.0, {owner(1)}), IsEmpty());
  EXPECT_EQ(domain.state().text, "commanded by /collision_monitor");
  EXPECT_THAT(
      domain.look(0.5, {owner(1), writer(2)}),
      ElementsAre(
          "refused: /cmd_vel is commanded by /collision_monitor alone; /teleop publishes it too; others are "
          "heard on /cmd_vel_teleop"));
  EXPECT_THAT(domain.look(1.0, {owner(1), writer(2)}), IsEmpty());
  EXPECT_EQ(domain.state().level, LogLevel::warn);
  EXPECT_EQ(domain.state().text, "refused: /teleop");
  EXPECT_THAT(domain.look(1.5, {owner(1)}, {writer(2)}), IsEmpty());
  EXPECT_EQ(domain.state().level, LogLevel::info);
}

TEST(CommandWatch, WaitsASecondForTheNameAndNoLonger) {
  Domain domain;
  EXPECT_THAT(domain.look(0.0, {writer(2), writer(3)}), IsEmpty());
  EXPECT_TRUE(domain.watch.is_waiting());
  domain.names[{2}] = "/late";
  EXPECT_THAT(domain.look(0.5, {writer(2), writer(3)}), ElementsAre(HasSubstr("; /late publishes it too")));
  EXPECT_THAT(domain.look(1.0, {writer(2), writer(3)}),
              ElementsAre(HasSubstr("; somebody without a node name publishes")));
  EXPECT_FALSE(domain.watch.is_waiting());
}

TEST(CommandWatch, WhoCameAndWentBetweenTwoLooksIsTold) {
  Domain domain;
  domain.names[{2}] = "/once";
  EXPECT_THAT(domain.look(0.0, {owner(1)}, {writer(2)}), ElementsAre(HasSubstr("/once")));
  EXPECT_EQ(domain.state().level, LogLevel::info);
  EXPECT_THAT(domain.look(0.5, {owner(1)}), IsEmpty());
}

TEST(CommandWatch, ManyAreOneLine) {
  Domain domain;
  std::vector<dds::Endpoint> present;
  for (std::uint8_t i = 2; i < 102; ++i) {
    present.push_back(writer(i));
    domain.names[{i}] = "/n" + std::to_string(i);
  }
  EXPECT_THAT(domain.look(0.0, present),
              ElementsAre(HasSubstr("/n2, /n3, /n4, /n5, /n6 and 95 more publish it too")));
}

TEST(CommandWatch, TwoOwnersWhoBothCommandAreAnErrorUntilOneIsObeyed) {
  Domain domain;
  for (const double t : {0.0, 0.5, 1.0, 1.5})
    EXPECT_THAT(domain.look(t, {owner(1), owner(2)}, {}, true), IsEmpty());
  EXPECT_TRUE(domain.watch.is_waiting());
  EXPECT_THAT(domain.look(2.0, {owner(1), owner(2)}, {}, true),
              ElementsAre(HasSubstr("nobody is obeyed on /cmd_vel while two command: 2 publishers")));
  EXPECT_EQ(domain.state().level, LogLevel::error);
  EXPECT_THAT(domain.look(2.5, {owner(1), owner(2)}, {}, true), IsEmpty());
  EXPECT_THAT(domain.look(3.0, {owner(1), owner(2)}), ElementsAre("on /cmd_vel one is obeyed again"));
  EXPECT_EQ(domain.state().level, LogLevel::info);
}

// Killed, it counts as there for seconds; its successor is refused for less than one, and that is no news.
TEST(CommandWatch, ASuccessorOfOneThatWasKilledIsNoNews) {
  Domain domain;
  EXPECT_THAT(domain.look(0.0, {owner(1), owner(2)}, {}, true), IsEmpty());
  EXPECT_THAT(domain.look(0.5, {owner(1), owner(2)}, {}, true), IsEmpty());
  EXPECT_THAT(domain.look(1.0, {owner(1), owner(2)}, {}, true), IsEmpty());
  for (double t = 1.5; t < 20.0; t += 0.5) EXPECT_THAT(domain.look(t, {owner(1), owner(2)}), IsEmpty());
  EXPECT_EQ(domain.state().level, LogLevel::info);
  EXPECT_EQ(domain.state().text, "commanded by /collision_monitor");
  EXPECT_FALSE(domain.watch.is_waiting());
}

TEST(CommandWatch, OnATopicThatIsOpenTheTypeIsWhatIsRefused) {
  CommandWatch watch(std::vector{WatchedTopic{.topic = "/cmd_vel", .type = "geometry_msgs/msg/Twist"}});
  dds::Endpoint good = writer(1), bad = writer(2);
  good.type = "geometry_msgs::msg::dds_::Twist_";
  bad.type = "geometry_msgs::msg::dds_::TwistStamped_";
  const auto node_of = [](const dds::Guid& guid) { return guid[0] == 1 ? "/keyboard" : "/joystick"; };
  const auto news = watch.look({good, bad}, {}, node_of, at(0.0));
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(
      news[0].text,
      "not heard: /joystick (geometry_msgs/msg/TwistStamped); /cmd_vel is geometry_msgs/msg/Twist here");
  EXPECT_EQ(watch.states().at("/cmd_vel").level, LogLevel::warn);
  EXPECT_TRUE(watch.look({good}, {}, node_of, at(0.5)).empty());
  EXPECT_EQ(watch.states().at("/cmd_vel").text, "open to all");
}

TEST(CommandWatch, WithoutAnOpenTopicItSaysHowToOpenOne) {
  CommandWatch watch(
      std::vector{WatchedTopic{.topic = "/cmd_vel", .type = "geometry_msgs/msg/Twist", .owner = "/base"}});
  const auto news = watch.look(
      {writer(2)}, {}, [](const dds::Guid&) { return "/teleop"; }, at(0.0));
  ASSERT_EQ(news.size(), 1U);
  EXPECT_THAT(news[0].text, HasSubstr("mark the input external: true"));
}

}  // namespace
}  // namespace bw
