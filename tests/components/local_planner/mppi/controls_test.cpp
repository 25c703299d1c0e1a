#include "components/local_planner/mppi/controls.hpp"

#include <gtest/gtest.h>

namespace bw::mppi {
namespace {

constexpr double kDt = 0.05;

TEST(Controls, KeepTheLimitsOfTheBase) {
  const Limits limits{.v_max = 1.0, .v_back_max = 0.2, .omega_max = 0.5, .acc_max = 2.0, .alpha_max = 4.0};
  Controls controls(5);
  controls.v << 3.0, 1.0, 0.0, 0.95, -9.0;
  controls.omega << -2.0, 2.0, 0.0, 0.1, 0.15;
  controls.limit(limits, kDt);
  // First into [-0.2, 1], then no more than 2 m/s^2 0.05 s = 0.1 m/s from the one before.
  const double v[] = {1.0, 1.0, 0.9, 0.95, 0.85};
  // Into [-0.5, 0.5], no more than 0.2 rad/s from the one before.
  const double omega[] = {-0.5, -0.3, -0.1, 0.1, 0.15};
  for (Eigen::Index k = 0; k < 5; ++k) {
    EXPECT_NEAR(controls.v[k], v[k], 1e-12) << k;
    EXPECT_NEAR(controls.omega[k], omega[k], 1e-12) << k;
  }
}

// A least-squares parabola reproduces one, and by symmetry of the window a cubic as well; the four before
// belong to it.
TEST(Controls, SmoothingReproducesPolynomials) {
  const auto cubic = [](double k) { return 0.3 - 0.02 * k + 0.001 * k * k - 1e-5 * k * k * k; };
  const auto parabola = [](double k) { return -0.1 + 0.05 * k - 0.0008 * k * k; };
  Controls controls(60);
  for (Eigen::Index k = 0; k < 60; ++k) {
    controls.v[k] = cubic(static_cast<double>(k));
    controls.omega[k] = parabola(static_cast<double>(k));
  }
  controls.shift(4.0);  // now 0 to 3 are the ones before
  controls.smooth();
  for (Eigen::Index k = 0; k < 51; ++k) {
    EXPECT_NEAR(controls.v[k], cubic(static_cast<double>(k) + 4.0), 1e-12) << k;
    EXPECT_NEAR(controls.omega[k], parabola(static_cast<double>(k) + 4.0), 1e-12) << k;
  }
}

// A peak of 1 becomes the window: (-21, 14, 39, 54, 59, 54, 39, 14, -21) / 231 (Savitzky and Golay 1964,
// table I).
TEST(Controls, SmoothingHasTheWindowOfNinePoints) {
  Controls controls(40);
  controls.v[20] = 1.0;
  controls.smooth();
  const double window[] = {-21, 14, 39, 54, 59, 54, 39, 14, -21};
  for (Eigen::Index k = 0; k < 40; ++k) {
    const bool inside = k >= 16 && k <= 24;
    EXPECT_NEAR(controls.v[k], inside ? window[k - 16] / 231.0 : 0.0, 1e-15) << k;
  }
  Controls last(40);
  last.v[39] = 1.0;
  last.smooth();
  EXPECT_EQ(last.v[39], 1.0);
  EXPECT_NEAR(last.v[38], (54.0 + 39.0 + 14.0 - 21.0) / 231.0, 1e-15);  // it goes on beyond the end

  Controls few(20);
  few.v[10] = 1.0;
  few.smooth();
  EXPECT_EQ(few.v[10], 1.0);
}

TEST(Controls, ShiftInTimeBetweenSteps) {
  Controls controls(6);
  controls.v << 0, 1, 2, 3, 4, 5;
  controls.omega << 0, -1, -4, -9, -16, -25;
  EXPECT_EQ(controls.at(1.5), (Twist2{1.5, -2.5}));
  EXPECT_EQ(controls.at(9.0), (Twist2{5.0, -25.0}));
  EXPECT_EQ(controls.at(-2.0), (Twist2{0.0, 0.0}));
  controls.shift(1.5);
  const double v[] = {1.5, 2.5, 3.5, 4.5, 5.0, 5.0};
  for (Eigen::Index k = 0; k < 6; ++k) EXPECT_EQ(controls.v[k], v[k]) << k;
  EXPECT_EQ(controls.at(-1.0), (Twist2{0.5, -0.5}));
  EXPECT_EQ(controls.at(-1.5), (Twist2{0.25, -0.25}));  // between -1 and -2, which was before the start
  EXPECT_EQ(controls.at(-4.0), (Twist2{0.0, 0.0}));
  controls.shift(100.0);
  EXPECT_EQ(controls.at(0.0), (Twist2{5.0, -25.0}));
  controls.reset(6);
  EXPECT_EQ(controls.at(-4.0), (Twist2{0.0, 0.0}));
  EXPECT_EQ(controls.at(5.0), (Twist2{0.0, 0.0}));
}

}  // namespace
}  // namespace bw::mppi
