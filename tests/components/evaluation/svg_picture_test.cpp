#include "components/evaluation/svg_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/evaluation/picture_view.hpp"
#include "components/evaluation/svg_writer.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

OccupancyGrid hallway(double length, double width) {
  OccupancyGrid map;
  map.resolution = 0.1;
  map.width = static_cast<int>(length / 0.1);
  map.height = static_cast<int>(width / 0.1);
  map.origin = {0.0, -width / 2.0};
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                   OccupancyGrid::kFree);
  for (int c = 0; c < map.width; ++c) {
    map.cells[map.index(c, 0)] = OccupancyGrid::kOccupied;
    map.cells[map.index(c, map.height - 1)] = OccupancyGrid::kOccupied;
  }
  return map;
}

RunRecording drive() {
  RunRecorder recorder({0.3, {}}, 1.0);
  recorder.set_map(hallway(20.0, 6.0));
  recorder.start(Time::seconds(50.0), {19.0, 0.0});
  for (int i = 0; i <= 900; ++i) {
    TruthSample s;
    s.time = Time::seconds(50.0 + 0.02 * i);
    s.X_MB = {1.0 + 0.02 * i, 0.5 * std::sin(0.01 * i), 0.5 * std::cos(0.01 * i)};
    s.twist = {0.5 + 0.5 * std::sin(0.01 * i), 0.0};
    s.people = {{3, {18.0 - 0.02 * i, -1.0}, {-1.0, 0.0}, 0.3}, {9, {10.0, 2.0}, {0.0, 0.0}, 0.3}};
    recorder.add(s);
  }
  return recorder.recording();
}

ScoreCard card() {
  ScoreCard c;
  c.finished = true;
  c.reached = true;
  c.time_to_goal = 18.0;
  c.closest = Encounter{8.5, 0.41, 3, {9.5, -1.0}, 0.3, {9.5, 0.0, 0.0}};
  return c;
}

/// Every tag opened is closed, attributes are quoted: enough of XML to catch a broken picture.
bool is_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t i = svg.find('<'); i != std::string::npos; i = svg.find('<', i + 1)) {
    const std::size_t end = svg.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = svg.substr(i + 1, end - i - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || tag.find('<') != std::string::npos) return false;
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag[0] == '/') {
      if (open.empty() || "/" + open.back() != tag) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

TEST(SvgWriter, NumbersAreShortAndTextIsSafe) {
  EXPECT_EQ(fixed(1.25, 1), "1.2");
  EXPECT_EQ(fixed(-0.01, 1), "0.0");
  EXPECT_EQ(fixed(-0.06, 1), "-0.1");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 2), "–");
  EXPECT_EQ(fixed(std::nan(""), 2), "–");
  EXPECT_EQ(xml_text("<a href=\"x\">&\x01\n"), "&lt;a href=&quot;x&quot;&gt;&amp;");
}

TEST(PictureView, MapsMetresToPixelsWithYUp) {
  const PictureView view = view_of(drive(), 1000.0, {10.0, 20.0});
  const Vector2 low = view({5.0, -1.0});
  const Vector2 high = view({5.0, 1.0});
  EXPECT_NEAR(low.x(), high.x(), 1e-9);
  EXPECT_NEAR(low.y() - high.y(), 2.0 * view.scale, 1e-9);
  EXPECT_NEAR(view.width(), 1000.0, 1e-9);
  EXPECT_NEAR(view(view.window_in_map.max()).y(), 20.0, 1e-9);
}

// The window is 1/3 as high as wide, 6.67 m of 20 m and more: the walls at y = -3 and y = 3 fit, wherever
// between them the drive was.
TEST(PictureView, BothWallsOfTheHallwayAreShown) {
  for (const double aside : {-1.5, 0.0, 1.5}) {
    RunRecording recording = drive();
    for (RecordedMoment& moment : recording.moments) moment.X_MB.y += aside;
    for (const bool has_map : {true, false}) {
      if (!has_map) {
        recording.map.reset();
        recording.shapes.segments = {{{0.0, 3.0}, {20.0, 3.0}}, {{0.0, -3.0}, {20.0, -3.0}}};
      }
      const Eigen::AlignedBox2d window = view_of(recording, 1000.0, {0.0, 0.0}).window_in_map;
      EXPECT_LT(window.min().y(), -3.0) << aside;
      EXPECT_GT(window.max().y(), 3.0) << aside;
    }
  }
}

// A single pillar is no place with a border: the drive past it is shown whole.
TEST(PictureView, WhatLiesBesideTheDriveCutsNothingOffIt) {
  RunRecording recording = drive();
  recording.map.reset();
  recording.shapes.discs = {{{5.0, 1.0}, 0.2}};
  const Eigen::AlignedBox2d window = view_of(recording, 1000.0, {0.0, 0.0}).window_in_map;
  EXPECT_LT(window.min().x(), 1.0);
  EXPECT_GT(window.max().x(), 19.0);
}

TEST(RunRecorder, TheWorldsMapComesBeforeTheRobots) {
  for (const bool truth_first : {true, false}) {
    RunRecorder recorder({0.3, {}}, 1.0);
    if (truth_first) recorder.set_true_map(hallway(20.0, 6.0));
    recorder.set_map(hallway(10.0, 6.0));
    if (!truth_first) recorder.set_true_map(hallway(20.0, 6.0));
    EXPECT_EQ(recorder.recording().map->width, 200);
  }
}

