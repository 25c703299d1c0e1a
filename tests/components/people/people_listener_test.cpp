// people_msgs/People on the topic `people` as the only eyes: each message is one person at (2, 1) in `map`,
// walking 1 m/s along its x. odom is rotated by a quarter: map's x is odom's -y.
#include <cmath>
#include <numbers>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>
#include <people_msgs/msg/people.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

const Pose2 kX_MO{1.0, 0.0, std::numbers::pi / 2};

/// What is published while the messages are spoilt by `spoil`; one message each 0.1 s.
std::vector<bandwagon_msgs::msg::Tracks> tracks_of(
    const std::function<void(people_msgs::msg::People&, const Tick&)>& spoil) {
  std::vector<bandwagon_msgs::msg::Tracks> heard;
  run_with_script("components: {people_listener: }", 1.05, [&](bw::Setup& setup) {
    setup.input<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(),
                                             [&heard](const auto& m, const Tick&) { heard.push_back(m); });
    setup.every(Duration::milliseconds(100), "speak",
                [&spoil, people = setup.output<people_msgs::msg::People>("people"),
                 tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                  tf2_msgs::msg::TFMessage transforms;
                  transforms.transforms().push_back(to_transform("map", "odom", tick.now, kX_MO));
                  tf.publish(transforms);
                  people_msgs::msg::People message;
                  message.header(make_header("map", tick.now));
                  auto& person = message.people().emplace_back();
                  person.name("ann");
                  person.position(to_point({2.0, 1.0}));
                  person.velocity().x(1.0);
                  person.reliability(0.9);
                  spoil(message, tick);
                  people.publish(message);
                });
  });
  return heard;
}

TEST(PeopleListener, CarriesThemToOdomAndSaysWhereTheyWillBe) {
  const auto heard = tracks_of([](auto&, const Tick&) {});
  ASSERT_EQ(heard.size(), 10U);
  const auto& message = heard.back();
  EXPECT_EQ(message.header().frame_id(), "odom");
  EXPECT_NEAR(seconds_since_start(from_stamp(message.header().stamp())), 1.0, 1e-9);
  ASSERT_EQ(message.tracks().size(), 1U);
  const auto& ann = message.tracks()[0];
  EXPECT_EQ(ann.id(), heard.front().tracks()[0].id());
  EXPECT_NEAR(ann.position().x(), 1.0, 1e-9);  // (2, 1) - (1, 0) = (1, 1) in map's axes
  EXPECT_NEAR(ann.position().y(), -1.0, 1e-9);
  EXPECT_NEAR(ann.velocity().x(), 0.0, 1e-9);
  EXPECT_NEAR(ann.velocity().y(), -1.0, 1e-9);
  ASSERT_FALSE(ann.predictions().empty());
  const auto& last = ann.predictions().back();
  const double ahead = last.time_from_start().sec() + 1e-9 * last.time_from_start().nanosec();
  EXPECT_NEAR(last.y(), -1.0 - ahead, 1e-6);
  EXPECT_GT(last.cov_yy(), 0.0);
}

TEST(PeopleListener, NobodyIsAnAnswerToo) {
  const auto heard =
      tracks_of([](people_msgs::msg::People& message, const Tick&) { message.people().clear(); });
  ASSERT_EQ(heard.size(), 10U);
  EXPECT_TRUE(heard.back().tracks().empty());
}

TEST(PeopleListener, WhatIsNotOfNowOrNowhereMakesNoTracks) {
  EXPECT_TRUE(tracks_of([](auto& m, const Tick&) { m.header().stamp({}); }).empty());
  EXPECT_TRUE(tracks_of([](auto& m, const Tick&) { m.header().frame_id("moon"); }).empty());
  EXPECT_TRUE(tracks_of([](auto& m, const Tick& tick) {
                m.header(make_header("map", tick.now - Duration::milliseconds(1500)));
              }).empty());
  EXPECT_TRUE(tracks_of([](auto& m, const Tick& tick) {
                m.header(make_header("map", tick.now + Duration::milliseconds(1500)));
              }).empty());
}

}  // namespace
}  // namespace bw
