#include "components/lab/failures/failure_picture.hpp"

#include <cmath>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kSpeed = 0.5;    // [m/s] of the robot, along x
constexpr double kContact = 8.0;  // [s]

/// The robot drives along x for 10 s; person 7 comes from the side and touches it at 8 s; person 9 stands far away.
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

/// Points of the one polyline of a class.
std::vector<Vector2> polyline(const std::string& svg, const std::string& name) {
  const std::regex line("<polyline points=\"([^\"]*)\"[^>]*class=\"" + name + "\"");
  std::smatch match;
  if (!std::regex_search(svg, match, line)) return {};
  std::istringstream text(match[1]);
  std::vector<Vector2> points;
  char comma = 0;
  for (Vector2 p; text >> p.x() >> comma >> p.y();) points.push_back(p);
  return points;
}

// Of the robot's way 5.5 to 8 s stand out (a second before the motion that is known), 1.25 m; the motion is 6.5 s of 0.25 m/s long;
// the person's last 4 s are 4 m.
TEST(FailurePicture, HasTheWaysInOneScale) {
  const std::string svg =
      failure_picture(recording(), {.title = "a drive", .lines = {"why"}, .contact = contact()});
  const std::vector<Vector2> robot = polyline(svg, "robot");
  const std::vector<Vector2> way_out = polyline(svg, "way-out");
  const std::vector<Vector2> person = polyline(svg, "person");
  ASSERT_GE(robot.size(), 2U);
  ASSERT_EQ(way_out.size(), 131U);
  ASSERT_EQ(person.size(), 41U);
  const double begin = std::min(kContact - 4.0, 6.5 - 1.0);
  const double scale = (robot.back() - robot.front()).norm() / (kSpeed * (kContact - begin));  // [px/m]
  EXPECT_GT(scale, 50.0);
  EXPECT_NEAR((way_out.back() - way_out.front()).norm() / scale, 0.25 * 6.5, 0.01);
  EXPECT_NEAR((person.back() - person.front()).norm() / scale, 4.0, 0.01);
  // The contact lies on the robot's rim towards the person: 0.3 m beyond its centre.
  std::smatch dot;
  ASSERT_TRUE(std::regex_search(
      svg, dot, std::regex("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" r=\"6.0\" class=\"contact\"")));
  EXPECT_NEAR(std::stod(dot[1]), robot.back().x(), 0.2);
  EXPECT_NEAR((robot.back().y() - std::stod(dot[2])) / scale, 0.3, 0.01);
  for (const char* text : {"a drive", "why", "avoidable until 6.5 s", "contact 8.00 s", ">7</text>", "goal"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(svg, Not(HasSubstr(">9</text>\n<polyline")));  // out of the view
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

// Without a contact the whole drive and its goal are shown.
TEST(FailurePicture, OfADriveThatWasLate) {
  const std::string svg = failure_picture(recording(), {.title = "late"});
  EXPECT_NEAR(static_cast<double>(polyline(svg, "robot").size()), 102.0, 1.0);
  EXPECT_TRUE(polyline(svg, "way-out").empty());
  EXPECT_THAT(svg, Not(HasSubstr("class=\"contact\"")));
  EXPECT_THAT(svg, HasSubstr("goal"));
}

TEST(FailurePicture, IsTheSameBytesAgain) {
  const FailurePicture picture{.title = "a", .contact = contact()};
  EXPECT_EQ(failure_picture(recording(), picture), failure_picture(recording(), picture));
}

}  // namespace
}  // namespace bw