TEST(PictureView, CellsBecomeMergedRectanglesOfTheSameArea) {
  // A wall of 200 x 1 cells is one rectangle; the free room of 200 x 58 cells too.
  const RunRecording recording = drive();
  PictureView view = view_of(recording, 1000.0, {0.0, 0.0});
  view.window_in_map = Eigen::AlignedBox2d(Vector2(-1.0, -4.0), Vector2(21.0, 4.0));
  const auto rectangles = [&](int low, int high) {
    const std::string data = cells_path(*recording.map, view, low, high);
    return std::count(data.begin(), data.end(), 'M');
  };
  EXPECT_EQ(rectangles(65, 100), 2);
  EXPECT_EQ(rectangles(0, 64), 1);
  EXPECT_EQ(rectangles(-1, -1), 0);
}

TEST(RunRecorder, KeepsTenLooksASecondAndABoundedNumber) {
  RunRecorder recorder({0.3, {}}, 1.0);
  recorder.start(Time::seconds(1.0), {0.0, 0.0});
  for (int i = 0; i <= 50 * 60 * 30; ++i) {  // half an hour at 50 Hz
    TruthSample s;
    s.time = Time::seconds(1.0 + 0.02 * i);
    recorder.add(s);
    if (i == 500) {
      EXPECT_EQ(recorder.recording().moments.size(), 101U);
    }
  }
  EXPECT_LT(recorder.recording().moments.size(), 6000U);
  EXPECT_GT(recorder.recording().moments.size(), 3000U);
  EXPECT_NEAR(recorder.recording().moments.back().time, 1800.0, 1.0);
}

TEST(SvgPicture, ShowsTheRun) {
  const std::string svg = svg_picture(drive(), card(), {.title = "hallway <1>"});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("hallway &lt;1&gt;"));
  EXPECT_THAT(svg, HasSubstr("goal reached"));
  EXPECT_THAT(svg, HasSubstr("0.41 m at 8.5 s"));
  EXPECT_THAT(svg, HasSubstr("robot every 2 s"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_LT(svg.size(), 200'000U);
}

TEST(SvgPicture, IsTheSameEveryTime) {
  EXPECT_EQ(svg_picture(drive(), card()), svg_picture(drive(), card()));
}

TEST(SvgPicture, SaysWhyItFailed) {
  ScoreCard failed = card();
  failed.reached = false;
  failed.reason = "blocked: a crowd";
  failed.collisions = 2;
  EXPECT_THAT(svg_picture(drive(), failed), HasSubstr("goal not reached: blocked: a crowd, 2 contacts"));
}

TEST(SvgPicture, AnEmptyRecordingIsStillAPicture) {
  const std::string svg = svg_picture({}, {});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("still driving"));
}

TEST(SvgPicture, ADriveThatWasNotDecidedIsTitledAsAsked) {
  ScoreCard late = card();
  late.finished = false;
  EXPECT_THAT(svg_picture(drive(), late, {.unfinished = "timeout"}), HasSubstr(">timeout<"));
}

TEST(SvgPicture, APolygonIsDrawnAsOne) {
  RunRecording recording = drive();
  EXPECT_THAT(svg_picture(recording, card()), testing::Not(HasSubstr("Z\"")));
  recording.robot = {0.5, {{0.4, 0.3}, {-0.4, 0.3}, {-0.4, -0.3}, {0.4, -0.3}}};
  const std::string svg = svg_picture(recording, card());
  EXPECT_TRUE(is_well_formed(svg));
  // The ring at the closest encounter: the robot stood at (9.5, 0), heading 0.
  const PictureView view = view_of(recording, 1280.0 - 2.0 * 28.0, {28.0, 92.0});
  const auto at = [&](double x, double y) {
    return fixed(view({x, y}).x(), 1) + " " + fixed(view({x, y}).y(), 1);
  };
  EXPECT_THAT(svg, HasSubstr("d=\"M" + at(9.9, 0.3) + "L" + at(9.1, 0.3) + "L" + at(9.1, -0.3) + "L" +
                             at(9.9, -0.3) + "Z\""));
}

TEST(SvgPicture, WallsAndPillarsWithoutAMapAreDrawn) {
  RunRecording recording = drive();
  recording.map.reset();
  recording.shapes.segments = {{{0.0, 3.0}, {20.0, 3.0}}};
  recording.shapes.discs = {{{5.0, 1.0}, 0.2}};
  const std::string svg = svg_picture(recording, card());
  EXPECT_TRUE(is_well_formed(svg));
  // The wall is 20 m long, the pillar 0.2 m in radius.
  const PictureView view = view_of(recording, 1280.0 - 2.0 * 28.0, {28.0, 92.0});
  EXPECT_THAT(svg, HasSubstr("r=\"" + fixed(0.2 * view.scale, 1) + "\" fill=\"#34414f\""));
  EXPECT_THAT(svg, HasSubstr("x1=\"" + fixed(view({0.0, 3.0}).x(), 1) + "\" y1=\"" +
                             fixed(view({0.0, 3.0}).y(), 1) + "\" x2=\"" + fixed(view({20.0, 3.0}).x(), 1)));
}

}  // namespace
}  // namespace bw
