// Progress along a path and the stretch that a planner works on. A path folds, crosses itself or closes; the
// expected figures are lengths along it.
#include "components/local_planner/followed_path.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/components/local_planner/random_path.hpp"

namespace bw {
namespace {

constexpr FollowLimits kLimits{.lookahead = 6.0, .tolerance = {0.25, 0.25}, .max_deviation = 0.5};
constexpr double kPi = std::numbers::pi;

FollowedPath along(const std::vector<Vector2>& corners) {
  FollowedPath path;
  path.start(path_over(corners));
  return path;
}
Vector2 end_of(const PathLeg& leg) { return leg.poses.back().position(); }

TEST(FollowedPath, WithoutABendIsThePosesFromTheNearestToTheLookahead) {
  FollowedPath path = along({{0, 0}, {20, 0}});
  const PathLeg& leg = path.leg({3.02, 0.4, 0.0}, kLimits);
  EXPECT_NEAR(leg.poses.front().x, 3.0, 1e-9);
  // 0.4 m to the nearest pose, then the first pose at 5.6 m of the rest or more.
  EXPECT_NEAR(leg.poses.back().x, 8.6, 0.051);
  EXPECT_FALSE(leg.goal_is_final);
  EXPECT_NEAR(path.distance_to_goal(), 0.4 + 17.0, 0.01);
  path.leg({18.0, 0.0, 0.0}, kLimits);
  EXPECT_TRUE(path.leg({18.0, 0.0, 0.0}, kLimits).goal_is_final);
}

TEST(FollowedPath, ThatComesBackOverItselfIsDrivenToItsTurnFirst) {
  FollowedPath path = along({{0, 0}, {3, 0}, {-1, 0}});
  const PathLeg& out = path.leg({0, 0, 0}, kLimits);
  EXPECT_LT((end_of(out) - Vector2(3, 0)).norm(), 1e-9);
  EXPECT_NEAR(out.poses.back().theta, 0.0, 1e-9) << "as it is come to, not as it is left";
  EXPECT_TRUE(out.goal_is_final) << "arrived at, at rest";
  EXPECT_FALSE(path.is_on_last_leg());
  EXPECT_NEAR(path.distance_to_goal(), 7.0, 1e-9);
  for (double x = 0.1; x < 2.7; x += 0.1) {
    EXPECT_LT((end_of(path.leg({x, 0.1, 0}, kLimits)) - Vector2(3, 0)).norm(), 1e-9) << x;
    EXPECT_FALSE(path.is_on_last_leg());
  }
  // Within 0.25 m of the cusp it rotates where it is, and then goes all the way back.
  const PathLeg& rotation = path.leg({2.8, 0.0, 0.0}, kLimits);
  EXPECT_TRUE(rotation.begins);
  ASSERT_EQ(rotation.poses.size(), 1U);
  EXPECT_EQ(rotation.poses[0].position(), Vector2(2.8, 0.0));
  EXPECT_NEAR(std::abs(rotation.poses[0].theta), kPi, 1e-9);
  EXPECT_TRUE(rotation.goal_is_final);
  EXPECT_EQ(path.leg({2.8, 0.0, 1.0}, kLimits).poses.size(), 1U);
  const PathLeg& back = path.leg({2.8, 0.0, 3.0}, kLimits);
  EXPECT_LT((end_of(back) - Vector2(-1, 0)).norm(), 1e-9);
  EXPECT_TRUE(path.is_on_last_leg());
  EXPECT_NEAR(path.distance_to_goal(), 3.8, 0.03);
}

TEST(FollowedPath, ThatEndsWhereItBeginsIsAllAhead) {
  FollowedPath square = along({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  EXPECT_LT((end_of(square.leg({0, 0, 0}, kLimits)) - Vector2(2, 0)).norm(), 1e-9);
  EXPECT_NEAR(square.distance_to_goal(), 8.0, 1e-9);
  EXPECT_FALSE(square.is_on_last_leg());

  // Nothing of a circle is sharp. Of one of 1 m a chord over the angle 2 a leaves the arc by 1 - cos a: 0.5 m
  // at 2 a = 120 degrees, 2.09 m of arc; chords are tried each 0.1 m.
  std::vector<Vector2> corners;
  for (int i = 0; i <= 120; ++i)
    corners.push_back({std::sin(2.0 * kPi * i / 120), 1.0 - std::cos(2.0 * kPi * i / 120)});
  FollowedPath circle = along(corners);
  const PathLeg& leg = circle.leg({0, 0, 0}, kLimits);
  EXPECT_TRUE(circle.is_on_last_leg());
  EXPECT_NEAR(circle.distance_to_goal(), 2.0 * kPi, 0.01);
  EXPECT_FALSE(leg.goal_is_final);
  EXPECT_NEAR(leg.poses.back().theta, 2.0, 0.15) << "the angle of an arc of 2.0 m";
}

TEST(FollowedPath, ThatCrossesItselfIsFollowedStraightOn) {
  // An eight: east through (2, 0), round, and south to north through (2, 0) 8 m later.
  FollowedPath path = along({{0, 0}, {4, 0}, {4, -2}, {2, -2}, {2, 2}});
  for (double x = 0.0; x < 3.99; x += 0.1) path.leg({x, 0.0, 0.0}, kLimits);
  EXPECT_NEAR(path.distance_to_goal(), 12.0 - 3.9, 0.11);
  path.start(path_over({{0, 0}, {4, 0}, {4, -2}, {2, -2}, {2, 2}}));
  path.leg({1.9, 0.0, 0.0}, kLimits);
  path.leg({2.0, 0.3, 0.0}, kLimits);
  EXPECT_NEAR(path.distance_to_goal(), 10.3, 0.05) << "nearer to the later stretch, and yet on the first";
}

TEST(FollowedPath, ARobotThatIsPushedGoesOnFromWhereItWas) {
  FollowedPath path = along({{0, 0}, {10, 0}});
  path.leg({3.0, 0.0, 0.0}, kLimits);
  const double before = path.travelled();
  path.leg({2.0, 1.0, 0.0}, kLimits);
  EXPECT_EQ(path.index(), 60U) << "progress does not fall";
  EXPECT_NEAR(path.travelled() - before, -std::hypot(1.0, 1.0), 1e-9);
  path.leg({5.0, 1.0, 0.0}, kLimits);  // carried on 3 m, or the localization said so
  EXPECT_EQ(path.index(), 100U);
}

TEST(FollowedPath, BeginsWhereGoingOnLeadsAway) {
  FollowedPath path = along({{-5, 0}, {5, 0}, {0, 0}});
  path.leg({2.0, 0.3, 0.0}, kLimits);
  EXPECT_EQ(path.index(), 140U);
  // A grid's path begins with a step back to the middle of a cell: no rotation.
  path.start(path_over({{0, 0}, {-0.1, 0.02}, {5, 0}}));
  const PathLeg& leg = path.leg({0.0, 0.0, 0.0}, kLimits);
  EXPECT_FALSE(leg.begins);
  EXPECT_LT((end_of(leg) - Vector2(5, 0)).norm(), 1e-9);
}

TEST(FollowedPath, WayMadeGoesOnOverANewPath) {
  FollowedPath path = along({{0, 0}, {10, 0}});
  path.leg({0.0, 0.0, 0.0}, kLimits);
  path.leg({1.0, 0.0, 0.0}, kLimits);
  path.start(path_over({{1, 0}, {30, 0}}));
  path.leg({1.0, 0.0, 0.0}, kLimits);
  path.leg({1.5, 0.0, 0.0}, kLimits);
  EXPECT_NEAR(path.travelled(), 1.5, 1e-9);
}

TEST(FollowedPath, OfOnePlaceOrNoneIsSafe) {
  FollowedPath path;
  EXPECT_TRUE(path.leg({0, 0, 0}, kLimits).poses.empty());
  path.start({{2, 1, 0.5}});
  EXPECT_EQ(path.leg({0, 0, 0}, kLimits).poses, (std::vector<Pose2>{{2, 1, 0.5}}));
  path.start({{2, 1, 0.5}, {2, 1, 0.5}, {2, 1, 0.7}});
  EXPECT_TRUE(path.leg({2, 1, 0}, kLimits).goal_is_final);
}

/// What a planner does that knows nothing of paths: straight to the end of what it is given, 5 cm a cycle,
/// and where it has to arrive it does so within `inside` of the tolerance. It is pushed aside now and then.
std::vector<Pose2> drive_straight(FollowedPath& path, Random& random, double length) {
  std::vector<Pose2> driven;
  Pose2 X{0.0, 0.0, 0.0};
  const double most = 3.0 * length / 0.05 + 200.0;  // steps, three times those of the path
  for (int cycle = 0; cycle < most; ++cycle) {
    driven.push_back(X);
    const PathLeg& leg = path.leg(X, kLimits);
    const Vector2 to_end = end_of(leg) - X.position();
    if (to_end.norm() <= inside(leg.tolerance).xy && leg.goal_is_final) {
      if (path.is_on_last_leg() && leg.poses.size() > 1) return driven;
      if (path.is_on_last_leg() && path.distance_to_goal() < 0.25) return driven;
      X.theta = leg.poses.back().theta;
      continue;
    }
    const Vector2 step = to_end * std::min(1.0, 0.05 / to_end.norm());
    X = {X.x + step.x(), X.y + step.y(), std::atan2(to_end.y(), to_end.x())};
    if (random.uniform() < 0.02) {
      X.x += random.uniform(-0.1, 0.1);
      X.y += random.uniform(-0.1, 0.1);
    }
  }
  ADD_FAILURE() << "it does not get to the end";
  return driven;
}

// 4000 paths: each position of them is passed in order by a planner that cuts every bend that it is let cut:
// within what a chord may leave the path by, 0.5 m, a step of 0.1 m between the chords that are tried, and
// twice the 0.14 m by which the robot is pushed at most.
TEST(FollowedPath, EveryPlaceIsPassedInOrderWhateverThePath) {
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    Random random(seed);
    const std::vector<Vector2> corners = random_corners(random);
    const std::vector<Pose2> poses = path_over(corners);
    FollowedPath path;
    path.start(poses);
    const std::vector<Pose2> driven = drive_straight(path, random, 0.05 * static_cast<double>(poses.size()));
    const std::vector<Vector2> positions = positions_of(poses);
    ASSERT_EQ(passed_in_order(positions, driven, 0.5 + 0.1 + 0.28), positions.size()) << "seed " << seed;
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace bw
