// The plots of the pages of results: expected pixels are computed by hand from the frame of 300 px (x 50 to 350) below
// 24 px of title.
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "components/evaluation/axis_ticks.hpp"
#include "components/lab/experiments/column_plot.hpp"
#include "components/lab/experiments/figure.hpp"
#include "components/lab/experiments/line_plot.hpp"
#include "components/lab/experiments/path_plot.hpp"
#include "components/lab/experiments/thin_line.hpp"

namespace bw {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pointwise;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(AxisTicks, AreRoundNumbers) {
  EXPECT_DOUBLE_EQ(round_step(0.0, 84.0, 6), 20.0);  // 84 / 6 = 14, the next round number is 20
  EXPECT_DOUBLE_EQ(round_step(0.7, 1.0, 6), 0.05);   // 0.3 / 6 is 0.05 itself
  EXPECT_DOUBLE_EQ(round_step(0.0, 1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(round_step(-0.9, 16.9, 6), 5.0);
  EXPECT_THAT(ticks_between(-0.9, 16.9, 5.0), Pointwise(DoubleNear(1e-12), {0.0, 5.0, 10.0, 15.0}));
  EXPECT_THAT(ticks_between(0.7, 1.0, 0.1), Pointwise(DoubleNear(1e-12), {0.7, 0.8, 0.9, 1.0}));
  EXPECT_THAT(decades_between(0.01, 100.0), Pointwise(DoubleNear(1e-9), {0.01, 0.1, 1.0, 10.0, 100.0}));
}

TEST(AxisTicks, ShowTheDigitsOfTheirStep) {
  EXPECT_EQ(tick_text(0.7, 0.05), "0.70");
  EXPECT_EQ(tick_text(20.0, 10.0), "20");
  EXPECT_EQ(tick_text(0.01, 0.01), "0.01");
  EXPECT_EQ(tick_text(-0.0, 5.0), "0");
}

TEST(AxisTicks, AnAxisEndsAtARoundNumberAboveItsValues) {
  EXPECT_DOUBLE_EQ(round_end(2.31), 2.5);  // steps of 0.5
  EXPECT_DOUBLE_EQ(round_end(2.0), 2.0);
  EXPECT_DOUBLE_EQ(round_end(0.0), 1.0);
  EXPECT_DOUBLE_EQ(round_end(NAN), 1.0);
}

TEST(ThinLine, KeepsWhatIsSeen) {
  std::vector<Vector2> line;
  for (int i = 0; i <= 100; ++i) line.emplace_back(i, i == 50 ? 3.0 : 0.0);
  // The ends, the spike, and the two points where it rises and falls.
  EXPECT_THAT(thin_line(line, 0.25), ::testing::ElementsAre(Vector2(0, 0), Vector2(49, 0), Vector2(50, 3),
                                                            Vector2(51, 0), Vector2(100, 0)));
  EXPECT_EQ(thin_line(line, 4.0).size(), 2U);
  EXPECT_THAT(thin_line({{0, 0}, {NAN, 0}, {1, 1}}, 0.25),
              ::testing::ElementsAre(Vector2(0, 0), Vector2(1, 1)));
  EXPECT_EQ(thin_dots(line, 10.0).size(), 11U);
}

TEST(LinePlot, PutsPointsWhereTheyBelong) {
  // x: 0 to 10 on 300 px from 50, y: 0 to 2 on 170 px up from 194.
  const std::string svg = to_svg(LinePlot{.title = "a < b",
                                          .x = {"time [s]", 0.0, 10.0},
                                          .y = {"v [m/s]", 0.0, 2.0},
                                          .spans = {{2.0, 4.0, "roof"}},
                                          .limits = {{0.5, "limit"}},
                                          .curves = {{{}, {{0.0, 0.0}, {5.0, 2.0}, {10.0, 1.0}}}}});
  EXPECT_THAT(svg, HasSubstr("points=\"50.0,194.0 200.0,24.0 350.0,109.0 \""));
  EXPECT_THAT(svg, HasSubstr("<rect x=\"110.0\" y=\"24.0\" width=\"60.0\" height=\"170.0\""));
  EXPECT_THAT(svg, HasSubstr("y1=\"151.5\" x2=\"350.0\" y2=\"151.5\""));  // 194 - 170 / 4
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, HasSubstr(">time [s]</text>"));
  EXPECT_THAT(svg, HasSubstr(">v [m/s]</text>"));
  EXPECT_THAT(svg, HasSubstr(">10</text>"));
}

TEST(LinePlot, HasALogarithmicAxis) {
  // Four decades on 170 px: 42.5 px each; what is below the axis lies on it.
  const std::string svg = to_svg(LinePlot{.title = "",
                                          .x = {"time [s]", 0.0, 1.0},
                                          .y = {"error [m]", 0.01, 100.0, true},
                                          .curves = {{{}, {{0.0, 0.0}, {0.5, 1.0}, {1.0, 10.0}}}}});
  EXPECT_THAT(svg, HasSubstr("points=\"50.0,194.0 200.0,109.0 350.0,66.5 \""));
  for (const char* const tick : {">0.01<", ">0.1<", ">1<", ">10<", ">100<"})
    EXPECT_THAT(svg, HasSubstr(tick));
}

TEST(PathPlot, HasEqualAxes) {
  PathPlot plot{.title = "square"};
  plot.view.extend(Vector2(0.0, 0.0))
      .extend(Vector2(10.0, 5.0));  // 30 px/m, 150 px high: the bottom lies at 174
  plot.ways = {{{}, {{0.0, 0.0}, {10.0, 5.0}, {10.0, 0.0}}}};
  plot.discs = {{.center = {5.0, 2.5}, .radius = 0.5, .label = "4"}};
  const std::string svg = to_svg(plot);
  EXPECT_THAT(svg, HasSubstr("points=\"50.0,174.0 350.0,24.0 350.0,174.0 \""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"200.0\" cy=\"99.0\" r=\"15.0\""));
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 360.0 212.0\""));
}

