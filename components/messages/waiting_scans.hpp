// Sweeps of a laser that wait until it is known where the robot was at their stamps: they usually come before
// the odometry of that moment.
#pragma once

#include <cstddef>
#include <deque>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "runtime/base/time.hpp"

namespace bw {

class WaitingScans {
 public:
  /// False when the oldest had to make room. `received` on the component clock.
  bool add(const sensor_msgs::msg::LaserScan& scan, Time received) {
    const bool has_room = scans_.size() < kMax;
    if (!has_room) scans_.pop_front();
    scans_.push_back({scan, received});
    return has_room;
  }

  /// Hands scans over, oldest first, for as long as use(scan, received) is true; false: what it needs may
  /// still come.
  template <class Use>
  void hand_over(Use use) {
    while (!scans_.empty() && use(scans_.front().scan, scans_.front().received)) scans_.pop_front();
  }

 private:
  static constexpr std::size_t kMax = 4;

  struct Waiting {
    sensor_msgs::msg::LaserScan scan;
    Time received;
  };
  std::deque<Waiting> scans_;
};

}  // namespace bw
