// A simulated robot behind the collision monitor, driven straight on by a script in place of a planner; the
// script also stands between the laser and the monitor. Lock-step, no map, no localization.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/random.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {

/// Repetitions of one fault: 59 without a failure show less than 5 % failures with 95 % confidence.
/// BANDWAGON_FAULT_TRIALS asks for more.
inline int fault_trials() {
  const char* text = std::getenv("BANDWAGON_FAULT_TRIALS");
  return text != nullptr ? std::max(1, std::atoi(text)) : 59;
}

struct GuardedDrive {
  std::string world;    ///< lines of the world's parameters
  std::string monitor;  ///< lines of the monitor's parameters
  std::uint64_t seed = 1;
  std::function<Twist2(double t)> wish;  ///< at 10 Hz
  /// Looks at and changes a sweep at t [s]; false: it is lost.
  std::function<bool(double t, sensor_msgs::msg::LaserScan&)> filter;
  std::function<void(double t, const bandwagon_msgs::msg::GroundTruth&)> see;  ///< at 100 Hz

  void run(double seconds) {
    const auto path = scratch_file("guarded_drive");
    std::ofstream(path)
        << "robot: {limits: {v_max: 1.0, acc_max: 1.0, stop_deceleration: 2.0}}\ncomponents:\n"
           "  world:\n    remap: {scan: laser}\n    parameters:\n      truth_rate: 100.0\n"
           "      drive: {mismatch: 0.004, noise: 0.00003}\n"
        << world << "  robot_base: {}\n  motor_control: {}\n  collision_monitor:\n    parameters:\n"
        << "      source_timeout: 0.25\n"
        << monitor;
    std::vector<ExtraComponent> extra;
    extra.push_back({"script", std::make_unique<Script>([this](Setup& setup) { configure(setup); })});
    Host host(load_graph(path), {.clock = ClockMode::lockstep, .seed = seed}, std::move(extra));
    host.run(Duration::seconds(seconds));
    std::filesystem::remove(path);
  }

 private:
  void configure(Setup& setup) {
    setup.input<sensor_msgs::msg::LaserScan>("laser", Qos::sensor(),
                                             [this, out = setup.output<sensor_msgs::msg::LaserScan>("scan")](
                                                 const auto& message, const Tick& tick) {
                                               sensor_msgs::msg::LaserScan scan = message;
                                               if (!filter || filter(seconds_since_start(tick.now), scan))
                                                 out.publish(scan);
                                             });
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::command(),
        [this](const auto& truth, const Tick& tick) { see(seconds_since_start(tick.now), truth); });
    setup.every(Duration::milliseconds(100), "wish",
                [this, out = setup.command<geometry_msgs::msg::Twist>("cmd_vel_nav")](const Tick& tick) {
                  out.publish(to_twist_message(wish(seconds_since_start(tick.now))));
                });
  }
};

}  // namespace bw
