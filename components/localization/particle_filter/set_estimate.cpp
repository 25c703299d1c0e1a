#include "components/localization/particle_filter/set_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "components/localization/particle_filter/moments.hpp"

namespace bw::localization {
namespace {

constexpr double kOneGroup = 0.3;     // [m] standard deviation of a set that needs no grouping
constexpr double kOneHeading = 0.3;   // [rad] the same
constexpr double kNegligible = 0.01;  // of the heaviest bin: lighter ones join no group

SetEstimate weighted(const ParticleSet& p, const std::vector<double>& weight) {
  SetEstimate e;
  if (p.size() == 0) return e;
  const double x0 = p.x[0];
  const double y0 = p.y[0];
  const FirstMoments m =
      first_moments(p.x.data(), p.y.data(), p.theta.data(), weight.data(), p.size(), x0, y0);
  e.X_MB = {x0 + m.x / m.weight, y0 + m.y / m.weight, std::atan2(m.sin, m.cos)};
  const SecondMoments s = second_moments(p.x.data(), p.y.data(), p.theta.data(), weight.data(), p.size(),
                                         e.X_MB.x, e.X_MB.y, e.X_MB.theta);
  e.covariance << s.xx, s.xy, s.xt, s.xy, s.yy, s.yt, s.xt, s.yt, s.tt;
  e.covariance /= m.weight;
  e.share = m.weight;
  return e;
}

}  // namespace

SetEstimate estimate_of(const ParticleSet& particles) {
  SetEstimate estimate = weighted(particles, particles.weight);
  estimate.share = 1.0;
  return estimate;
}

SetEstimate estimate_of_heaviest(const ParticleSet& particles, PoseHistogram& histogram) {
  const SetEstimate all = estimate_of(particles);
  const Eigen::Matrix3d& C = all.covariance;
  if (std::max(C(0, 0), C(1, 1)) <= kOneGroup * kOneGroup && C(2, 2) <= kOneHeading * kOneHeading) return all;
  histogram.fill(particles);
  const int heaviest = histogram.group(kNegligible);
  std::vector<double> weight = particles.weight;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (histogram.group_of()[histogram.bin_of()[i]] != heaviest) weight[i] = 0.0;
  }
  return weighted(particles, weight);
}

}  // namespace bw::localization
