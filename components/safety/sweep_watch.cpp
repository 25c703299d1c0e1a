#include "components/safety/sweep_watch.hpp"

#include <cmath>
#include <cstring>

namespace bw::safety {
namespace {

// Farther than this a laser that works sees other ranges.
constexpr double kMoved = 0.01;    // [m]
constexpr double kRotated = 0.01;  // [rad]

bool have_equal_bytes(std::span<const float> a, std::span<const float> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

bool SweepWatch::add(Time now, Time measured_at, std::span<const float> ranges, SweepFault fault,
                     const Pose2& X_OB) {
  const bool repeated = stamp_ && measured_at <= *stamp_;
  arrived_at_ = now;
  stamp_ = measured_at;
  if (fault != SweepFault::none) {
    last_ = LaserState::invalid;
    return false;
  }
  bool sees_something = false;
  for (const float range : ranges) sees_something = sees_something || std::isfinite(range);
  const Pose2 moved = inverse(X_OB_) * X_OB;
  const bool has_moved = std::hypot(moved.x, moved.y) > kMoved || std::abs(moved.theta) > kRotated;
  const bool is_same = sees_something && have_equal_bytes(ranges, ranges_);
  if (repeated || (is_same && has_moved)) {
    last_ = LaserState::frozen;
    return false;
  }
  if (!is_same) {
    ranges_.assign(ranges.begin(), ranges.end());
    X_OB_ = X_OB;
  }
  last_ = LaserState::ok;
  fresh_at_ = now;
  return true;
}

void SweepWatch::forget(Time now) {
  if (fresh_at_) fresh_at_ = now - timeout_ - Duration{1};
  arrived_at_.reset();
  stamp_.reset();
}

LaserState SweepWatch::state(Time now) const {
  if (fresh_at_ && now - *fresh_at_ <= timeout_) return LaserState::ok;
  if (arrived_at_ && now - *arrived_at_ <= timeout_ && last_ != LaserState::ok) return last_;
  return fresh_at_ ? LaserState::silent : LaserState::waiting;
}

}  // namespace bw::safety
