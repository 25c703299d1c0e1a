// Jacobians of the segment residuals against numerical differentiation (central differences of fourth order).
#include "components/local_planner/teb/segment_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::teb {
namespace {

using States = std::array<double, 12>;
using Residuals = std::array<double, kSegmentResiduals>;

constexpr std::uint64_t kSeed = 20;

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

States random_states(Random& random) {
  States s{};
  for (std::size_t pose = 0; pose < 3; ++pose) {
    const std::size_t i = 4 * pose;
    s[i] = static_cast<double>(pose) * random.uniform(-0.2, 0.5) + random.uniform(-0.1, 0.1);
    s[i + 1] = random.uniform(-0.3, 0.3);
    s[i + 2] = random.uniform(-3.1, 3.1);
    s[i + 3] = random.uniform(0.1, 0.6);
  }
  s[6] = s[2] + random.uniform(-1.0, 1.0);
  s[10] = s[6] + random.uniform(-1.0, 1.0);
  return s;
}

// Near its kinks a hinge has no derivative, and near zero motion the package's sign has no second one.
bool near_kink(const Residuals& low, const Residuals& mid, const Residuals& high, std::size_t row) {
  return (low[row] > 0.0) != (mid[row] > 0.0) || (high[row] > 0.0) != (mid[row] > 0.0);
}

TEST(SegmentCost, JacobianEqualsNumericalDifferentiation) {
  Random random(kSeed);
  BandOptions options;
  Limits limits;
  limits.v_max = 0.4;
  limits.omega_max = 0.3;
  limits.acc_max = limits.alpha_max = 0.5;
  double worst = 0.0;
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const States states = random_states(random);
    const Twist2 start{random.uniform(-0.2, 0.5), random.uniform(-0.4, 0.4)};
    for (const SegmentEnd end : {SegmentEnd::next_segment, SegmentEnd::rest, SegmentEnd::free}) {
      for (const bool consistent : {false, true}) {
        options.consistent_motion = consistent;
        const SegmentModel model(options, limits);
        const Case c{end, consistent, i % 2 == 0};
        std::array<double, kSegmentResiduals * kSegmentColumns> J{};
        const Residuals mid = evaluate(model, states, c, start, J.data());
        for (std::size_t column = 0; column < kSegmentColumns; ++column) {
          const double h = 1e-5;
          const auto at = [&](double step) {
            States moved = states;
            moved[column] += step;
            return evaluate(model, moved, c, start, nullptr);
          };
          const Residuals m2 = at(-2 * h), m1 = at(-h), p1 = at(h), p2 = at(2 * h);
          for (std::size_t row = 0; row < kSegmentResiduals; ++row) {
            const double scale = std::abs(J[row * kSegmentColumns + column]) + 1.0;
            if (near_kink(m2, mid, p2, row)) continue;
            const double numeric = (m2[row] - 8 * m1[row] + 8 * p1[row] - p2[row]) / (12 * h);
            worst = std::max(worst, std::abs(numeric - J[row * kSegmentColumns + column]) / scale);
            ++compared;
          }
        }
      }
    }
  }
  RecordProperty("worst_relative_error", std::to_string(worst));
  EXPECT_GT(compared, 1'000'000) << "seed " << kSeed;
  EXPECT_LE(worst, 1e-6) << "seed " << kSeed;
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
