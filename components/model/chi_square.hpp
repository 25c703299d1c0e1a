// Chi-square distribution of 1, 2 or 3 degrees of freedom, in closed form.
#pragma once

#include <cmath>
#include <numbers>

namespace bw {

/// P(chi^2 <= x); degrees of freedom 1, 2 or 3.
inline double chi_square_cdf(double x, int dof) {
  if (!(x > 0.0)) return 0.0;
  if (dof == 2) return -std::expm1(-x / 2.0);
  const double one = std::erf(std::sqrt(x / 2.0));
  return dof == 1 ? one : one - std::sqrt(2.0 * x / std::numbers::pi) * std::exp(-x / 2.0);
}

/// The x with P(chi^2 <= x) = probability, in [0, 0.999999]: 10.828, 13.816, 16.266 for 0.999.
inline double chi_square_quantile(double probability, int dof) {
  double low = 0.0;
  double high = 100.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (chi_square_cdf(middle, dof) < probability ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

}  // namespace bw
