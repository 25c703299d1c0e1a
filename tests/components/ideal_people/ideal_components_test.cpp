// Both stand-ins for perception on their topics.
#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <people_msgs/msg/people.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/differential_drive.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;

struct Seen {
  std::vector<Tracks> tracks;
  people_msgs::msg::People people;
  visualization_msgs::msg::MarkerArray markers;
  std::vector<nav_msgs::msg::Odometry> filtered;
  std::vector<tf2_msgs::msg::TFMessage> tf;
};

/// The robot turns on an arc; odometry started elsewhere and comes 10 ms after the truth. One person walks.
Seen run(const std::string& components) {
  Seen seen;
  run_with_script("components: " + components, 2.0, [&](bw::Setup& setup) {
    const auto keep = [](auto& list) { return [&list](const auto& m, const Tick&) { list.push_back(m); }; };
    setup.input<Tracks>("tracks", Qos::standard(50), keep(seen.tracks), Need::optional);
    setup.input<people_msgs::msg::People>(
        "people", Qos::standard(), [&](const auto& m, const Tick&) { seen.people = m; }, Need::optional);
    setup.input<visualization_msgs::msg::MarkerArray>(
        "people_markers", Qos::standard(), [&](const auto& m, const Tick&) { seen.markers = m; },
        Need::optional);
    setup.input<nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50), keep(seen.filtered),
                                         Need::optional);
    setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(), keep(seen.tf), Need::optional);
    setup.every(Duration::milliseconds(10), "world",
                [truth = setup.output<GroundTruth>("sim/ground_truth"),
                 odom = setup.output<nav_msgs::msg::Odometry>("odom")](const Tick& tick) mutable {
                  const double t = seconds_since_start(tick.now);
                  const Twist2 twist{0.8, 0.5};
                  const Pose2 X_MB = Pose2{3.0, 1.0, 0.7} * advance_exact({}, twist, t);
                  if (tick.sequence % 2 == 1) {
                    nav_msgs::msg::Odometry message;
                    message.header(make_header("odom", tick.now));
                    message.pose().pose(to_pose(advance_exact({}, twist, t)));
                    odom.publish(message);
                    return;
                  }
                  GroundTruth message;
                  message.header(make_header("map", tick.now));
                  message.pose(to_pose(X_MB));
                  message.twist(to_twist_message(twist));
                  GroundTruthPerson person;
                  person.id(4);
                  person.position(to_point({5.0 + t, 2.0}));
                  person.velocity(to_vector3({1.0, 0.0}));
                  person.radius(0.25);
                  message.people().push_back(person);
                  truth.publish(message);
                });
  });
  return seen;
}

TEST(IdealPeopleComponent, PublishesTracksPeopleAndMarkersAtItsRate) {
  const Seen seen = run("{ideal_people: {}}");
  EXPECT_NEAR(static_cast<double>(seen.tracks.size()), 20.0, 1.0);  // 10 Hz for 2 s
  ASSERT_EQ(seen.tracks.back().tracks().size(), 1U);
  const Tracks& message = seen.tracks.back();
  const Track& track = message.tracks()[0];
  EXPECT_EQ(message.header().frame_id(), "map");
  EXPECT_EQ(track.id(), 4U);
  const double t = seconds_since_start(from_stamp(message.header().stamp()));
  EXPECT_NEAR(track.position().x(), 5.0 + t, 1e-6);
  ASSERT_EQ(track.predictions().size(), 8U);
  EXPECT_NEAR(track.predictions()[7].x(), 5.0 + t + 4.0, 1e-6);
  EXPECT_EQ(track.predictions()[7].time_from_start().sec(), 4);
  ASSERT_EQ(seen.people.people().size(), 1U);
  EXPECT_EQ(seen.people.people()[0].name(), "4");
  EXPECT_EQ(seen.markers.markers().size(), 2U);
}

TEST(IdealLocalizationComponent, PutsTheRobotWhereItIs) {
  const Seen seen = run("{ideal_localization: {}}");
  ASSERT_GE(seen.filtered.size(), 90U);
  EXPECT_EQ(seen.filtered.back().header().frame_id(), "map");
  EXPECT_EQ(seen.filtered.back().child_frame_id(), "base_link");
  ASSERT_GE(seen.tf.size(), 90U);
  const auto& transform = seen.tf.back().transforms().at(0);
  EXPECT_EQ(transform.header().frame_id(), "map");
  EXPECT_EQ(transform.child_frame_id(), "odom");
  // The odometry is perfect but for its start, so odom lies where the robot started.
  EXPECT_NEAR(transform.transform().translation().x(), 3.0, 1e-9);
  EXPECT_NEAR(transform.transform().translation().y(), 1.0, 1e-9);
  EXPECT_NEAR(yaw_of(transform.transform().rotation()), 0.7, 1e-9);
}

}  // namespace
}  // namespace bw
