// So many in a second, and a burst of so many.
#pragma once

#include <algorithm>

namespace bw::web {

class Rate {
 public:
  Rate(double per_second, double burst) : per_second_(per_second), burst_(burst), left_(burst) {}

  /// `now` of a steady clock [s].
  bool take(double now) {
    left_ = std::min(burst_, left_ + (now - last_) * per_second_);
    last_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  double per_second_;
  double burst_;
  double left_;
  double last_ = 0;
};

}  // namespace bw::web
