// Whoever throws in the base's process, the driver's last word is its stop: the base itself in a callback, or
// another component.
#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/driver_registry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

constexpr double kSpeed = 0.2;  // [m/s]

/// What the driver was told, and whether it fails by itself.
struct Told {
  bool fails = false;
  std::string last;  ///< "drive" or "stop"
};
Told g_told;
std::atomic<double> g_fastest = 0.0;  // [m/s]; the commander reads it on another lane

struct NoOptions {
  template <class Visitor>
  void fields(Visitor&) {}
};

/// Wheels without mass, which fails once it drives.
class FailingDriver final : public Driver {
 public:
  FailingDriver(const NoOptions&, const DriverContext&) {}
  Readings poll(Time now) override {
    if (g_told.fails && g_fastest > 0.1) throw std::bad_alloc();
    Readings readings;
    travel_ += 0.01 * speed_;
    const auto ticks = static_cast<std::int32_t>(travel_ / 8.53e-5);  // of a Kobuki [m]
    readings.counts.push_back({now, ticks, ticks});
    return readings;
  }
  bool command(Time, const WheelSpeeds& wheels) override {
    speed_ = wheels.left;
    g_fastest = std::max(g_fastest.load(), speed_);
    g_told.last = "drive";
    return true;
  }
  void stop(Time) override { g_told.last = "stop"; }

 private:
  double speed_ = 0.0, travel_ = 0.0;
};
BW_DRIVER(FailingDriver, NoOptions, "failing")

class BaseFailure : public testing::TestWithParam<ClockMode> {
 protected:
  static RunEnd run() {
    const auto path = scratch_file(GetParam() == ClockMode::wall ? "base_failure_wall" : "base_failure");
    std::ofstream(path) << "robot: " << BANDWAGON_SOURCE_DIR
                        << "/config/robots/kobuki.yaml\ncomponents: {robot_base: {lane: base}}\n";
    std::vector<ExtraComponent> extra;
    extra.push_back({"commander", std::make_unique<Script>([](bw::Setup& setup) {
                       setup.every(Duration::milliseconds(20), "drive",
                                   [out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](
                                       const Tick&) mutable {
                                     if (!g_told.fails && g_fastest > 0.1) throw std::logic_error("lost");
                                     out.publish(to_joint_state({kSpeed, kSpeed}, {0.035, 0.035}, {}));
                                   });
                     })});
    Host host(load_graph(path, {"robot.base.driver=failing", "robot.laser.driver=none"}),
              {.clock = GetParam()}, std::move(extra));
    const RunEnd end = host.run(Duration::seconds(20.0));
    std::filesystem::remove(path);
    return end;
  }
};

TEST_P(BaseFailure, OfItsOwnLeavesAStop) {
  g_told = {.fails = true};
  g_fastest = 0.0;
  EXPECT_EQ(run().reason, "robot_base failed in watchdog: std::bad_alloc");
  EXPECT_EQ(g_told.last, "stop");
}

TEST_P(BaseFailure, OfAnotherComponentLeavesAStop) {
  g_told = {};
  g_fastest = 0.0;
  EXPECT_EQ(run().reason, "commander failed in drive: lost");
  EXPECT_EQ(g_told.last, "stop");
}

INSTANTIATE_TEST_SUITE_P(Clocks, BaseFailure, testing::Values(ClockMode::lockstep, ClockMode::wall),
                         [](const auto& clock) {
                           return clock.param == ClockMode::wall ? "RealTime" : "Lockstep";
                         });

}  // namespace
}  // namespace bw
