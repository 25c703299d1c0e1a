#include "components/lab/experiments/drive_figure.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "components/evaluation/collision_index.hpp"
#include "components/lab/experiments/index_course.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

/// Along x at 1 m/s for `moments` tenths of a second, past somebody who stands at (5, 1).
RunRecording drive(int moments) {
  RunRecording course;
  course.goals = {{10.0, 0.0}};
  for (int i = 0; i < moments; ++i) {
    TruePerson person;
    person.position = {5.0, 1.0};
    course.moments.push_back({0.1 * i, {0.1 * i, 0.0, 0.0}, 1.0, {person}});
  }
  return course;
}

TEST(IndexCourse, KeepsEveryPeak) {
  // Nearest after 5 s, 1 m off: exp(-1 / 0.72) = 0.2494, whatever is thinned.
  for (const int moments : {101, 1001}) {
    const std::vector<Vector2> course = index_course(drive(moments));
    EXPECT_LE(course.size(), 200U);
    double highest = 0.0, when = 0.0;
    for (const Vector2& p : course) {
      if (p.y() <= highest) continue;
      highest = p.y();
      when = p.x();
    }
    EXPECT_NEAR(highest, std::exp(-1.0 / 0.72), 1e-12) << moments;
    EXPECT_NEAR(when, 5.0, 1e-9) << moments;
  }
  EXPECT_EQ(index_course(drive(101)).size(), 101U);
  EXPECT_TRUE(index_course({}).empty());
}

TEST(DriveFigure, ShowsWaySpeedAndDistance) {
  const std::string html = drive_figure(drive(101), "Eddie <1>", "What it <b>is</b>.");
  EXPECT_THAT(html, HasSubstr("<b>Eddie &lt;1&gt;.</b> What it <b>is</b>."));
  // Speed: 1 of 1.1 m/s on 170 px up from 194, all along the axis.
  EXPECT_THAT(html, HasSubstr("points=\"50.0,39.5 350.0,39.5 \""));
  // Between outlines 1 - 0.3 - 0.3 m at 5 s, in the middle of the axis: 194 - 170 * 0.4 / 5.
  EXPECT_THAT(html, HasSubstr("200.0,180.4"));
  EXPECT_THAT(drive_figure({}, "nothing", ""), HasSubstr("</figure>"))
      << "a drive that never began is no error";
}

}  // namespace
}  // namespace bw
