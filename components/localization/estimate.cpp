#include "components/localization/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/chi_square.hpp"

namespace bw::localization {

Vector2 ellipse_95(const Eigen::Matrix2d& P) {
  const double mean = (P(0, 0) + P(1, 1)) / 2.0;
  const double half = (P(0, 0) - P(1, 1)) / 2.0;
  const double radius = std::hypot(half, P(0, 1));
  const double scale = chi_square_quantile(0.95, 2);
  return {std::sqrt(scale * std::max(0.0, mean + radius)), std::sqrt(scale * std::max(0.0, mean - radius))};
}

}  // namespace bw::localization
