#include "runtime/host/lane_watch.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/host/service_manager.hpp"

namespace bw {

LaneWatch::LaneWatch(const ServiceManager& manager) : manager_(manager) {
  if (manager.watchdog() == Duration{}) return;
  constexpr std::int64_t kPasses = 4;  // within the manager's patience
  period_ = Duration{manager.watchdog().nanoseconds / kPasses};
  least_bound_ = manager.watchdog() - period_;
}

LaneWatch::Lane& LaneWatch::add(const std::string& name, Duration longest, Duration now) {
  Lane& lane = lanes_.emplace_back();
  lane.name = name;
  lane.bound = std::max(longest, least_bound_);
  lane.passed_ns = now.nanoseconds;
  return lane;
}

void LaneWatch::pass(Lane& lane, Duration now) {
  if (period_ == kForever) return;
  lane.passed_ns = now.nanoseconds;
  const std::unique_lock lock(telling_, std::try_to_lock);
  if (!lock || is_hanging_ || now - told_ < period_) return;
  told_ = now;
  for (const Lane& other : lanes_) {
    const Duration since = now - Duration{other.passed_ns};
    if (since <= other.bound) continue;
    is_hanging_ = true;
    return manager_.hangs(
        fmt::format("lane {} has not come back for {:.2f} s", other.name, since.to_seconds()));
  }
  manager_.alive();
}

}  // namespace bw
