// How sure a rate is.
#pragma once

namespace bw {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Interval of a rate at 95 % (Wilson 1927); 0 to 1 of nothing.
Interval wilson95(int successes, int count);

}  // namespace bw