TEST(PathPlot, IsNeitherVeryFlatNorVerySteep) {
  const auto sizes = [](const Vector2& to) {
    PathPlot plot{.title = ""};
    plot.view.extend(Vector2(0.0, 0.0)).extend(to);
    return Vector2(shown_by(plot).sizes());
  };
  EXPECT_NEAR(sizes({10.0, 0.1}).y(), 3.0, 1e-12);
  EXPECT_NEAR(sizes({10.0, 40.0}).x(), 40.0, 1e-12);
  EXPECT_TRUE(shown_by({.title = ""}).sizes().minCoeff() > 0.0) << "nothing to show is no error";
}

TEST(ColumnPlot, ShowsPublishedAndMeasuredBesideEachOther) {
  // Two columns of 150 px; published stands 15 px to the left of the middle, measured as much to the right.
  ColumnPlot plot;
  plot.y = {"v [m/s]", 0.0, 1.0};
  plot.columns.resize(2);
  plot.columns[0].measured = ColumnSpread{0.5, 0.25, 0.75};
  plot.columns[0].published = 1.0;
  plot.columns[1].runs = {2.0};
  const std::string svg = to_svg(plot);
  EXPECT_THAT(svg, HasSubstr("points=\"110.0,19.0 115.0,24.0 110.0,29.0 105.0,24.0 110.0,19.0 \""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"140.0\" cy=\"109.0\" r=\"4.0\""));
  EXPECT_THAT(svg, HasSubstr("x1=\"140.0\" y1=\"151.5\" x2=\"140.0\" y2=\"66.5\""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"275.0\" cy=\"24.0\" r=\"2.2\"")) << "beyond the axis: at its end";
}

TEST(Figure, HasOneLegendForAllPictures) {
  const std::string html = to_html({.title = "Figure 1",
                                    .caption = "What is <b>shown</b>.",
                                    .legend = {{"way", {.color = kBlue}}, {"people", {}, LegendSymbol::body}},
                                    .pictures = {"<svg>1</svg>", "<svg>2</svg>"}});
  EXPECT_EQ(count(html, "class=\"legend\""), 1U);
  EXPECT_THAT(html, HasSubstr("<figcaption><b>Figure 1.</b> What is <b>shown</b>.</figcaption>"));
  EXPECT_THAT(html, HasSubstr("<svg>1</svg><svg>2</svg>"));
  EXPECT_THAT(html, HasSubstr(std::string(kBlue)));
}

TEST(PlotStyles, EightLinesDiffer) {
  std::vector<std::string> styles;
  for (std::size_t i = 0; i < 8; ++i) {
    const std::string style = stroke(style_of(i));
    EXPECT_THAT(styles, Not(::testing::Contains(style))) << i;
    styles.push_back(style);
  }
}

}  // namespace
}  // namespace bw
