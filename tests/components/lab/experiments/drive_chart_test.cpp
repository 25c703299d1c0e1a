#include "components/lab/experiments/drive_chart.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/evaluation/collision_index.hpp"

namespace bw {
namespace {

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
  const report::Figure figure = drive_figure(drive(101), "Eddie", "What it is.");
  ASSERT_EQ(figure.pictures.size(), 3U);
  const auto line = [&](std::size_t picture) { return figure.pictures[picture]["series"][0]["strokes"][0]; };
  EXPECT_TRUE(figure.pictures[0]["floor"]);
  EXPECT_EQ(line(1).dump(), "[0.0,1.0,10.0,1.0]");  // 1 m/s all along
  // Between outlines 1 - 0.3 - 0.3 m at 5 s, when it is nearest.
  double nearest = 10.0, when = 0.0;
  for (std::size_t i = 0; i < line(2).size(); i += 2) {
    if (line(2)[i + 1] >= nearest) continue;
    when = line(2)[i];
    nearest = line(2)[i + 1];
  }
  EXPECT_NEAR(nearest, 0.4, 0.01);
  EXPECT_NEAR(when, 5.0, 0.1);
  EXPECT_EQ(drive_figure({}, "nothing", "").pictures.size(), 3U) << "a drive that never began is no error";
}

}  // namespace
}  // namespace bw
