#include "components/local_planner/adaptor/planner_markers.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

using visualization_msgs::msg::Marker;
namespace constants = visualization_msgs::msg::Marker_Constants;

std::vector<Marker> of(const visualization_msgs::msg::MarkerArray& array, const std::string& ns) {
  std::vector<Marker> found;
  for (const Marker& marker : array.markers()) {
    if (marker.ns() == ns && marker.action() == constants::ADD) found.push_back(marker);
  }
  return found;
}

Candidate straight(const std::string& label, double cost, bool chosen) {
  Candidate candidate{label, cost, chosen, {}};
  for (int i = 0; i <= 4; ++i)
    candidate.trajectory.push_back({0.5 * i, {0.5 * i, chosen ? 0.0 : 1.0, 0.0}, {}});
  return candidate;
}

TEST(PlannerMarkers, BeginWithDeleteAllInTheFrameOfTheProblem) {
  const auto array = to_markers({.now = Time::seconds(12.5)}, {}, "robot1/odom");
  ASSERT_EQ(array.markers().size(), 1U);
  EXPECT_EQ(array.markers()[0].action(), constants::DELETEALL);
  EXPECT_EQ(array.markers()[0].header().frame_id(), "robot1/odom");
  EXPECT_EQ(array.markers()[0].header().stamp().sec(), 12);
  EXPECT_EQ(array.markers()[0].header().stamp().nanosec(), 500'000'000U);
}

TEST(PlannerMarkers, CandidatesAreLinesWithLabelsTheChosenOneGreenAndThick) {
  PlanningResult result;
  result.candidates = {
      straight("left", 12.345, false), straight("right", 7.0, true), {"none", 1.0, false, {}}};
  const auto array = to_markers({}, result, "odom");
  const auto lines = of(array, "candidates");
  ASSERT_EQ(lines.size(), 2U);  // nothing to draw of the third
  EXPECT_EQ(lines[0].type(), constants::LINE_STRIP);
  EXPECT_EQ(lines[0].points().size(), 5U);
  EXPECT_GT(lines[1].scale().x(), lines[0].scale().x());
  EXPECT_GT(lines[1].color().g(), lines[1].color().r() + 0.4F);
  const auto labels = of(array, "candidate_labels");
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].type(), constants::TEXT_VIEW_FACING);
  EXPECT_EQ(labels[0].text(), "left 12.35");
  EXPECT_EQ(labels[1].text(), "right 7.00");
  EXPECT_DOUBLE_EQ(labels[0].pose().position().x(), 1.0);  // the middle of 0 to 2 m
  EXPECT_DOUBLE_EQ(labels[0].pose().position().y(), 1.0);
}

TEST(PlannerMarkers, OfManyCandidatesOnlyTheChosenOneIsLabelled) {
  PlanningResult result;
  for (int i = 0; i < 30; ++i) result.candidates.push_back(straight("sample", i, i == 17));
  const auto array = to_markers({}, result, "odom");
  EXPECT_EQ(of(array, "candidates").size(), 30U);
  ASSERT_EQ(of(array, "candidate_labels").size(), 1U);
  EXPECT_EQ(of(array, "candidate_labels")[0].text(), "sample 17.00");
}

// Variances 0.04 and 0.01 m^2 along axes rotated by 30 degrees: two standard deviations are 0.4 and 0.2 m to
// each side, diameters 0.8 and 0.4 m.
TEST(PlannerMarkers, PredictionsAreDotsWithGrowingEllipses) {
  const double angle = std::numbers::pi / 6.0;
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Eigen::Matrix2d covariance = R * Eigen::Vector2d(0.04, 0.01).asDiagonal() * R.transpose();
  PlanningProblem problem;
  problem.movers.resize(2);
  problem.movers[0].position = {5.0, 0.0};
  problem.movers[0].velocity = {-1.0, 0.0};
  problem.movers[1].predictions = {{0.5, {1.0, 2.0}, covariance}, {1.0, {1.5, 2.0}, 4.0 * covariance}};
  const auto marks = of(to_markers(problem, {}, "odom"), "predictions");
  std::vector<Marker> dots;
  std::vector<Marker> ellipses;
  for (const Marker& m : marks) (m.type() == constants::SPHERE_LIST ? dots : ellipses).push_back(m);
  ASSERT_EQ(dots.size(), 2U);
  ASSERT_EQ(dots[0].points().size(), 6U);  // each 0.5 s for 3 s, at constant velocity
  EXPECT_DOUBLE_EQ(dots[0].points()[5].x(), 2.0);
  EXPECT_EQ(dots[1].points().size(), 2U);
  ASSERT_EQ(ellipses.size(), 2U);
  EXPECT_NEAR(ellipses[0].scale().x(), 0.8, 1e-9);
  EXPECT_NEAR(ellipses[0].scale().y(), 0.4, 1e-9);
  EXPECT_NEAR(ellipses[1].scale().x(), 1.6, 1e-9);
  EXPECT_DOUBLE_EQ(ellipses[0].pose().position().x(), 1.0);
  // The direction of an axis has no sign: compare modulo pi.
  EXPECT_NEAR(std::remainder(yaw_of(ellipses[0].pose().orientation()) - angle, std::numbers::pi), 0.0, 1e-9);
}

