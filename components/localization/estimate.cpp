#include "components/localization/estimate.hpp"

#include <cmath>

#include "components/model/chi_square.hpp"
#include "components/model/principal_deviations.hpp"

namespace bw::localization {

Vector2 ellipse_95(const Eigen::Matrix2d& P) {
  return std::sqrt(chi_square_quantile(0.95, 2)) * principal_deviations(P);
}

}  // namespace bw::localization
