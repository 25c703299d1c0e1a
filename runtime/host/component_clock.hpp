// The clock components see when time is real, or comes from outside on /clock.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "runtime/base/time.hpp"

namespace bw {

class ComponentClock {
 public:
  virtual ~ComponentClock() = default;
  virtual Time now() const = 0;
  /// How long to sleep until `t`; nothing when the clock itself wakes its users.
  virtual std::optional<Duration> real_time_until(Time t) const = 0;
  /// Called after every step of a clock that wakes its users.
  virtual void on_step(std::function<void()> wake) = 0;
};

/// System time when the process started, advanced by the monotonic clock: never jumps, and stamps agree with
/// ROS 2 nodes.
class MonotonicClock final : public ComponentClock {
 public:
  MonotonicClock();
  Time now() const override;
  std::optional<Duration> real_time_until(Time t) const override { return t - now(); }
  void on_step(std::function<void()>) override {}

 private:
  Duration offset_;
};

/// ROS 2's use_sim_time: the last stamp seen on /clock.
class TopicClock final : public ComponentClock {
 public:
  Time now() const override { return {now_ns_.load()}; }
  std::optional<Duration> real_time_until(Time) const override { return std::nullopt; }
  void on_step(std::function<void()> wake) override { wake_ = std::move(wake); }
  void set(Time now);

 private:
  std::atomic<std::int64_t> now_ns_ = 0;
  std::function<void()> wake_;
};

}  // namespace bw
