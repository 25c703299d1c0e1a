#include "components/lab/comparison/rate_interval.hpp"

#include <algorithm>
#include <cmath>

namespace bw {

Interval wilson95(int successes, int count) {
  if (count == 0) return {0.0, 1.0};
  constexpr double z = 1.959963985;
  const double n = count;
  const double p = successes / n;
  const double centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

}  // namespace bw
