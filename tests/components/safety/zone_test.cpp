#include "components/safety/zone.hpp"

#include <gtest/gtest.h>

namespace bw::safety {
namespace {

/// `count` returns close to `center`.
std::vector<SeenPoint> returns(const Vector2& center, int count = 6) {
  std::vector<SeenPoint> points;
  for (int i = 0; i < count; ++i) points.push_back({center + Vector2(0.0, 0.001 * i), false});
  return points;
}

ZoneOptions circle(Action action, double radius) {
  return {.type = ZoneShape::circle, .radius = radius, .action_type = action};
}

TEST(Zone, AStopZoneAllowsOnlyWhatLeadsAway) {
  const Zone zone(circle(Action::stop, 0.5));
  const auto ahead = returns({0.4, 0.1});
  EXPECT_EQ(zone.share_left({0.3, 0.1}, ahead), 0.0);
  EXPECT_EQ(zone.share_left({-0.1, 0.0}, ahead), 1.0);
  EXPECT_EQ(zone.share_left({0.0, 0.5}, ahead), 0.0) << "a turn leaves it as near";
  EXPECT_EQ(zone.share_left({0.3, 0.0}, returns({0.6, 0.0})), 1.0);
  auto both = returns({0.4, 0.0});
  for (const SeenPoint& point : returns({-0.4, 0.0})) both.push_back(point);
  EXPECT_EQ(zone.share_left({0.3, 0.0}, both), 0.0);
  EXPECT_EQ(zone.share_left({-0.1, 0.0}, both), 0.0);
}

// A rectangle from 0 to 1 m ahead, 0.4 m to either side; something at its left edge. A rotation to the left
// brings it to the middle, one to the right out of it.
TEST(Zone, AStopZoneStopsTurnsThatDoNotLeadOut) {
  const Zone zone({.type = ZoneShape::polygon, .points = {{0.0, -0.4}, {1.0, -0.4}, {1.0, 0.4}, {0.0, 0.4}}});
  const auto left = returns({0.5, 0.35});
  EXPECT_EQ(zone.share_left({0.0, 0.5}, left), 0.0);
  EXPECT_EQ(zone.share_left({0.0, -0.5}, left), 1.0);
  EXPECT_EQ(zone.share_left({-1e-6, 0.5}, left), 0.0) << "as good as on the spot";
  EXPECT_EQ(zone.share_left({-0.2, 0.1}, left), 1.0);
}

TEST(Zone, FewerThanMinPointsDoNotCount) {
  const Zone zone(circle(Action::stop, 0.5));
  EXPECT_EQ(zone.share_left({0.3, 0.0}, returns({0.4, 0.0}, 3)), 1.0);
  EXPECT_EQ(zone.share_left({0.3, 0.0}, returns({0.4, 0.0}, 4)), 0.0);
}

TEST(Zone, ASlowdownPolygonScalesAndALimitPolygonCaps) {
  ZoneOptions options{.type = ZoneShape::polygon,
                      .points = {{0.0, -0.4}, {1.0, -0.4}, {1.0, 0.4}, {0.0, 0.4}},
                      .action_type = Action::slowdown,
                      .slowdown_ratio = 0.3};
  EXPECT_EQ(Zone(options).share_left({1.0, 0.5}, returns({0.9, 0.3})), 0.3);
  EXPECT_EQ(Zone(options).share_left({1.0, 0.5}, returns({1.1, 0.0})), 1.0);
  EXPECT_EQ(Zone(options).share_left({1.0, 0.5}, returns({0.5, 0.5})), 1.0);
  EXPECT_EQ(Zone(options).share_left({1.0, 0.5}, returns({-0.1, 0.0})), 1.0);
  options.action_type = Action::limit;
  options.linear_limit = 0.4;
  options.angular_limit = 0.1;
  EXPECT_DOUBLE_EQ(Zone(options).share_left({1.0, 0.0}, returns({0.5, 0.0})), 0.4);
  EXPECT_DOUBLE_EQ(Zone(options).share_left({0.2, -0.5}, returns({0.5, 0.0})), 0.2);
  EXPECT_EQ(Zone(options).share_left({0.3, 0.05}, returns({0.5, 0.0})), 1.0);
}

TEST(Zone, AnApproachZoneKeepsTheTimeBeforeCollision) {
  // 0.3 m circle at 1 m/s, something 1.35 m ahead: touched between 1.0 and 1.1 s; half of 2 s is left
  const Zone zone(circle(Action::approach, 0.3));
  EXPECT_DOUBLE_EQ(zone.share_left({1.0, 0.0}, returns({1.35, 0.0})), 0.5);
  EXPECT_EQ(zone.share_left({1.0, 0.0}, returns({2.4, 0.0})), 1.0);
  EXPECT_EQ(zone.share_left({1.0, 0.0}, returns({1.35, 0.4})), 1.0);
  EXPECT_EQ(zone.share_left({-0.2, 0.0}, returns({0.2, 0.0})), 1.0);
  EXPECT_EQ(zone.share_left({0.2, 0.0}, returns({0.2, 0.0})), 0.0);
}

}  // namespace
}  // namespace bw::safety
