// How long the work of a replay took, as figures.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace bw {

/// The least value that `share` of the samples do not exceed; 0 without samples.
inline double quantile(std::vector<double> samples, double share) {
  if (samples.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(samples.size())));
  const auto at =
      samples.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, samples.size()) - 1);
  std::nth_element(samples.begin(), at, samples.end());
  return *at;
}

}  // namespace bw
