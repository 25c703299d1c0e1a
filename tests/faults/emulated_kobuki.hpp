// A Kobuki at the end of a cable, in real time: emulated firmware without a dead-man time of its own, wheels
// that rotate as it makes them, and a commander that wants them to rotate for ever. It keeps when it heard
// what.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "components/emulators/kobuki/kobuki_firmware.hpp"
#include "components/robot_base/kobuki/commands.hpp"
#include "runtime/serial/pseudo_terminal.hpp"

namespace bw::test {

class EmulatedKobuki {
 public:
  using Clock = std::chrono::steady_clock;

  explicit EmulatedKobuki(const std::string& port) : cable_(port) { cable_.update(now()); }

  /// Lives until `seen` or for `limit`; true: it was seen.
  bool live(std::chrono::milliseconds limit, const std::function<bool()>& seen) {
    const auto end = Clock::now() + limit;
    while (Clock::now() < end) {
      hear();
      if (now() - stepped_ >= Duration::milliseconds(10)) step();
      if (seen()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  /// [m/s], of the faster wheel.
  double speed() const {
    const WheelSpeeds wheels = firmware_.motors();
    return std::max(std::abs(wheels.left), std::abs(wheels.right));
  }
  void forget() { heard_.clear(), stop_.reset(); }
  /// When the first stop frame came since forget().
  std::optional<Clock::time_point> stop() const { return stop_; }

 private:
  static Time now() {
    return {std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count()};
  }
  void hear() {
    cable_.update(now());
    const auto bytes = cable_.read();
    if (bytes.empty()) return;
    cable_.write(firmware_.receive(now(), bytes));
    heard_.insert(heard_.end(), bytes.begin(), bytes.end());
    const auto frame = kobuki::base_control({});
    if (!stop_ && std::ranges::search(heard_, frame).begin() != heard_.end()) stop_ = Clock::now();
  }
  void step() {
    const double dt = std::min(0.1, (now() - stepped_).to_seconds());
    stepped_ = now();
    const WheelSpeeds wheels = firmware_.motors();
    left_ += wheels.left * dt, right_ += wheels.right * dt;
    const double tick =
        2.0 * std::numbers::pi * robot_.wheel_radius / static_cast<double>(robot_.ticks_per_revolution);
    emulators::Body body;
    body.left_ticks = static_cast<std::int32_t>(std::lround(left_ / tick));
    body.right_ticks = static_cast<std::int32_t>(std::lround(right_ / tick));
    body.twist = to_twist(wheels, robot_.wheel_separation);
    const auto packet = firmware_.step(stepped_, body);
    if (!packet.empty()) cable_.write(packet);
  }
  static Robot kobuki_robot() {
    Robot robot;
    robot.wheel_radius = 0.035;
    robot.wheel_separation = 0.230;
    robot.ticks_per_revolution = 2578;
    robot.wheel_speed_max = 0.7;
    return robot;
  }

  PseudoTerminal cable_;
  Robot robot_ = kobuki_robot();
  emulators::KobukiFirmware firmware_{{.stops_by_itself = 0.0}, robot_, 1};
  Time stepped_ = now();
  double left_ = 0.0, right_ = 0.0;  ///< [m]
  std::vector<std::uint8_t> heard_;
  std::optional<Clock::time_point> stop_;
};

}  // namespace bw::test
