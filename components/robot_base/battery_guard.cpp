#include "components/robot_base/battery_guard.hpp"

#include <algorithm>

namespace bw {

BatteryLevel BatteryGuard::read(Time now, double voltage) {
  const double enough = std::max(options_.low, options_.empty);
  const bool is_empty = lasts(empty_since_, now, voltage < options_.empty);
  const bool is_low = lasts(low_since_, now, voltage < options_.low);
  const bool is_good = lasts(good_since_, now, voltage >= enough);
  if (is_good) level_ = BatteryLevel::good;
  if (is_low && level_ == BatteryLevel::good) level_ = BatteryLevel::low;
  if (is_empty) level_ = BatteryLevel::empty;
  return level_;
}

bool BatteryGuard::lasts(std::optional<Time>& since, Time now, bool is_so) const {
  if (!is_so) since.reset();
  if (!is_so) return false;
  since = std::min(since.value_or(now), now);  // the clock may go back
  return now - *since >= Duration::seconds(options_.lasting);
}

}  // namespace bw
