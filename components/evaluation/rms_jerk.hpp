// How rough a ride is: root mean square of the linear jerk, from forward speed read every h = 0.1 s (linear
// between samples).
//
//   j_k = (v_(k+1) - 2 v_k + v_(k-1)) / h^2
//
// The step h is part of the definition: figures of other steps do not compare.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "runtime/base/time.hpp"

namespace bw {

class RmsJerk {
 public:
  static constexpr Duration kStep = Duration::milliseconds(100);

  /// Forward speed `v` [m/s] at `time`; times rise.
  void add(Time time, double v) {
    if (!last_) {
      next_ = time;
    } else if (time <= last_->time) {
      return;
    }
    while (next_ <= time) {
      read(last_ ? last_->v + (v - last_->v) *
                                  ((next_ - last_->time).to_seconds() / (time - last_->time).to_seconds())
                 : v);
      next_ = next_ + kStep;
    }
    last_ = Speed{time, v};
  }

  /// [m/s^3]; 0 before three readings.
  double value() const {
    return readings_ < 3 ? 0.0 : std::sqrt(sum_of_squares_ / static_cast<double>(readings_ - 2));
  }

 private:
  struct Speed {
    Time time;
    double v = 0.0;
  };

  void read(double v) {
    if (++readings_ >= 3) {
      const double h = kStep.to_seconds();
      const double jerk = (v - 2.0 * v1_ + v2_) / (h * h);
      sum_of_squares_ += jerk * jerk;
    }
    v2_ = v1_;
    v1_ = v;
  }

  std::optional<Speed> last_;
  Time next_;
  std::int64_t readings_ = 0;
  double v1_ = 0.0;  ///< newest reading
  double v2_ = 0.0;  ///< the one before
  double sum_of_squares_ = 0.0;
};

}  // namespace bw
