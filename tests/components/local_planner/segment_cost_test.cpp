// Residuals of one segment; their Jacobian is tested in band_jacobian_test.cpp.
#include "components/local_planner/teb/segment_cost.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace bw::teb {
namespace {

using States = std::array<double, 12>;
using Residuals = std::array<double, kSegmentResiduals>;

struct Case {
  SegmentEnd end;
  bool consistent_motion;
  bool at_start;
};

Residuals evaluate(const SegmentModel& model, const States& s, const Case& c, const Twist2& start,
                   double* jacobian) {
  Residuals r{};
  const SegmentStates states{&s[0], &s[4], c.end == SegmentEnd::next_segment ? &s[8] : nullptr, c.end,
                             c.at_start ? &start : nullptr};
  EXPECT_TRUE(evaluate_segment(model, states, r.data(), jacobian));
  return r;
}

TEST(SegmentCost, CoincidentPosesGiveFiniteDerivatives) {
  const Limits limits;
  for (const bool consistent : {false, true}) {
    BandOptions options;
    options.consistent_motion = consistent;
    const SegmentModel model(options, limits);
    const States states{1, 2, 0.5, 0.3, 1, 2, 0.5, 0.3, 1, 2, 0.5, 0.3};
    std::array<double, kSegmentResiduals * kSegmentColumns> J{};
    const Residuals r = evaluate(model, states, {SegmentEnd::next_segment, consistent, true}, {}, J.data());
    for (const double value : r) EXPECT_TRUE(std::isfinite(value));
    for (const double value : J) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(SegmentCost, VanishesApartFromTimeOnAnArcWithinLimits) {
  // 0.5 m/s and 0.4 rad/s held for 0.3 s each: one arc, constant speed, inside v 1, omega 1.
  const SegmentModel model(BandOptions{}, Limits{});
  const double turn = 0.12, chord = 0.5 * 0.3 * std::sin(turn / 2) / (turn / 2);
  States s{0, 0, 0,        0.3, chord * std::cos(turn / 2), chord * std::sin(turn / 2), turn, 0.3,
           0, 0, 2 * turn, 0.3};
  s[8] = s[4] + chord * std::cos(1.5 * turn);
  s[9] = s[5] + chord * std::sin(1.5 * turn);
  const Residuals r = evaluate(model, s, {SegmentEnd::next_segment, true, false}, {}, nullptr);
  EXPECT_DOUBLE_EQ(r[0], 0.3);
  for (std::size_t i = 1; i < r.size(); ++i) EXPECT_NEAR(r[i], 0.0, 1e-12) << i;
}

TEST(SegmentCost, RefusesIntervalsTooShortToDivideBy) {
  const SegmentModel model(BandOptions{}, Limits{});
  for (const double dt : {0.0, -0.1, 1e-4, std::nan("")}) {
    const States s{0, 0, 0, dt, 0.1, 0, 0, 0.3, 0.2, 0, 0, 0.3};
    Residuals r{};
    EXPECT_FALSE(
        evaluate_segment(model, {&s[0], &s[4], &s[8], SegmentEnd::next_segment, nullptr}, r.data(), nullptr));
  }
}

}  // namespace
}  // namespace bw::teb
