#include "components/local_planner/teb/narrow_passage.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace bw::teb {
namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();
constexpr double kWanted = 0.2;

/// What is wanted from each of two points, at (0, left) and (x, -right), by a disc of 0.2 m at the origin.
std::vector<double> wanted(double left, const Vector2& right, bool moving = false, double fraction = 0.0) {
  std::vector<ClearanceTerm> terms(2);
  terms[0].capsule = {{0.0, left}, {0.0, left}, 0.0};
  terms[1].capsule = {right, right, 0.0};
  terms[1].moving = moving;
  terms[1].fraction = fraction;
  allow_narrow_passages(terms, {.radius = 0.2}, {}, {}, kWanted, 0.02);
  return {terms[0].wanted, terms[1].wanted};
}

TEST(NarrowPassage, HalfOfWhatIsLeftIsWantedAtEitherSide) {
  // 0.3 and 0.26 m from the middle of a disc of 0.2 m: 0.1 and 0.06 m are left, 0.08 m at either side of the
  // middle.
  const auto found = wanted(0.3, {0.0, -0.26});
  EXPECT_NEAR(found[0], 0.08, 1e-12);
  EXPECT_NEAR(found[1], 0.08, 1e-12);
}

TEST(NarrowPassage, WhereThereIsRoomNothingChanges) { EXPECT_EQ(wanted(0.41, {0.0, -0.41})[0], kAll); }

TEST(NarrowPassage, WhereThereIsNoWayNothingChanges) { EXPECT_EQ(wanted(0.21, {0.0, -0.22})[0], kAll); }

TEST(NarrowPassage, IsSeenFromOutside) {
  // From (0, 0) to posts at (0.3, 0.28) and (0.3, -0.28): 0.56 m apart, 0.08 m at either side of a disc of
  // 0.2 m.
  std::vector<ClearanceTerm> terms(2);
  terms[0].capsule = {{0.3, 0.28}, {0.3, 0.28}, 0.0};
  terms[1].capsule = {{0.3, -0.28}, {0.3, -0.28}, 0.0};
  allow_narrow_passages(terms, {.radius = 0.2}, {}, {}, kWanted, 0.02);
  EXPECT_NEAR(terms[0].wanted, 0.08, 1e-12);
  EXPECT_NEAR(terms[1].wanted, 0.08, 1e-12);
}

TEST(NarrowPassage, IsNoneWhereAnObstacleStandsBetween) {
  // A wall ahead of points 0.1 m apart: two of them are as far apart as the posts of a passage.
  std::vector<ClearanceTerm> terms(8);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Vector2 point(0.3, -0.35 + 0.1 * static_cast<double>(i));
    terms[i].capsule = {point, point, 0.0};
  }
  allow_narrow_passages(terms, {.radius = 0.2}, {}, {}, kWanted, 0.02);
  for (const ClearanceTerm& term : terms) EXPECT_EQ(term.wanted, kAll);
}

TEST(NarrowPassage, TouchingCostsWhatItCostsElsewhere) {
  const Footprint robot{.radius = 0.2};
  const ClearanceModel model(BandOptions{}, robot, 1.0);
  ClearanceTerm term;
  term.capsule = {{0.2, 0.0}, {0.2, 0.0}, 0.0};  // it touches
  const double elsewhere = evaluate_clearance(model, term, {}, nullptr);
  term.wanted = 0.05;
  // Inflation, 0.1 (0.3 m)^2, is the same; the rest of the cost is 50 (0.22 m)^2 in both.
  EXPECT_NEAR(evaluate_clearance(model, term, {}, nullptr), elsewhere, 1e-12);
  EXPECT_NEAR(elsewhere * elsewhere, 50.0 * 0.22 * 0.22 + 0.1 * 0.3 * 0.3, 1e-12);
  EXPECT_NEAR(evaluate_clearance(model, term, {-0.05, 0.0, 0.0}, nullptr), std::sqrt(0.1) * 0.25, 1e-12);
}

TEST(NarrowPassage, HasItsSidesLeftAndRightAtOnePlaceAndStanding) {
  EXPECT_EQ(wanted(0.3, {0.3, 0.1})[0], kAll);
  EXPECT_EQ(wanted(0.3, {0.0, -0.3}, true)[0], kAll);
  EXPECT_EQ(wanted(0.3, {0.0, -0.3}, false, 0.5)[0], kAll);
}

}  // namespace
}  // namespace bw::teb
