// A history of bounded length, however long it lasts.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw {

/// Looks at least `period` apart; whenever there are `most` of them, every second one goes and the period doubles.
class Thinning {
 public:
  explicit Thinning(Duration period, std::size_t most = 6000) : period_(period), most_(most) {}

  bool is_due(Time time) const { return !last_ || time - *last_ >= period_; }

  /// One that is due.
  template <class Look>
  void add(Time time, Look look, std::vector<Look>& history) {
    last_ = time;
    history.push_back(std::move(look));
    if (history.size() < most_) return;
    std::vector<Look> kept;
    kept.reserve(most_);
    for (std::size_t i = 0; i < history.size(); i += 2) kept.push_back(std::move(history[i]));
    history = std::move(kept);
    period_ = period_ * 2;
  }

 private:
  Duration period_;
  std::size_t most_;
  std::optional<Time> last_;
};

}  // namespace bw
