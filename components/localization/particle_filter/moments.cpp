// Compiled with -fassociative-math, which lets the compiler sum in several registers.
#include "components/localization/particle_filter/moments.hpp"

#include <numbers>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {

BW_VECTOR_CLONES
FirstMoments first_moments(const double* __restrict x, const double* __restrict y,
                           const double* __restrict theta, const double* __restrict weight, std::size_t count,
                           double x0, double y0) {
  double w = 0.0, wx = 0.0, wy = 0.0, ws = 0.0, wc = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos t = sin_cos(static_cast<float>(theta[i]));
    w += weight[i];
    wx += weight[i] * (x[i] - x0);
    wy += weight[i] * (y[i] - y0);
    ws += weight[i] * t.sin;
    wc += weight[i] * t.cos;
  }
  return {w, wx, wy, ws, wc};
}

BW_VECTOR_CLONES
SecondMoments second_moments(const double* __restrict x, const double* __restrict y,
                             const double* __restrict theta, const double* __restrict weight,
                             std::size_t count, double x0, double y0, double theta0) {
  constexpr double kPi = std::numbers::pi;
  double xx = 0.0, xy = 0.0, yy = 0.0, xt = 0.0, yt = 0.0, tt = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = x[i] - x0;
    const double dy = y[i] - y0;
    const double rotated = theta[i] - theta0;
    const double dt = rotated > kPi ? rotated - 2.0 * kPi : rotated < -kPi ? rotated + 2.0 * kPi : rotated;
    xx += weight[i] * dx * dx;
    xy += weight[i] * dx * dy;
    yy += weight[i] * dy * dy;
    xt += weight[i] * dx * dt;
    yt += weight[i] * dy * dt;
    tt += weight[i] * dt * dt;
  }
  return {xx, xy, yy, xt, yt, tt};
}

}  // namespace bw::localization
