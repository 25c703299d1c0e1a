// A figure that was asked for and is not reached. The test says what was asked and what was last measured,
// and is held to that: a loss beyond chance fails. Tests with such figures are CTest entries of the label
// `shortfall` (SHORTFALL of bw_test): ctest -L shortfall -V.
#pragma once

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace bw::test {

struct Shortfall {
  double asked = 0.0;
  double measured =
      0.0;  ///< by this test when it was last looked at: what the READMEs claim comes from the same program
  double noise =
      0.0;  ///< how far chance moves the figure (one-sided 95 %) when something else changes, or another CPU rounds
};

inline constexpr double kOneSided95 = 1.645;  ///< of a normal distribution

/// Of a share of `count` independent trials.
inline double binomial_noise(double share, double count) {
  return kOneSided95 * std::sqrt(share * (1.0 - share) / count);
}

/// Of a rate per unit, counted over `units`: independent events.
inline double poisson_noise(double rate, double units) { return kOneSided95 * std::sqrt(rate / units); }

/// `reached` should be at least `asked`; it must be at least what was measured, less the noise.
inline void expect_at_least(const char* what, const Shortfall& figure, double reached) {
  const double kept = figure.measured - figure.noise;
  std::printf("%s: asked >= %g, reached %.4g%s, measured %g, kept at %.4g\n", what, figure.asked, reached,
              reached >= figure.asked ? "" : " (falls short)", figure.measured, kept);
  EXPECT_GE(reached, kept - 1e-9) << what;
}

/// `reached` should be at most `asked`; it must be at most what was measured, and the noise.
inline void expect_at_most(const char* what, const Shortfall& figure, double reached) {
  const double kept = figure.measured + figure.noise;
  std::printf("%s: asked <= %g, reached %.4g%s, measured %g, kept at %.4g\n", what, figure.asked, reached,
              reached <= figure.asked ? "" : " (falls short)", figure.measured, kept);
  EXPECT_LE(reached, kept + 1e-9) << what;
}

}  // namespace bw::test
