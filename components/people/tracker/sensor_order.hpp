// Sweeps of several sensors in one row: whose sweep comes next, and by whom the errors of odometry are told.
#pragma once

#include <map>
#include <optional>

#include "runtime/base/time.hpp"

namespace bw::people {

class SensorOrder {
 public:
  /// Whether a sweep of `source` at `time` comes next when the last one of any was at `now`: later, or at the
  /// same time by another.
  bool comes_next(int source, Time time, Time now) const {
    if (time != now) return time > now;
    const auto known = last_.find(source);
    return known == last_.end() || known->second < time;
  }

  /// Takes it. Seconds since the sensor's own sweep before; 0 for its first and after a silence of
  /// `longest_gap` [s].
  double add(int source, Time time, double longest_gap) {
    const auto [known, is_new] = last_.try_emplace(source, time);
    const double since = is_new ? 0.0 : (time - known->second).to_seconds();
    known->second = time;
    return since <= longest_gap ? since : 0.0;
  }

  /// Whether `source` tells the errors of odometry: one does at a time, the first to sweep, for as long as it
  /// is not silent for `kSilence`. `changed`: it has just taken over.
  bool leads(int source, Time time, bool& changed) {
    constexpr Duration kSilence = Duration::milliseconds(500);
    changed = leader_ && *leader_ != source && time - led_ > kSilence;
    if (!leader_ || changed) leader_ = source;
    if (*leader_ != source) return false;
    led_ = time;
    return true;
  }

  void reset() {
    last_.clear();
    leader_.reset();
  }

 private:
  std::map<int, Time> last_;
  std::optional<int> leader_;
  Time led_;
};

}  // namespace bw::people
