// The laser on its topics, in lock-step: world, emulated device, cable of topics, component. The world's scan
// goes in, and comes out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/laser.hpp"
#include "runtime/parameters/config_error.hpp"
#include "runtime/stamps.hpp"
#include "tests/components/component_rig.hpp"

namespace bw::laser {
namespace {

using sensor_msgs::msg::LaserScan;

struct Seen {
  LaserScan scan;
  Time received;
};

/// In the corner of a room of 8 x 5 m, rotated by 0.4 rad, with a pillar; without noise. `laser`: more of the
/// robot's section, `emulator`: parameters.
std::string graph(const std::string& laser = ", beams: 360", const std::string& emulator = "",
                  const std::string& sensor = "laser") {
  return "robot:\n"
         "  sensors: [{frame: " +
         sensor +
         ", x: 0.1}]\n"
         "  laser: {driver: rplidar, port: emulator" +
         laser +
         "}\n"
         "components:\n"
         "  world:\n"
         "    remap: {scan: sim/scan}\n"
         "    inputs: {sim/wheel_commands: {external: true}}\n"
         "    parameters:\n"
         "      start: {x: 2.0, y: 1.5, theta: 0.4}\n"
         "      laser: {beams: 1441, field_of_view: 6.283185307179586, range_noise: 0, rate: 50}\n"
         "      walls: [{x1: 0, y1: 0, x2: 8, y2: 0}, {x1: 8, y1: 0, x2: 8, y2: 5},\n"
         "              {x1: 8, y1: 5, x2: 0, y2: 5}, {x1: 0, y1: 5, x2: 0, y2: 0}]\n"
         "      boxes: [{x: 4, y: 2, length: 0.3, width: 0.3}]\n"
         "  laser_emulator:\n"
         "    parameters: {" +
         emulator +
         "}\n"
         "  laser: {}\n";
}

struct Heard {
  std::vector<Seen> world;
  std::vector<Seen> laser;
};

Heard run(const std::string& yaml, double seconds) {
  Heard heard;
  run_with_script(yaml, seconds, [&](Setup& setup) {
    for (const auto& [topic, list] : {std::pair{"sim/scan", &heard.world}, std::pair{"scan", &heard.laser}})
      setup.input<LaserScan>(topic, Qos::standard(50),
                             [list = list](const LaserScan& scan, const Tick& tick) {
                               list->push_back({scan, tick.now});
                             });
  });
  return heard;
}

/// Least and largest of the world's ranges within `reach` of `angle` [rad].
std::pair<float, float> world_between(const LaserScan& world, double angle, double reach) {
  float least = std::numeric_limits<float>::infinity();
  float largest = 0.0F;
  for (std::size_t i = 0; i < world.ranges().size(); ++i) {
    const double beam = world.angle_min() + static_cast<double>(i) * world.angle_increment();
    if (std::abs(std::remainder(beam - angle, 2.0 * std::numbers::pi)) > reach) continue;
    least = std::min(least, world.ranges()[i]);
    largest = std::max(largest, world.ranges()[i]);
  }
  return {least, largest};
}

// 7 Hz x 500 us: samples are 1.26 degrees apart, each of the nearest of the world's beams (0.125 degree), so
// a beam comes from what the world has within 1.4 degrees; beside that the device rounds to 0.25 mm. On the
// walls, away from their corners, beams are right to what a ray 0.133 degree beside its own sees.
TEST(LaserComponent, TellsWhatTheWorldShows) {
  const Heard heard = run(graph(), 3.0);
  ASSERT_GE(heard.laser.size(), 12U) << "(3 s - 0.6 s of spin-up - first part of a turn) x 7";
  const LaserScan& scan = heard.laser.back().scan;
  const LaserScan& world = heard.world.back().scan;
  EXPECT_EQ(scan.header().frame_id(), "laser");
  ASSERT_EQ(scan.ranges().size(), 360U);
  EXPECT_NEAR(scan.angle_min(), -std::numbers::pi, 1e-6);
  EXPECT_NEAR(scan.angle_max(), std::numbers::pi * 179.0 / 180.0, 1e-5);
  double error = 0.0;
  for (std::size_t i = 0; i < 360; ++i) {
    const double angle = -std::numbers::pi + static_cast<double>(i) * std::numbers::pi / 180.0;
    const auto [least, largest] = world_between(world, angle, 1.4 * std::numbers::pi / 180.0);
    EXPECT_GE(scan.ranges()[i], least - 0.00013F) << i;
    EXPECT_LE(scan.ranges()[i], largest + 0.00013F) << i;
    error += std::abs(scan.ranges()[i] - world.ranges()[4 * i]) / 360.0;
  }
  EXPECT_LT(error, 0.012) << "the mean; most of it at the pillar's edges";
}

// A revolution is 1/7 s, known to a measurement or two (0.5 ms each, and 5 ms of polling that count back by
// them); beam 0 was the last of a revolution and came at once.
TEST(LaserComponent, MeasuresItsOwnTime) {
  const Heard heard = run(graph(), 3.0);
  ASSERT_GE(heard.laser.size(), 3U);
  for (std::size_t i = 0; i < heard.laser.size(); ++i) {
    const auto& [scan, received] = heard.laser[i];
    EXPECT_NEAR(scan.scan_time(), 1.0 / 7.0, 0.002);
    EXPECT_NEAR(scan.time_increment(), -scan.scan_time() / 360.0, 1e-8);
    const double age = (received - from_stamp(scan.header().stamp())).to_seconds();
    EXPECT_GE(age, 0.0);
    EXPECT_LE(age, 0.011) << "a step of the device and a poll, 5 ms each";
    if (i == 0) continue;
    EXPECT_NEAR((from_stamp(scan.header().stamp()) - from_stamp(heard.laser[i - 1].scan.header().stamp()))
                    .to_seconds(),
                scan.scan_time(), 1e-6);
  }
}

// Pulled at 2 s, put back at 3 s: nothing in between, but for the revolution that was just over; the device
// is there again at once, since its head rotated on.
TEST(LaserComponent, APulledCableIsSilenceAndThenScans) {
  const Heard heard =
      run("faults: {f: {kind: parameters, of: laser_emulator, from: 2s, for: 1s, parameters: "
          "{faults.cable_pulled: true}}}\n" +
              graph("", ""),
          5.0);
  const auto between = [&](double from, double until) {
    return std::ranges::count_if(heard.laser, [&](const Seen& seen) {
      const double t = seconds_since_start(seen.received);
      return t > from && t <= until;
    });
  };
  EXPECT_GE(between(0.0, 2.0), 5);
  EXPECT_EQ(between(2.01, 3.0), 0);
  EXPECT_GE(between(3.8, 5.0), 7) << "asked anew within 0.5 s, and a first part of a turn";
}

TEST(LaserComponent, BeamsAreAsManyAsAskedFor) {
  const Heard heard = run(graph(", beams: 720, range_max: 3.0", "rate: 10, sample_time: 0.00025"), 2.0);
  ASSERT_FALSE(heard.laser.empty());
  const LaserScan& scan = heard.laser.back().scan;
  EXPECT_EQ(scan.ranges().size(), 720U);
  EXPECT_EQ(scan.range_max(), 3.0F);
  EXPECT_EQ(*std::ranges::max_element(scan.ranges()), std::numeric_limits<float>::infinity())
      << "6 m along x";
  EXPECT_NEAR(scan.scan_time(), 0.1, 0.002);
}

std::string refusal(const std::string& yaml) {
  try {
    run(yaml, 0.1);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LaserComponent, RefusesARobotFileThatCannotBe) {
  EXPECT_THAT(refusal(graph(", frame: lidar")),
              ::testing::HasSubstr(
                  "robot.laser.frame = lidar: robot.sensors must say where a sensor with this frame sits"));
  EXPECT_THAT(refusal(graph(", beam: 720")), ::testing::HasSubstr("did you mean 'beams'"));
  EXPECT_THAT(refusal(graph(", model: a4")), ::testing::HasSubstr("robot.laser.model"));
  std::string other = graph();
  other.replace(other.find("rplidar"), 7, "rplidr_");
  EXPECT_THAT(refusal(other),
              ::testing::HasSubstr("robot.laser.driver = rplidr_: unknown driver; did you mean 'rplidar'?"));
}

// 360 beams, 0.5 ms apart, backwards from 10 s: the middle is 90 ms before. An increment of 10 s is no
// laser's.
TEST(LaserScanMessage, ItsTimeIsThatOfItsMiddle) {
  LaserScan scan;
  scan.ranges(std::vector<float>(360, 1.0F));
  scan.header().stamp(to_stamp(Time::seconds(10.0)));
  EXPECT_EQ(time_of(scan), Time::seconds(10.0)) << "all at once";
  scan.time_increment(-0.0005F);
  EXPECT_NEAR(time_of(scan).to_seconds(), 9.91, 1e-6);
  EXPECT_EQ(to_sweep(scan, {}).time, time_of(scan));
  scan.time_increment(10.0F);
  EXPECT_EQ(time_of(scan), Time::seconds(10.0));
  scan.time_increment(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(time_of(scan), Time::seconds(10.0));
}

// Another program's scans: this component has no end on the topic, so that another may have it.
TEST(LaserComponent, StandsBackForAnotherProgramsScans) {
  int heard = 0;
  run_with_script("components:\n  laser: {}\n", 0.5, [&](bw::Setup& setup) {
    setup.every(Duration::milliseconds(100), "driver",
                [out = setup.output<LaserScan>("scan")](const Tick&) { out.publish({}); });
    setup.input<LaserScan>("scan", Qos::sensor(), [&](const LaserScan&, const Tick&) { ++heard; });
  });
  EXPECT_GE(heard, 4);
}

}  // namespace
}  // namespace bw::laser
