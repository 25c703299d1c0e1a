// The laser in real time, over a pseudo-terminal: scans, a cable that is pulled for a second, and scans
// again.
#include <fstream>
#include <memory>
#include <optional>

#include <gtest/gtest.h>
#include <rcl_interfaces/msg/log.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "tests/components/component_rig.hpp"

namespace bw::laser {
namespace {

constexpr const char* kGraph = R"(
faults:
  pulled: {kind: parameters, of: laser_emulator, from: 3s, for: 1s, parameters: {faults.cable_pulled: true}}
robot:
  sensors: [{frame: laser}]
  laser: {driver: rplidar, port: emulator}
components:
  world:
    remap: {scan: sim/scan}
    inputs: {sim/wheel_commands: {external: true}}
    lane: world
    parameters: {laser: {field_of_view: 6.283185307179586, rate: 50}, walls: [{x1: 2, y1: -9, x2: 2, y2: 9}]}
  laser_emulator:
    lane: devices
    parameters: {spin_up: 0.2}
  laser: {lane: laser}
)";

/// The log while nothing is wrong: until the cable is pulled.
struct Journal {
  int errors_before_scans = 0;
  int errors = 0;
  std::string newest;
};

// An emulator starts beside the laser: no error before its first scan, and one when the cable is pulled.
// Ends with the third scan after the pause, half a minute later at the latest. The wall is 2 m ahead, at beam
// 360 of 720; the world's noise has 1 cm, of which five standard deviations are allowed.
TEST(LaserPort, ScansGoOnAfterACableWasPulled) {
  int before = 0;
  int after = 0;
  double pause = 0.0;
  double range = 0.0;
  Journal journal;
  const auto path = scratch_file("laser_port");
  std::ofstream(path) << kGraph;
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>([&](bw::Setup& setup) {
                     setup.input<rcl_interfaces::msg::Log>(
                         "/rosout", Qos::rosout(),
                         [&](const rcl_interfaces::msg::Log& log, const Tick&) {
                           if (log.level() < rcl_interfaces::msg::Log_Constants::ERROR) return;
                           ++(before == 0 ? journal.errors_before_scans : journal.errors);
                           journal.newest = log.msg();
                         },
                         Need::optional);
                     setup.input<sensor_msgs::msg::LaserScan>(
                         "scan", Qos::sensor(),
                         [&, finish = setup.finish_run(), last = std::optional<Time>()](
                             const sensor_msgs::msg::LaserScan& scan, const Tick& tick) mutable {
                           const double since_last = last ? (tick.now - *last).to_seconds() : 0.0;
                           last = tick.now;
                           pause = std::max(pause, since_last);
                           range = scan.ranges()[360];
                           ++(pause > 0.7 ? after : before);
                           if (after == 3) finish(true, "scans again");
                         });
                   })});
  Host host(load_graph(path, {}), {.clock = ClockMode::wall}, std::move(extra));
  host.run(Duration::seconds(30.0));
  std::filesystem::remove(path);
  EXPECT_EQ(journal.errors_before_scans, 0) << journal.newest;
  EXPECT_GE(journal.errors, 1) << "a cable that is pulled is an error";
  EXPECT_GE(before, 3);
  EXPECT_EQ(after, 3);
  EXPECT_GT(pause, 0.7);
  EXPECT_NEAR(range, 2.0, 0.05);
}

}  // namespace
}  // namespace bw::laser
