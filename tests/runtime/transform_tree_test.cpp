// Expected poses by hand: compositions of quarter turns and halves of intervals.
#include "runtime/transforms/transform_tree.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;
Time at(double s) { return Time::seconds(s); }

TransformTree tree() {
  TransformTree t;
  t.set("map", "odom", at(1), spatial({10, 0, kQuarter}), false);
  t.set("map", "odom", at(3), spatial({10, 0, kQuarter}), false);
  t.set("odom", "base_link", at(1), spatial({0, 0, 0}), false);
  t.set("odom", "base_link", at(2), spatial({2, 0, 0}), false);
  t.set("base_link", "laser", at(0), spatial({0.2, 0, 0}), true);
  return t;
}

void expect_pose(const std::optional<Pose2>& X, double x, double y, double theta) {
  ASSERT_TRUE(X.has_value());
  EXPECT_NEAR(X->x, x, 1e-12);
  EXPECT_NEAR(X->y, y, 1e-12);
  EXPECT_NEAR(X->theta, theta, 1e-12);
}

TEST(TransformTree, ComposesAlongTheTreeAndInterpolates) {
  // base_link is 1 m along odom's x at 1.5 s, which is map's y; the laser 0.2 m further.
  expect_pose(tree().lookup_planar("map", "laser", at(1.5)), 10, 1.2, kQuarter);
}

TEST(TransformTree, InvertsAcrossTheTree) {
  expect_pose(tree().lookup_planar("laser", "odom", at(2)), -2.2, 0, 0);
}

TEST(TransformTree, WithoutATimeTakesTheNewestCommonInstant) {
  expect_pose(tree().lookup_planar("map", "base_link"), 10, 2, kQuarter);  // 2 s: odom's chain ends first
}

TEST(TransformTree, TellsTheNewestCommonInstant) {
  EXPECT_EQ(tree().newest("map", "laser"), at(2));
  EXPECT_EQ(tree().newest("odom", "map"), at(3));
  EXPECT_EQ(tree().newest("laser", "base_link"),
            Time{std::numeric_limits<std::int64_t>::max()});  // never moves
  EXPECT_FALSE(tree().newest("map", "elsewhere"));
}

TEST(TransformTree, DoesNotExtrapolate) {
  EXPECT_FALSE(tree().lookup("map", "base_link", at(2.5)));
  EXPECT_FALSE(tree().lookup("map", "base_link", at(0.5)));
  EXPECT_FALSE(tree().lookup("map", "elsewhere"));
}

TEST(TransformTree, InterpolatesTheShortWayThroughPi) {
  TransformTree t;
  t.set("a", "b", at(1), spatial({0, 0, 3.0}), false);
  t.set("a", "b", at(2), spatial({0, 0, -3.0}), false);
  const auto X = t.lookup_planar("a", "b", at(1.5));
  ASSERT_TRUE(X);
  EXPECT_NEAR(std::abs(X->theta), std::numbers::pi, 1e-9);
}

TEST(TransformTree, RefusesWhatIsNoTransform) {
  TransformTree t;
  Eigen::Isometry3d bad = Eigen::Isometry3d::Identity();
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(t.set("a", "b", at(1), bad, false));
  bad = Eigen::Isometry3d::Identity();
  bad.linear() *= 2.0;
  EXPECT_FALSE(t.set("a", "b", at(1), bad, false));
  EXPECT_FALSE(t.set("a", "a", at(1), Eigen::Isometry3d::Identity(), false));
}

TEST(TransformTree, ALoopOfFramesEndsTheLookup) {
  TransformTree t;
  t.set("a", "b", at(1), Eigen::Isometry3d::Identity(), false);
  t.set("b", "a", at(1), Eigen::Isometry3d::Identity(), false);
  EXPECT_FALSE(t.lookup("c", "a"));
}

// A clock 5 s and a clock 60 s back: the fifth transform tells, and the newest instant is one of the new
// time.
TEST(TransformTree, ForgetsTheTimeBeforeAClockThatWentBack) {
  for (const double restart : {95.0, 40.0}) {
    TransformTree t;
    for (int i = 0; i <= 10; ++i) t.set("a", "b", at(99.0 + 0.1 * i), spatial({1, 0, 0}), false);
    t.set("a", "b", at(99.85), spatial({1, 0, 0}), false);  // a late one changes nothing
    for (int i = 1; i <= 6; ++i) t.set("a", "b", at(restart + 0.1 * i), spatial({2, 0, 0}), false);
    expect_pose(t.lookup_planar("a", "b"), 2, 0, 0);
    EXPECT_TRUE(t.lookup("a", "b", at(restart + 0.55)));
    EXPECT_FALSE(t.lookup("a", "b", at(99.5)));
  }
}

TEST(TransformTree, ForgetsWhatIsOlderThanItsHistory) {
  TransformTree t(Duration::milliseconds(1000));
  for (int i = 1; i <= 100; ++i) t.set("a", "b", at(0.1 * i), Eigen::Isometry3d::Identity(), false);
  EXPECT_TRUE(t.lookup("a", "b", at(9.0)));
  EXPECT_FALSE(t.lookup("a", "b", at(8.9)));
  EXPECT_FALSE(t.set("a", "b", at(8.0), Eigen::Isometry3d::Identity(), false));
}

}  // namespace
}  // namespace bw
