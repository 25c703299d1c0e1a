// A base behind its guard, without middleware: wheels that follow what they are told with a delay and limited
// acceleration, counts every 20 ms, a guard that is asked every 10 ms.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <optional>

#include "components/robot_base/base_guard.hpp"

namespace bw {

class GuardedBase {
 public:
  static constexpr Duration kPeriod = Duration::milliseconds(10);

  explicit GuardedBase(const Robot& robot = {}, const BaseGuardOptions& options = {}, double response = 0.1)
      : robot_(robot), guard_(options, robot, response), odometry_(robot, {}) {
    readings.link.is_open = true;
  }

  BaseGuard& guard() { return guard_; }
  Time now() const { return now_; }
  double seconds() const { return (now_ - kStart).to_seconds(); }
  const BaseOutput& output() const { return output_; }
  double distance() const { return (distances_[0] + distances_[1]) / 2.0; }  ///< of the base, forward [m]
  double speed() const { return (speed_[0] + speed_[1]) / 2.0; }

  /// Goes on for so long; commands `wish` every 20 ms unless it is empty. `look` after each step.
  void run(double duration, std::optional<WheelSpeeds> wish, const std::function<void()>& look = {}) {
    const Time end = now_ + Duration::seconds(duration);
    while (now_ < end) {
      now_ = now_ + kPeriod;
      const bool is_even = (now_.nanoseconds / kPeriod.nanoseconds) % 2 == 0;
      if (wish && is_even) guard_.command(now_, *wish);
      move_wheels();
      Readings poll = readings;
      if (is_even && !is_silent) count(poll);
      guard_.read(now_, poll);
      if (!poll.counts.empty() && odometry_.add(now_, poll.counts.front()) == CountsStatus::moved)
        guard_.moved(now_, odometry_.travel());
      output_ = guard_.step(now_);
      guard_.told(now_, output_.wheels, !is_deaf);
      told_.push_back(output_.wheels);
      if (look) look();
    }
  }
  /// Until `is_so`, but no longer than `limit` [s]; how long it took.
  std::optional<double> run_until(double limit, std::optional<WheelSpeeds> wish,
                                  const std::function<bool()>& is_so) {
    const double begin = seconds();
    while (seconds() - begin < limit - 1e-9) {
      run(kPeriod.to_seconds(), wish);
      if (is_so()) return seconds() - begin;
    }
    return std::nullopt;
  }

  void step_clock(double seconds) { now_ = now_ + Duration::seconds(seconds); }

  Readings readings;       ///< of every poll, but for the counts
  bool is_silent = false;  ///< no counts come
  bool is_deaf = false;    ///< commands do not get through
  int delay = 2;           ///< in steps of 10 ms
  double acceleration = 4.0;
  /// What the wheels do with the speeds they were told; empty: they follow.
  std::function<WheelSpeeds(const WheelSpeeds& told)> fault;

 private:
  static constexpr Time kStart{1'000'000'000};

  void move_wheels() {
    WheelSpeeds told;
    while (static_cast<int>(told_.size()) > delay + 1) told_.pop_front();
    if (static_cast<int>(told_.size()) > delay) told = told_.front();
    const bool is_free = !fault;
    if (fault) told = fault(told);
    const double target[2] = {told.left, told.right};
    const double most = is_free ? acceleration * kPeriod.to_seconds() : 1e9;
    for (int i = 0; i < 2; ++i) {
      speed_[i] += std::clamp(target[i] - speed_[i], -most, most);
      distances_[i] += speed_[i] * kPeriod.to_seconds();
    }
  }
  void count(Readings& poll) const {
    const double tick =
        2.0 * std::numbers::pi * robot_.wheel_radius / static_cast<double>(robot_.ticks_per_revolution);
    poll.counts.push_back({now_, static_cast<std::int32_t>(std::floor(distances_[0] / tick)),
                           static_cast<std::int32_t>(std::floor(distances_[1] / tick))});
  }

  Robot robot_;
  BaseGuard guard_;
  EncoderOdometry odometry_;
  Time now_ = kStart;
  BaseOutput output_;
  std::deque<WheelSpeeds> told_;
  double speed_[2] = {0.0, 0.0};
  double distances_[2] = {0.0, 0.0};
};

}  // namespace bw
