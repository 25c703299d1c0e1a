#include <numbers>

#include <gtest/gtest.h>

#include "components/messages/obstacles.hpp"

namespace bw {
namespace {

// A quarter turn to the left, and (10, 20): (x, y) becomes (10 - y, 20 + x).
TEST(ObstacleMessages, AreCarriedIntoTheFrameWanted) {
  const Pose2 X_OF{10.0, 20.0, std::numbers::pi / 2.0};
  StaticObstacles sent;
  sent.points = {{1.0, 2.0}};
  sent.discs = {{{3.0, 0.0}, 0.5}};
  sent.segments = {{{0.0, 0.0}, {0.0, 1.0}}};
  const auto message = to_message(sent, {}, "elsewhere", Time::seconds(5.0));
  EXPECT_EQ(message.header().frame_id(), "elsewhere");
  EXPECT_EQ(from_stamp(message.header().stamp()), Time::seconds(5.0));
  const StaticObstacles obstacles = to_obstacles(message, X_OF);
  ASSERT_EQ(obstacles.size(), 3U);
  EXPECT_NEAR((obstacles.points.at(0) - Vector2(8.0, 21.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((obstacles.discs.at(0).center - Vector2(10.0, 23.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(obstacles.discs.at(0).radius, 0.5);
  EXPECT_NEAR((obstacles.segments.at(0).a - Vector2(10.0, 20.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((obstacles.segments.at(0).b - Vector2(9.0, 20.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace bw
