// The one rule for quantiles: nearest rank, the smallest sample below or at which at least `share` of all
// lie.
// It is always a sample that occurred.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bw {

/// Index, counted from 0, of the quantile `share` in [0, 1] among `count` > 0 sorted samples.
inline std::size_t nearest_rank(std::size_t count, double share) {
  const double rank = std::ceil(share * static_cast<double>(count));
  return static_cast<std::size_t>(std::clamp(rank - 1.0, 0.0, static_cast<double>(count - 1)));
}

/// 0 without samples.
inline double quantile(std::vector<double> samples, double share) {
  if (samples.empty()) return 0.0;
  const auto nth = samples.begin() + static_cast<std::ptrdiff_t>(nearest_rank(samples.size(), share));
  std::nth_element(samples.begin(), nth, samples.end());
  return *nth;
}

}  // namespace bw
