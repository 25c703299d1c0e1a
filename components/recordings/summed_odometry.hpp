// An odometry from what a base was told, or from what its wheels did.
#pragma once

#include <algorithm>
#include <vector>

#include "components/recordings/recorded_drive.hpp"

namespace bw {

/// Commands, each held until the next.
class SummedCommands {
 public:
  static constexpr Duration kLongestStep = Duration::milliseconds(100);  // a command may be held for a second
  static constexpr Duration kLongestHold = Duration::milliseconds(60'000);

  /// Adds to `odometry` what the command before did until `time`. False: it was not zero and held longer than
  /// kLongestHold. Commands that are not newer than the one before replace it.
  [[nodiscard]] bool add(Time time, const Twist2& command, std::vector<OdometrySample>& odometry) {
    if (odometry.empty()) odometry.push_back({time, {}, {}});
    const bool is_still = held_ == Twist2{};
    if (!is_still && time - odometry.back().time > kLongestHold) return false;
    while (odometry.back().time < time)
      odometry.push_back(
          advance(odometry.back(), held_, std::min(time, odometry.back().time + kLongestStep)));
    held_ = command;
    return true;
  }

 private:
  Twist2 held_;
};

/// Adds to `odometry` what the base did with `twist` since the sample before.
inline void add_measured(Time time, const Twist2& twist, std::vector<OdometrySample>& odometry) {
  if (odometry.empty()) {
    odometry.push_back({time, {}, twist});
  } else if (time > odometry.back().time) {
    odometry.push_back(advance(odometry.back(), twist, time));
  }
}

}  // namespace bw
