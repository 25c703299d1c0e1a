// Sums over a set, in whatever order is fastest.
#pragma once

#include <cstddef>

namespace bw::localization {

struct FirstMoments {
  double weight, x, y, sin, cos;
};
struct SecondMoments {
  double xx, xy, yy, xt, yt, tt;
};

/// Weighted sums; positions relative to (x0, y0), so that far ones keep their digits.
FirstMoments first_moments(const double* x, const double* y, const double* theta, const double* weight,
                           std::size_t count, double x0, double y0);
/// Weighted sums of products of deviations from (x0, y0, theta0); angles wrapped, |theta - theta0| <= 2 pi.
SecondMoments second_moments(const double* x, const double* y, const double* theta, const double* weight,
                             std::size_t count, double x0, double y0, double theta0);

}  // namespace bw::localization