// 0.2 of the opacity up to confidence 0.3, all of it from 0.5 on, 0.6 half way.
TEST(PlannerMarkers, PossiblePeopleArePale) {
  PlanningProblem problem;
  problem.movers.resize(3);
  problem.movers[0].confidence = 0.0;
  problem.movers[1].confidence = 0.4;
  problem.movers[2].confidence = 0.5;
  const auto marks = of(to_markers(problem, {}, "odom"), "predictions");
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_NEAR(marks[0].color().a() / marks[2].color().a(), 0.2, 1e-6);
  EXPECT_NEAR(marks[1].color().a() / marks[2].color().a(), 0.6, 1e-6);
}

// Ten predictions a second would hide each other: about two are shown, and none beyond 3 s.
TEST(PlannerMarkers, DensePredictionsAreThinnedOut) {
  PlanningProblem problem;
  problem.movers.resize(1);
  for (int i = 1; i <= 50; ++i)
    problem.movers[0].predictions.push_back({0.1 * i, {0.1 * i, 0.0}, Eigen::Matrix2d::Identity()});
  const auto marks = of(to_markers(problem, {}, "odom"), "predictions");
  ASSERT_EQ(marks.size(), 7U);  // dots at 0.1, 0.6, ... 2.6 s and six ellipses
  EXPECT_EQ(marks.back().points().size(), 6U);
}

// A cone with apex (0.5, 0) between the directions of -45 and 45 degrees, seen from a robot at (10, 20): the
// apex is drawn at (10.5, 20), the legs 0.5 + 1.5 * 1 = 2 m long.
TEST(PlannerMarkers, VelocitiesAreDrawnFromTheRobotAtOneMetreForOneMetrePerSecond) {
  PlanningProblem problem;
  problem.pose = {10.0, 20.0, 2.0};
  problem.limits.v_max = 1.0;
  PlanningResult result;
  const double h = std::sqrt(0.5);
  result.velocity_cones = {{{0.5, 0.0}, {h, -h}, {h, h}}};
  result.velocity_wanted = Vector2(0.0, 0.8);
  const auto array = to_markers(problem, result, "odom");
  const auto cones = of(array, "velocity_cones");
  ASSERT_EQ(cones.size(), 2U);
  EXPECT_EQ(cones[0].type(), constants::LINE_LIST);
  ASSERT_EQ(cones[0].points().size(), 4U);
  EXPECT_DOUBLE_EQ(cones[0].points()[0].x(), 10.5);
  EXPECT_DOUBLE_EQ(cones[0].points()[0].y(), 20.0);
  EXPECT_NEAR(cones[0].points()[1].x(), 10.5 + 2.0 * h, 1e-12);
  EXPECT_NEAR(cones[0].points()[1].y(), 20.0 - 2.0 * h, 1e-12);
  EXPECT_EQ(cones[1].type(), constants::TRIANGLE_LIST);
  EXPECT_EQ(cones[1].points().size(), 3U);
  EXPECT_DOUBLE_EQ(cones[1].scale().x(), 1.0);  // rviz2 scales triangles by it
  const auto wanted = of(array, "velocity_wanted");
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted[0].type(), constants::ARROW);
  ASSERT_EQ(wanted[0].points().size(), 2U);
  EXPECT_DOUBLE_EQ(wanted[0].points()[1].x(), 10.0);
  EXPECT_DOUBLE_EQ(wanted[0].points()[1].y(), 20.8);
}

TEST(PlannerMarkers, WhatIsNotFiniteIsLeftOut) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  PlanningProblem problem;
  problem.movers.resize(3);
  problem.movers[0].position = {kNaN, 0.0};
  problem.movers[1].predictions = {{0.5, {1.0, 2.0}, Eigen::Matrix2d::Constant(kNaN)}};
  problem.movers[2].predictions = {{0.5, {1.0, 2.0}, Eigen::Matrix2d::Identity()},
                                   {1.0, {kNaN, 2.0}, Eigen::Matrix2d::Identity()}};
  PlanningResult result;
  result.candidates = {straight("good", 1.0, true), straight("bad", 1.0, false)};
  result.candidates[1].trajectory[2].pose.x = kNaN;
  result.velocity_cones = {{{kNaN, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
  result.velocity_wanted = Vector2(0.0, std::numeric_limits<double>::infinity());
  const auto array = to_markers(problem, result, "odom");
  for (const Marker& marker : array.markers()) {
    EXPECT_TRUE(std::isfinite(marker.scale().x()) && std::isfinite(marker.pose().position().x()));
    for (const auto& p : marker.points()) EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()));
  }
  EXPECT_EQ(of(array, "candidates").size(), 1U);
  EXPECT_EQ(of(array, "predictions").size(), 2U);  // dots of the second, the sound ellipse of the third
  EXPECT_TRUE(of(array, "velocity_cones").empty());
  EXPECT_TRUE(of(array, "velocity_wanted").empty());
}

}  // namespace
}  // namespace bw
