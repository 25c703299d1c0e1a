// Sweeps of several lasers in the order of their stamps. They come as their drivers and the network have it:
// one waits for the odometry of its time, and for an earlier one of another laser that is due.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/laser.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

class ScanOrder {
 public:
  explicit ScanOrder(std::size_t lasers = 0) : lasers_(lasers) {}

  /// False when the oldest of this laser had to make room. `received` on the component clock.
  bool add(std::size_t laser, const sensor_msgs::msg::LaserScan& scan, Time received) {
    Laser& own = lasers_[laser];
    const Time stamp = time_of(scan);
    own.period = own.stamp ? stamp - *own.stamp : Duration{};
    own.stamp = stamp;
    own.heard = received;
    const bool has_room = own.waiting.size() < kMax;
    if (!has_room) own.waiting.pop_front();
    own.waiting.push_back({scan, received});
    return has_room;
  }

  /// Hands scans over, the earliest first, for as long as use(laser, scan) is true; false: what it needs may
  /// still come. Others do not wait for ever for a laser whose stamps nothing comes for.
  template <class Use>
  void hand_over(Time now, Use use) {
    for (Laser& laser : lasers_) laser.is_stuck = false;
    while (Laser* own = earliest()) {
      const Waiting& next = own->waiting.front();
      if (is_another_due(next, now)) return;
      if (use(static_cast<std::size_t>(own - lasers_.data()), next.scan)) {
        own->waiting.pop_front();
      } else if (now - next.received >= kPatience) {
        own->is_stuck = true;
      } else {
        return;
      }
    }
  }

  /// Whether a scan of this time waits behind the one that is handed over now.
  bool has_another_of(Time time) const {
    std::size_t count = 0;
    for (const Laser& laser : lasers_)
      for (const Waiting& waiting : laser.waiting) count += time_of(waiting.scan) == time ? 1U : 0U;
    return count > 1;
  }

 private:
  static constexpr std::size_t kMax = 4;
  static constexpr Duration kPatience = Duration::milliseconds(50);  // with a laser that is late
  static constexpr Duration kSilence = Duration::milliseconds(500);  // after which none is waited for

  struct Waiting {
    sensor_msgs::msg::LaserScan scan;
    Time received;
  };
  struct Laser {
    std::deque<Waiting> waiting;
    std::optional<Time> stamp;  ///< of its last scan
    Duration period;            ///< from the one before; zero: not known
    Time heard;
    bool is_stuck = false;  ///< in this round
  };

  Laser* earliest() {
    Laser* best = nullptr;
    for (Laser& laser : lasers_) {
      if (laser.waiting.empty() || laser.is_stuck) continue;
      if (best == nullptr || time_of(laser.waiting.front().scan) < time_of(best->waiting.front().scan))
        best = &laser;
    }
    return best;
  }

  /// A laser of which nothing waits, and whose next sweep may be no later than this one: 0.8 periods after
  /// its last.
  bool is_another_due(const Waiting& next, Time now) const {
    if (now - next.received >= kPatience) return false;
    for (const Laser& laser : lasers_) {
      if (!laser.waiting.empty() || !laser.stamp || now - laser.heard > kSilence) continue;
      if (*laser.stamp + Duration::seconds(0.8 * laser.period.to_seconds()) <= time_of(next.scan))
        return true;
    }
    return false;
  }

  std::vector<Laser> lasers_;
};

}  // namespace bw::people
