#include "components/local_planner/dwa/velocity_window.hpp"

#include <algorithm>

namespace bw::dwa {
namespace {

constexpr double kSame = 1e-9;  // values closer than this are one sample

Interval cut(const Interval& reachable, const Interval& allowed) {
  if (reachable.high < allowed.low) return {reachable.high, reachable.high};
  if (reachable.low > allowed.high) return {reachable.low, reachable.low};
  return {std::max(reachable.low, allowed.low), std::min(reachable.high, allowed.high)};
}

std::vector<double> spread(const Interval& interval, int count, double now) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    values.push_back((1.0 - share) * interval.low + share * interval.high);
  }
  for (const double wanted : {now, 0.0}) {
    if (wanted < interval.low || wanted > interval.high) continue;
    const auto same = [&](double value) { return std::abs(value - wanted) < kSame; };
    if (const auto it = std::find_if(values.begin(), values.end(), same); it != values.end()) {
      *it = wanted;
    } else {
      values.push_back(wanted);
    }
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), [](double a, double b) { return b - a < kSame; }),
               values.end());
  return values;
}

}  // namespace

VelocityWindow velocity_window(const Twist2& now, const Limits& limits, double v_cap, double time) {
  const double dv = limits.acc_max * time;
  const double domega = limits.alpha_max * time;
  return {cut({now.v - dv, now.v + dv}, {0.0, std::min(v_cap, limits.v_max)}),
          cut({now.omega - domega, now.omega + domega}, {-limits.omega_max, limits.omega_max})};
}

std::vector<Twist2> velocity_samples(const VelocityWindow& window, const Twist2& now, int v_count,
                                     int omega_count) {
  std::vector<Twist2> samples;
  const std::vector<double> omegas = spread(window.omega, omega_count, now.omega);
  for (const double v : spread(window.v, v_count, now.v)) {
    for (const double omega : omegas) samples.push_back({v, omega});
  }
  return samples;
}

}  // namespace bw::dwa
