// Residuals of one segment; their Jacobian is tested in band_jacobian_test.cpp.
#include "components/local_planner/teb/segment_cost.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/components/local_planner/dense_segment.hpp"

namespace bw::teb {
namespace {

using States = std::array<double, 12>;
TEST(SegmentCost, CoincidentPosesGiveFiniteDerivatives) {
  const Limits limits;
  for (const bool consistent : {false, true}) {
    BandOptions options;
    options.consistent_motion = consistent;
    const SegmentModel model(options, limits);
    const States states{1, 2, 0.5, 0.3, 1, 2, 0.5, 0.3, 1, 2, 0.5, 0.3};
    const Twist2 start;
    const auto segment = dense_segment(model, states.data(), SegmentEnd::next_segment, &start);
    ASSERT_TRUE(segment);
    for (const double value : segment->residuals) EXPECT_TRUE(std::isfinite(value));
    for (const double value : segment->jacobian) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(SegmentCost, VanishesApartFromTimeOnAnArcWithinLimits) {
  // 0.5 m/s and 0.4 rad/s held for 0.3 s each: one arc, constant speed, inside v 1, omega 1.
  const SegmentModel model(BandOptions{}, Limits{});
  const double angle = 0.12, chord = 0.5 * 0.3 * std::sin(angle / 2) / (angle / 2);
  States s{0, 0, 0,         0.3, chord * std::cos(angle / 2), chord * std::sin(angle / 2), angle, 0.3,
           0, 0, 2 * angle, 0.3};
  s[8] = s[4] + chord * std::cos(1.5 * angle);
  s[9] = s[5] + chord * std::sin(1.5 * angle);
  const auto segment = dense_segment(model, s.data(), SegmentEnd::next_segment, nullptr);
  ASSERT_TRUE(segment);
  const auto& r = segment->residuals;
  EXPECT_DOUBLE_EQ(r[0], 0.3);
  for (std::size_t i = 1; i < r.size(); ++i) EXPECT_NEAR(r[i], 0.0, 1e-12) << i;
}

TEST(SegmentCost, RefusesIntervalsTooShortToDivideBy) {
  const SegmentModel model(BandOptions{}, Limits{});
  for (const double dt : {0.0, -0.1, 1e-4, std::nan("")}) {
    const States s{0, 0, 0, dt, 0.1, 0, 0, 0.3, 0.2, 0, 0, 0.3};
    EXPECT_FALSE(dense_segment(model, s.data(), SegmentEnd::next_segment, nullptr));
  }
}

}  // namespace
}  // namespace bw::teb
