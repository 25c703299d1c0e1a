#include "components/model/footprint_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/footprint_distance.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

using ::testing::HasSubstr;

constexpr const char* kRectangle = "[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]";

TEST(FootprintOutline, NavTwosTextIsRead) {
  const FootprintResult result = footprint_of(kRectangle, 0.1);
  ASSERT_EQ(result.fault, "");
  const Footprint& rectangle = result.footprint;
  ASSERT_EQ(rectangle.polygon.size(), 4U);
  EXPECT_DOUBLE_EQ(rectangle.radius, std::hypot(0.255, 0.215));
  EXPECT_DOUBLE_EQ(inscribed_radius(rectangle), 0.215);
  EXPECT_EQ(rectangle.polygon[1], Vector2(-0.255, 0.215));
  // Without commas, clockwise, the first corner repeated, one within a side: the same outline.
  const FootprintResult other = footprint_of(
      " [ [0.255 -0.215] [-0.255 -0.215],[-.255,.215] [0 0.215] [+0.255 0.215] [0.255 -0.215] ] ", 0.1);
  ASSERT_EQ(other.fault, "");
  EXPECT_EQ(other.footprint.polygon.size(), 4U);
  EXPECT_DOUBLE_EQ(inscribed_radius(other.footprint), 0.215);
}

TEST(FootprintOutline, WithoutCornersItIsTheDisc) {
  for (const char* text : {"", "  ", "[]", " [ ] "}) {
    const FootprintResult result = footprint_of(text, 0.22);
    EXPECT_EQ(result.fault, "") << text;
    EXPECT_FALSE(result.footprint.is_polygon()) << text;
    EXPECT_EQ(result.footprint.radius, 0.22) << text;
  }
}

TEST(FootprintOutline, WhatIsNoOutlineIsRefusedWithItsRule) {
  const auto fault = [](const std::string& text) { return footprint_of(text, 0.3).fault; };
  for (const char* text : {"0.3", "[[1, 2], [3]]", "[[1, 2], [3, 4]", "[[1, 2, 3]]", "[[a, b]]", "[[]]",
                           "[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2]] x"})
    EXPECT_THAT(fault(text), HasSubstr("must be a list of corners")) << text;
  EXPECT_THAT(fault("[[0.2, 0.2], [-0.2, -0.2]]"), HasSubstr("three corners"));
  EXPECT_THAT(fault("[[0.2, 0], [-0.2, 0], [0, 0], [0.1, 0]]"), HasSubstr("three corners"));
  EXPECT_THAT(fault("[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [nan, -0.2]]"), HasSubstr("finite"));
  EXPECT_THAT(fault("[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [inf, -0.2]]"), HasSubstr("finite"));
  EXPECT_THAT(fault("[[5.1, 0], [-0.2, 0.2], [-0.2, -0.2]]"), HasSubstr("farther than 5 m"));
  // An arrow: the corner at its tail lies inside.
  EXPECT_THAT(fault("[[0.5, 0], [-0.5, 0.4], [-0.2, 0], [-0.5, -0.4]]"), HasSubstr("inwards"));
  EXPECT_THAT(fault("[[1.5, 0.2], [1.1, 0.2], [1.1, -0.2], [1.5, -0.2]]"), HasSubstr("base_link"));
  EXPECT_THAT(fault("[[0.5, 0.2], [0, 0.2], [0, -0.2], [0.5, -0.2]]"), HasSubstr("base_link"));
  std::string star = "[", many = "[";
  for (int i = 0; i < 5; ++i)
    star += "[" + std::to_string(std::cos(1.6 * std::numbers::pi / 2 * i)) + "," +
            std::to_string(std::sin(1.6 * std::numbers::pi / 2 * i)) + "]";
  EXPECT_THAT(fault(star + "]"), HasSubstr("crosses itself"));
  for (int i = 0; i < 65; ++i)
    many += "[" + std::to_string(std::cos(2 * std::numbers::pi / 65 * i)) + "," +
            std::to_string(std::sin(2 * std::numbers::pi / 65 * i)) + "]";
  EXPECT_THAT(fault(many + "]"), HasSubstr("64 corners"));
}

