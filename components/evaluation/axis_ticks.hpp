// Round numbers along an axis, and how they are written.
#pragma once

#include <string>
#include <vector>

namespace bw {

/// The smallest of 1, 2 and 5 times a power of ten that divides low to high into at most `most` steps. `high` must
/// be above `low`.
double round_step(double low, double high, int most);

/// Multiples of `step` from low to high, both included where they are multiples.
std::vector<double> ticks_between(double low, double high, double step);

/// The end of an axis from 0 that shows `value`: a round number at or above it; 1 for what is not above 0.
double round_end(double value);

/// Powers of ten from low to high; both above 0.
std::vector<double> decades_between(double low, double high);

/// With as many decimals as `step` needs: 0.25 in steps of 0.05 is "0.25", 20 in steps of 10 is "20".
std::string tick_text(double value, double step);

}  // namespace bw
