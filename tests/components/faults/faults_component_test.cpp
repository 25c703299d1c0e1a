// What goes wrong with senses and wheels, in a simulated world. Expected numbers: by what the fault says of itself.
#include <cmath>
#include <optional>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "components/messages/geometry.hpp"
#include "runtime/stamps.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

constexpr const char* kWorld = R"(
components:
  world:
    inputs: {sim/wheel_commands: {external: true}}
    parameters:
      walls: [{x1: 3.0, y1: -5.0, x2: 3.0, y2: 5.0}]
      gps: {noise: 0.0, datum_latitude: 21.0, datum_longitude: 105.8}
      imu: {gyro_noise: 0.0}
)";
constexpr const char* kBase = "  robot_base: {}\n  motor_control: {}\n";

template <class M>
std::vector<std::pair<double, M>> heard(const std::string& graph, const std::string& topic, double seconds) {
  std::vector<std::pair<double, M>> all;
  run_with_script(graph, seconds, [&](bw::Setup& setup) {
    setup.input<M>(topic, Qos::sensor(), [&](const M& message, const Tick& tick) {
      all.emplace_back(seconds_since_start(tick.now), message);
    });
  });
  return all;
}

std::string with(const std::string& fault) { return "faults: {" + fault + "}" + kWorld; }

TEST(LaserKinds, AFrozenOneSaysTheSameWithNewStampsAndFreshOnesAfterwards) {
  const auto sweeps = heard<sensor_msgs::msg::LaserScan>(
      with("f: {kind: laser_frozen, from: 450ms, for: 500ms}"), "scan", 1.5);
  int frozen = 0;
  for (std::size_t i = 1; i < sweeps.size(); ++i) {
    const bool is_same = sweeps[i].second.ranges() == sweeps[i - 1].second.ranges();
    frozen += is_same ? 1 : 0;
    EXPECT_EQ(is_same, sweeps[i - 1].first > 0.45 && sweeps[i].first < 0.95) << sweeps[i].first;
    EXPECT_GT(from_stamp(sweeps[i].second.header().stamp()),
              from_stamp(sweeps[i - 1].second.header().stamp()));
  }
  EXPECT_EQ(frozen, 4);  // of five in half a second, the first is the one that is kept
}

// The wall is 3 m ahead: ranges of one metre at the least. Stray ones end anywhere before it.
TEST(LaserKinds, NoiseMakesRangesNoisyAndSomeEndInTheAir) {
  const auto sweeps = heard<sensor_msgs::msg::LaserScan>(
      with("f: {kind: laser_noise, parameters: {sigma: 0.0, share: 0.3}}"), "scan", 0.5);
  ASSERT_FALSE(sweeps.empty());
  int hits = 0, stray = 0;
  for (const auto& [t, scan] : sweeps) {
    for (const float range : scan.ranges()) {
      hits += std::isfinite(range) ? 1 : 0;
      stray += std::isfinite(range) && range < 2.5F ? 1 : 0;
    }
  }
  ASSERT_GT(hits, 100);
  EXPECT_GT(stray, hits / 10);
  EXPECT_LT(stray, hits * 4 / 10);
}

TEST(ReceiverKinds, AStepMovesAllFixesEast) {
  const auto fixes = heard<sensor_msgs::msg::NavSatFix>(
      with("f: {kind: receiver_step, from: 2500ms, parameters: {east: 5.0}}"), "gps/fix", 5.0);
  ASSERT_GE(fixes.size(), 4U);
  const double degrees = 5.0 / (6'371'000.0 * M_PI / 180.0 * std::cos(21.0 * M_PI / 180.0));
  for (const auto& [t, fix] : fixes)
    EXPECT_NEAR(fix.longitude(), 105.8 + (t < 2.5 ? 0.0 : degrees), 1e-7) << t;
}

TEST(ReceiverKinds, OutliersAreFarOff) {
  const auto fixes = heard<sensor_msgs::msg::NavSatFix>(
      with("f: {kind: receiver_outliers, parameters: {share: 1.0, distance: 42.0}}"), "gps/fix", 5.0);
  ASSERT_FALSE(fixes.empty());
  for (const auto& [t, fix] : fixes) {
    const double metres = 6'371'000.0 * M_PI / 180.0;
    EXPECT_NEAR(std::hypot((fix.latitude() - 21.0) * metres,
                           (fix.longitude() - 105.8) * metres * std::cos(21.0 * M_PI / 180.0)),
                42.0, 0.3);
  }
}

TEST(GyroKind, ABiasIsAdded) {
  for (const auto& [t, imu] :
       heard<sensor_msgs::msg::Imu>(with("gyro_bias: {parameters: {bias: 0.05}, from: 100ms}"), "imu", 0.2))
    EXPECT_NEAR(imu.angular_velocity().z(), t < 0.1 ? 0.0 : 0.05, 1e-9) << t;
}

struct Driven {
  double odometry = 0.0, truth = 0.0, turned = 0.0;
};

/// At 0.5 m/s for four seconds.
Driven drive(const std::string& fault) {
  Driven driven;
  run_with_script("faults: {" + fault + "}\ncomponents:\n  world: {}\n" + kBase, 4.0, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::Odometry>("odom", Qos::sensor(), [&](const auto& m, const Tick&) {
      driven.odometry = m.pose().pose().position().x();
    });
    setup.input<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth", Qos::command(),
                                                  [&](const auto& m, const Tick&) {
                                                    driven.truth = m.pose().position().x();
                                                    driven.turned = from_pose(m.pose()).theta;
                                                  });
    setup.every(Duration::milliseconds(50), "wish",
                [out = setup.command<geometry_msgs::msg::Twist>("cmd_vel")](const Tick&) {
                  geometry_msgs::msg::Twist wish;
                  wish.linear().x(0.5);
                  out.publish(wish);
                });
  });
  return driven;
}

TEST(WheelKinds, ASlipLetsTheOdometryBelieveInMoreThanTheFloorGave) {
  const Driven sound = drive("f: {kind: wheel_slip, enabled: false}");
  EXPECT_NEAR(sound.odometry, sound.truth, 0.02);
  const Driven slips = drive("f: {kind: wheel_slip, parameters: {left: 0.4, right: 0.4}}");
  EXPECT_NEAR(slips.odometry, sound.odometry, 0.05);
  EXPECT_NEAR(slips.truth, 0.6 * slips.odometry, 0.05);
}

// What was gained by a slip stays gained: the counters do not go back when it is over. 0.4 of the way of two seconds at 0.5 m/s, the
// first half second half of that.
TEST(WheelKinds, ASlipThatIsOverIsNoJump) {
  const Driven slips = drive("f: {kind: wheel_slip, from: 1s, for: 2s, parameters: {left: 0.4, right: 0.4}}");
  EXPECT_NEAR(slips.odometry - slips.truth, 0.4 * 0.5 * (0.25 + 1.5), 0.06);
}

TEST(WheelKinds, AStalledOneSwingsTheRobotAboutItUntilTheBaseStops) {
  const Driven stalled = drive("f: {kind: wheel_stalled, from: 1500ms}");
  EXPECT_GT(stalled.turned, 0.05);
  EXPECT_LT(stalled.truth, drive("f: {kind: wheel_stalled, enabled: false}").truth - 0.5);
}

}  // namespace
}  // namespace bw
