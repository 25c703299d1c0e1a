// What of a picture stands in a report: few points, in round numbers.
#include "components/lab/report/chart.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/lab/report/columns.hpp"

namespace bw::report {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(const char* text) { return Json::parse(text); }

Json strokes(const Chart& chart, std::size_t series = 0) {
  return to_json(chart)["series"][series]["strokes"];
}

TEST(Chart, ALineIsTheFewPointsThatAreSeen) {
  Chart chart{.title = "speed", .x = {"time [s]", 0.0, 10.0}, .y = {"v [m/s]", 0.0, 1.0}};
  chart.series.push_back({"robot", {.color = Color::blue}});
  // Straight up to 5 s, and down: 1001 points, of which three are seen.
  for (int i = 0; i <= 1000; ++i)
    chart.series[0].points.emplace_back(0.01 * i, 1.0 - std::abs(i - 500) / 500.0);
  EXPECT_EQ(strokes(chart), parsed("[[0, 0, 5, 1, 10, 0]]"));
  const Json json = to_json(chart);
  EXPECT_EQ(json["kind"], "chart");
  EXPECT_EQ(json["x"], parsed(R"({"label": "time [s]", "low": 0, "high": 10})"));
  EXPECT_EQ(json["series"][0]["name"], "robot");
  EXPECT_EQ(json["series"][0]["color"], "blue");
  EXPECT_FALSE(json["series"][0].contains("dash"));
  EXPECT_FALSE(json.contains("bodies"));
}

TEST(Chart, APointThatIsNotFiniteInterruptsALine) {
  const Chart chart{.title = "", .series = {{"", {}, {{0, 0}, {1, 1}, {NAN, NAN}, {2, 0}, {4, 1}}}}};
  EXPECT_EQ(strokes(chart), parsed("[[0, 0, 1, 1], [2, 0, 4, 1]]"));
}

TEST(Chart, WhatIsFarOutOfSightIsLeftOut) {
  Chart chart = floor_plan("its end");
  chart.show({Vector2(97.0, -2.0), Vector2(103.0, 2.0)});
  chart.series.push_back({"way", {}});
  for (int i = 0; i <= 1000; ++i) chart.series[0].points.emplace_back(0.1 * i, 0.0);
  const Json seen = strokes(chart);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_GT(seen[0][0].get<double>(), 80.0);
  EXPECT_EQ(seen[0][seen[0].size() - 2], 100.0);
}

// Places of a map projection have seven digits before the point; a step of the picture is a centimetre.
TEST(Chart, NumbersAreAsRoundAsThePictureAllows) {
  const Chart chart{.title = "", .series = {{"", {}, {{512345.123456, 1.0}, {512353.123456, 6.0}}}}};
  EXPECT_EQ(strokes(chart), parsed("[[512345.123, 1, 512353.123, 6]]"));
}

TEST(Chart, OfALogarithmicAxisWhatIsBelowLiesOnItsEnd) {
  const Chart chart{.title = "",
                    .x = {"t", 0.0, 2.0},
                    .y = {"error [m]", 0.01, 100.0, true},
                    .series = {{"", {}, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 50.0}}}}};
  const Json line = strokes(chart);
  EXPECT_NEAR(line[0][1].get<double>(), 0.01, 1e-4);
  EXPECT_NEAR(line[0][3].get<double>(), 1.0, 1e-2);
  EXPECT_NEAR(line[0][5].get<double>(), 50.0, 0.2);
  EXPECT_TRUE(to_json(chart)["y"]["log"]);
}

TEST(Chart, HoldsBodiesMarksAreasAndWalls) {
  Chart chart = floor_plan("room");
  chart.bodies = {
      {.center = {1.0, 2.0}, .radius = 0.3, .color = Color::purple, .label = "A", .arrow = {1.0, 0.0}}};
  chart.marks = {{{3.0, 4.0}, Symbol::ring, Color::red, "", "missed"}};
  chart.areas = {{.outline = {{0, 0}, {1, 0}, {1, 1}}, .is_shade = true, .name = "roof"}};
  chart.walls = {{{0.0, 0.0}, {5.0, 0.0}}};
  chart.blocks = {{Vector2(0.0, 0.0), Vector2(1.0, 2.0)}};
  const Json json = to_json(chart);
  EXPECT_TRUE(json["floor"]);
  EXPECT_EQ(json["bodies"][0],
            parsed(R"({"at": [1, 2], "radius": 0.3, "color": "purple", "label": "A", "arrow": [1, 0]})"));
  EXPECT_EQ(json["marks"][0]["symbol"], "ring");
  EXPECT_EQ(json["areas"][0]["outline"], parsed("[0, 0, 1, 0, 1, 1]"));
  EXPECT_EQ(json["walls"][0], parsed("[0, 0, 5, 0]"));
  EXPECT_EQ(json["blocks"][0], parsed("[0, 0, 1, 2]"));
}

TEST(Columns, HoldRunsIntervalAndWhatWasPublished) {
  Columns columns;
  columns.title = "ME";
  columns.y = {"ME [m]", 0.0, 1.0};
  columns.measured = "mean";
  columns.columns = {{.label = "all",
                      .color = Color::green,
                      .runs = {0.1, NAN},
                      .measured = Interval{0.1400004, 0.1, 0.2},
                      .published = 0.1455}};
  columns.limits = {{0.54, "physical"}};
  const Json json = to_json(columns);
  EXPECT_EQ(json["kind"], "columns");
  EXPECT_EQ(json["columns"][0]["runs"], parsed("[0.1, null]"));
  EXPECT_EQ(json["columns"][0]["measured"]["mean"], 0.14);
  EXPECT_EQ(json["columns"][0]["published"], 0.1455);
  EXPECT_EQ(json["limits"][0]["value"], 0.54);
}

TEST(Looks, EightLinesDiffer) {
  std::vector<std::pair<Color, Dash>> looks;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::pair now{look_of(i).color, look_of(i).dash};
    EXPECT_EQ(std::find(looks.begin(), looks.end(), now), looks.end()) << i;
    looks.push_back(now);
  }
}

}  // namespace
}  // namespace bw::report