/// A convex polygon around base_link with corners on an ellipse.
Footprint random_footprint(Random& random) {
  const double a = random.uniform(0.2, 0.6), b = random.uniform(0.2, 0.6);
  std::vector<Vector2> corners;
  const int count = 3 + static_cast<int>(random.uniform(0.0, 7.0));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / count;
    corners.emplace_back(a * std::cos(angle), b * std::sin(angle));
  }
  return footprint_of(std::move(corners)).footprint;
}

TEST(FootprintOutline, TextReadsBackTheSame) {
  Random random(301);
  for (int i = 0; i < 1000; ++i) {
    const Footprint footprint = random_footprint(random);
    if (!footprint.is_polygon()) continue;  // three corners may lie to one side
    const FootprintResult again = footprint_of(to_text(footprint), 0.0);
    ASSERT_EQ(again.fault, "") << to_text(footprint);
    EXPECT_EQ(again.footprint.polygon, footprint.polygon);
    EXPECT_EQ(again.footprint.radius, footprint.radius);
  }
  EXPECT_EQ(to_text(Footprint{0.3, {}}), "[]");
}

// A rectangle's sides move out by the padding, so that its corners are again a rectangle's.
TEST(FootprintOutline, PaddingMovesTheSides) {
  const Footprint wide = padded(footprint_of(kRectangle, 0.0).footprint, 0.1);
  ASSERT_EQ(wide.polygon.size(), 4U);
  EXPECT_NEAR(wide.radius, std::hypot(0.355, 0.315), 1e-12);
  EXPECT_NEAR(inscribed_radius(wide), 0.315, 1e-12);
  const Footprint core = padded(wide, -0.1);
  EXPECT_NEAR(core.radius, std::hypot(0.255, 0.215), 1e-12);
  // No thinner than half, whatever is asked for.
  EXPECT_NEAR(inscribed_radius(padded(wide, -1.0)), 0.1575, 1e-12);
  EXPECT_EQ(padded(Footprint{0.3, {}}, 0.05).radius, 0.3 + 0.05);
}

TEST(FootprintOutline, WhatIsNearerThanThePaddingLiesInside) {
  Random random(302);
  int near = 0, outside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Footprint footprint = random_footprint(random);
    if (!footprint.is_polygon()) continue;
    const double by = random.uniform(0.0, 0.3);
    const Footprint wide = padded(footprint, by);
    for (int k = 0; k < 20; ++k) {
      const Vector2 p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const double gap = gap_to(footprint, {}, {p, p, 0.0});
      const double gap_of_wide = gap_to(wide, {}, {p, p, 0.0});
      near += gap < by;
      outside += gap_of_wide > 0.0;
      if (gap < by - 1e-9) {
        EXPECT_LT(gap_of_wide, 1e-9);
      }
      if (gap_of_wide > 1e-9) {
        EXPECT_GT(gap, by - 1e-9);
      }
    }
  }
  EXPECT_GT(near, 5000);
  EXPECT_GT(outside, 5000);
}

TEST(FootprintHull, HoldsBothAndNothingElse) {
  const Footprint square =
      footprint_of("[[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]", 0.0).footprint;
  const Footprint tail = footprint_of("[[0.1, 0.1], [-0.6, 0.1], [-0.6, -0.1], [0.1, -0.1]]", 0.0).footprint;
  EXPECT_EQ(hull({0.2, {}}, {0.3, {}}).radius, 0.3);
  EXPECT_EQ(hull({0.3, {}}, square).radius, 0.3);
  EXPECT_FALSE(hull({0.3, {}}, square).is_polygon());
  EXPECT_EQ(hull(square, {0.2, {}}).polygon, square.polygon);
  EXPECT_EQ(hull({0.001, {}}, square).polygon, square.polygon);
  // Six corners: the square's four and the two ends of the tail.
  const Footprint both = hull(square, tail);
  EXPECT_EQ(both.polygon.size(), 6U);
  EXPECT_NEAR(both.radius, std::hypot(0.6, 0.1), 1e-12);
  // A disc of 0.25 m reaches out of the square's sides, and the square's corners out of the disc.
  const Footprint round = hull({0.25, {}}, square);
  EXPECT_NEAR(inscribed_radius(round), 0.25, 0.25 * 0.005);
  EXPECT_GE(inscribed_radius(round), 0.25 - 1e-9);
  EXPECT_NEAR(round.radius, std::hypot(0.2, 0.2), 1e-12);
}

}  // namespace
}  // namespace bw
