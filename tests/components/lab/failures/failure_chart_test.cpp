#include "components/lab/failures/failure_chart.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kSpeed = 0.5;    // [m/s] of the robot, along x
constexpr double kContact = 8.0;  // [s]

/// The robot drives along x for 10 s; person 7 comes from the side and touches it at 8 s; person 9 stands far
/// away.
RunRecording recording() {
  RunRecording drive;
  drive.robot = Footprint{0.3, {}};
  drive.goals = {{6.0, 0.0}};
  drive.shapes.segments = {{{-2.0, 3.0}, {8.0, 3.0}}};
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    RecordedMoment moment{.time = t, .X_MB = {kSpeed * t, 0.0, 0.0}, .speed = kSpeed};
    moment.people = {{7, {kSpeed * kContact, 0.6 + kContact - t}, {0.0, -1.0}, 0.3},
                     {9, {50.0, 50.0}, {0.0, 0.0}, 0.3}};
    drive.moments.push_back(moment);
  }
  return drive;
}

/// A motion straight back at 0.25 m/s from 6.5 s to 13 s.
JudgedContact contact() {
  JudgedContact judged;
  judged.record.time = kContact;
  judged.record.person = 7;
  judged.is_judged = true;
  judged.verdict.avoidance = possible::Avoidance::avoidable;
  judged.verdict.saveable_until = 6.5;
  for (int i = 0; i <= 130; ++i) {
    const double t = 6.5 + 0.05 * i;
    judged.verdict.motion.push_back({t, {kSpeed * 6.5 - 0.25 * (t - 6.5), 0.0, 0.0}, {-0.25, 0.0}});
  }
  return judged;
}

/// The one line of a name.
std::vector<Vector2> line(const report::Chart& chart, const std::string& name) {
  for (const report::Series& series : chart.series)
    if (series.name == name) return series.points;
  return {};
}

const report::Mark* mark(const report::Chart& chart, const std::string& label) {
  const auto found = std::ranges::find(chart.marks, label, &report::Mark::label);
  return found == chart.marks.end() ? nullptr : &*found;
}

// Of the robot's path 5.5 to 8 s stand out (a second before the motion that is known); the motion is 6.5 s of
// 0.25 m/s long; the person's last 4 s are 4 m.
TEST(FailureChart, HasTheWaysInMetres) {
  const report::Chart chart = failure_chart(recording(), contact());
  EXPECT_TRUE(chart.is_floor);
  const std::vector<Vector2> robot = line(chart, "robot, a dot each second");
  const std::vector<Vector2> escape = line(chart, "a motion without contact");
  const std::vector<Vector2> person = line(chart, "who is touched");
  ASSERT_GE(robot.size(), 2U);
  ASSERT_EQ(escape.size(), 131U);
  ASSERT_EQ(person.size(), 41U);
  EXPECT_NEAR((robot.back() - robot.front()).norm(),
              kSpeed * (kContact - std::min(kContact - 4.0, 6.5 - 1.0)), 0.01);
  EXPECT_NEAR((escape.back() - escape.front()).norm(), 0.25 * 6.5, 0.01);
  EXPECT_NEAR((person.back() - person.front()).norm(), 4.0, 0.01);
  // The contact lies on the robot's rim towards the person: 0.3 m beyond its centre.
  const report::Mark* touch = mark(chart, "contact 8.00 s");
  ASSERT_NE(touch, nullptr);
  EXPECT_NEAR(touch->at.x(), robot.back().x(), 0.01);
  EXPECT_NEAR(touch->at.y() - robot.back().y(), 0.3, 0.01);
  EXPECT_NE(mark(chart, "avoidable until 6.5 s"), nullptr);
  EXPECT_NE(mark(chart, "goal"), nullptr);
  EXPECT_NE(mark(chart, "7"), nullptr) << "a second of the ways";
  const auto body = [&](const char* label) {
    return std::ranges::find(chart.bodies, label, &report::Body::label) != chart.bodies.end();
  };
  EXPECT_TRUE(body("7"));
  EXPECT_FALSE(body("9")) << "out of the view";
  EXPECT_EQ(chart.walls.size(), 1U);
}

// Without a contact the whole drive and its goal are shown.
TEST(FailureChart, OfADriveThatWasLate) {
  const report::Chart chart = failure_chart(recording(), std::nullopt);
  EXPECT_NEAR(static_cast<double>(line(chart, "robot, a dot each second").size()), 102.0, 1.0);
  EXPECT_TRUE(line(chart, "a motion without contact").empty());
  EXPECT_TRUE(
      std::ranges::none_of(chart.marks, [](const auto& m) { return m.label.starts_with("contact"); }));
  EXPECT_NE(mark(chart, "goal"), nullptr);
}

TEST(FailureChart, OfARobotWithCornersShowsThem) {
  RunRecording drive = recording();
  drive.robot = Footprint{0.5, {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}};
  const report::Chart chart = failure_chart(drive, contact());
  ASSERT_EQ(chart.areas.size(), 3U);  // at the contact, and where the motion begins and ends
  EXPECT_EQ(chart.areas[0].outline.size(), 4U);
}

}  // namespace
}  // namespace bw
