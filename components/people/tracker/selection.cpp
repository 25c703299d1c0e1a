#include "components/people/tracker/selection.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace bw::people {
namespace {

constexpr double kLargestVariance = 2.0;  // [m^2] of a position that says anything, both axes together

bool usable(const Detection& d, const AssociationOptions& options) {
  const Eigen::Matrix2d& c = d.covariance;
  return d.position.allFinite() && c.allFinite() && c(0, 0) > 0.0 && c.determinant() > 0.0 &&
         std::abs(c(0, 1) - c(1, 0)) <= 1e-6 * c.trace() && c.trace() <= kLargestVariance &&
         d.leg_score >= 0.0 && d.leg_score <= 1.0 && d.body_score >= 0.0 && d.body_score <= 1.0 &&
         d.width <= options.kLargest;
}

}  // namespace

void select_detections(const DetectionSet& sweep, int most, const AssociationOptions& options,
                       std::vector<Detection>& selected) {
  selected.clear();
  for (const Detection& d : sweep.detections) {
    if (!usable(d, options)) continue;
    selected.push_back(d);
    const double vague = options.vague * (1.0 - d.human_score());
    selected.back().covariance += vague * vague * Eigen::Matrix2d::Identity();
  }
  const auto count = static_cast<std::size_t>(most);
  if (selected.size() <= count) return;
  std::stable_sort(selected.begin(), selected.end(),
                   [](const Detection& a, const Detection& b) { return a.human_score() > b.human_score(); });
  selected.resize(count);
}

}  // namespace bw::people
