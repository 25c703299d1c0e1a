// Social-force predictions of the people component and the obstacles it is told of: somebody walks at a wall.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>

#include "components/messages/obstacles.hpp"
#include "components/model/social_force.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::Obstacles;
using bandwagon_msgs::msg::Track;

constexpr double kWall = 6.0;       // x of the wall [m]
const Pose2 kX_BL{0.2, 0.05, 0.5};  // the laser on the robot, which stands at the origin of odom
using Say = std::function<Obstacles(Time now)>;

Obstacles wall_in(const std::string& frame, const Pose2& X_OF, Time stamp) {
  StaticObstacles wall;
  wall.segments = {{{kWall, -3.0}, {kWall, 3.0}}};
  return to_message(wall, inverse(X_OF), frame, stamp);
}

/// The only person after 2.5 s: on the way to the wall at 1 m/s, 3.5 m before it. The laser sees no wall.
Track walker(const std::string& model, const Say& say) {
  Track last;
  run_with_script(
      "robot: {sensors: [{frame: laser, x: 0.2, y: 0.05, theta: 0.5}]}\n"
      "components:\n"
      "  world:\n"
      "    parameters:\n"
      "      people: {scripted: [{waypoints: [{x: 1.0, y: 0.5}, {x: 5.9, y: 0.5}], speed: 1.0}]}\n"
      "  robot_base: {inputs: {wheel_commands: {external: true}}}\n"
      "  people: {parameters: {prediction: {model: " +
          model + "}}}\n",
      2.5, [&](Setup& setup) {
        setup.input<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(),
                                                 [&](const auto& message, const Tick&) {
                                                   if (message.tracks().size() == 1)
                                                     last = message.tracks()[0];
                                                 });
        setup.every(Duration::milliseconds(100), "obstacles",
                    [&say, out = setup.output<Obstacles>("obstacles")](const Tick& tick) {
                      if (say) out.publish(say(tick.now));
                    });
      });
  return last;
}

double end_of(const Track& track) { return track.predictions().at(7).x(); }  // at 4 s

void expect_straight(const Track& track) {
  ASSERT_EQ(track.predictions().size(), 8U);
  EXPECT_NEAR(track.velocity().x(), 1.0, 0.15);
  EXPECT_NEAR(end_of(track), track.position().x() + 4.0 * track.velocity().x(), 1e-4);
  EXPECT_GT(end_of(track), kWall);
}

// Comes to rest where the wall pushes as hard as the walker wants on: v / tau = F exp(-(d - r) / sigma), at
// d = r + sigma ln(F tau / v) = 1.6 m from the wall. The motion there is a damped swing, of 6 % after 4 s.
TEST(WallsOfPredictions, WhoWalksAtAWallStopsBeforeIt) {
  const Track track = walker("social_force", [](Time now) { return wall_in("odom", {}, now); });
  ASSERT_EQ(track.predictions().size(), 8U);
  const SocialForceOptions forces;
  const double rest = kWall - track.radius() -
                      forces.obstacle_sigma *
                          std::log(forces.kObstacleFactor * forces.kRelaxationTime / track.velocity().x());
  EXPECT_NEAR(end_of(track), rest, 0.1);
  EXPECT_NEAR(rest, kWall - 1.6, 0.1);
}

TEST(WallsOfPredictions, WithoutObstaclesTheyGoStraightThrough) {
  expect_straight(walker("social_force", {}));
}

TEST(WallsOfPredictions, OtherModelsKnowNone) {
  expect_straight(walker("constant_velocity", [](Time now) { return wall_in("odom", {}, now); }));
}

TEST(WallsOfPredictions, ObstaclesOfLongAgoOrOfAnUnknownPlaceAreNone) {
  expect_straight(walker("social_force",
                         [](Time now) { return wall_in("odom", {}, now - Duration::milliseconds(700)); }));
  expect_straight(walker("social_force", [](Time now) { return wall_in("nowhere", {}, now); }));
}

TEST(WallsOfPredictions, AreTakenIntoOdom) {
  const Track odom = walker("social_force", [](Time now) { return wall_in("odom", {}, now); });
  const Track laser = walker("social_force", [](Time now) { return wall_in("laser", kX_BL, now); });
  ASSERT_EQ(laser.predictions().size(), 8U);
  EXPECT_NEAR(end_of(laser), end_of(odom), 1e-3);
  EXPECT_LT(end_of(laser), kWall);
}

}  // namespace
}  // namespace bw
