// WATCHDOG=1 out of the lanes themselves: whoever passes looks at all others, so that it is said only while every
// lane comes back within its bound. One that does not is a hang, by name; with no lane left nobody says anything.
#pragma once

#include <atomic>
#include <deque>
#include <limits>
#include <mutex>
#include <string>

#include "runtime/base/time.hpp"

namespace bw {

class ServiceManager;

class LaneWatch {
 public:
  static constexpr Duration kForever{std::numeric_limits<std::int64_t>::max()};

  explicit LaneWatch(const ServiceManager& manager);

  struct Lane {
    std::string name;
    Duration bound;
    std::atomic<std::int64_t> passed_ns = 0;
  };
  /// A lane that begins at `now`, on the steady clock. `longest` is what its callbacks may take by their own word; no
  /// lane is held to less than what the manager's patience leaves.
  Lane& add(const std::string& name, Duration longest, Duration now);
  /// So long a lane may wait for work before it passes again; kForever where nobody watches.
  [[nodiscard]] Duration period() const { return period_; }
  /// The lane is between two callbacks. From any thread.
  void pass(Lane& lane, Duration now);

 private:
  const ServiceManager& manager_;
  Duration period_ = kForever;
  Duration least_bound_;
  std::deque<Lane> lanes_;
  std::mutex telling_;
  Duration told_;
  bool is_hanging_ = false;
};

}  // namespace bw
