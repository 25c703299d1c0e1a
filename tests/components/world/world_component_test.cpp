// The world on its topics, in lock-step: what a base and an observer get from it.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "runtime/component.hpp"
#include "runtime/host/host.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

struct Seen {
  std::vector<bandwagon_msgs::msg::WheelTicks> ticks;
  std::vector<bandwagon_msgs::msg::GroundTruth> truths;
  std::vector<sensor_msgs::msg::LaserScan> scans;
  std::vector<sensor_msgs::msg::Imu> readings;
  std::vector<sensor_msgs::msg::NavSatFix> fixes;
  std::vector<bandwagon_msgs::msg::Obstacles> obstacles;
};

/// Rotates both wheels at `rate` [rad/s] and keeps everything the world says.
class Observer final : public Component {
 public:
  /// Commands from `last` [s] on are not sent any more.
  Observer(double rate, Seen& seen, double last) : rate_(rate), seen_(seen), last_(last) {}

  void configure(Setup& setup) override {
    commands_ = setup.command<sensor_msgs::msg::JointState>("sim/wheel_commands");
    keep(setup, "sim/wheel_ticks", seen_.ticks);
    keep(setup, "sim/ground_truth", seen_.truths);
    keep(setup, "scan", seen_.scans);
    keep(setup, "imu", seen_.readings);
    keep(setup, "gps/fix", seen_.fixes);
    keep(setup, "sim/obstacles", seen_.obstacles, Qos::latched());
    setup.every(Duration::milliseconds(100), "drive", [this](const Tick& tick) {
      if (0.1 * static_cast<double>(tick.sequence) >= last_) return;
      sensor_msgs::msg::JointState message;
      message.velocity({rate_, rate_});
      commands_.publish(message);
    });
  }

 private:
  template <class M>
  static void keep(Setup& setup, const std::string& topic, std::vector<M>& list,
                   const Qos& qos = Qos::standard(50)) {
    setup.input<M>(topic, qos, [&list](const M& message, const Tick&) { list.push_back(message); });
  }

  double rate_;
  Seen& seen_;
  double last_;
  Output<sensor_msgs::msg::JointState> commands_;
};

Seen run(const std::string& parameters, double rate, std::uint64_t seed, std::string* sha256 = nullptr,
         double last_command = 1e9) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "world_component_test.yaml";
  std::ofstream(path) << "components:\n  world:\n    parameters: " << parameters << "\n";
  Seen seen;
  std::vector<ExtraComponent> extra;
  extra.push_back({"observer", std::make_unique<Observer>(rate, seen, last_command)});
  Host host(load_graph(path, {}), {.clock = ClockMode::lockstep, .seed = seed}, std::move(extra));
  host.run(Duration::seconds(5.0));
  if (sha256 != nullptr) *sha256 = host.samples_sha256();
  return seen;
}

const std::string kQuiet =
    "{start: {x: 1, y: 2}, walls: [{x1: 5, y1: -9, x2: 5, y2: 9}], "
    "laser: {beams: 721, range_noise: 0}, gps: {noise: 0}, imu: {heading_noise: 0}, "
    "people: {scripted: [{waypoints: [{x: 1, y: 5}]}]}}";

TEST(WorldComponent, SaysWhereTheRobotIsAndWhatItSees) {
  const Seen seen = run(kQuiet, 0.0, 1);
  ASSERT_GE(seen.truths.size(), 248u);  // 50 Hz for 5 s
  const auto& truth = seen.truths.back();
  EXPECT_EQ(truth.header().frame_id(), "map");
  EXPECT_EQ(truth.pose().position().x(), 1.0);
  EXPECT_EQ(truth.pose().position().y(), 2.0);
  EXPECT_NEAR(truth.wall_clearance(), 4.0 - 0.3, 1e-9);  // wall at x = 5, rim of a 0.3 m robot
  EXPECT_EQ(truth.contacts(), 0u);
  ASSERT_EQ(truth.people().size(), 1u);
  EXPECT_EQ(truth.people()[0].position().y(), 5.0);

  ASSERT_GE(seen.scans.size(), 49u);
  const auto& scan = seen.scans.back();
  EXPECT_EQ(scan.header().frame_id(), "laser");
  ASSERT_EQ(scan.ranges().size(), 721u);
  EXPECT_NEAR(scan.ranges()[360], 4.0, 1e-6);  // straight ahead
  EXPECT_EQ(scan.ranges()[0], std::numeric_limits<float>::infinity());
  EXPECT_NEAR(scan.angle_max(), 0.75 * std::numbers::pi, 1e-6);
  // The standing person, 3 m to the left (90 deg): beam (90 + 135) / 270 * 720 = 600 passes between the legs,
  // and the legs, facing +x, stand 0.12 m before and behind: in line with the beam, the near one
  // 3 - 0.12 - 0.07 away.
  EXPECT_NEAR(scan.ranges()[600], 2.81, 1e-4);

  ASSERT_EQ(seen.readings.back().linear_acceleration_covariance()[0], -1.0);
  EXPECT_NEAR(seen.readings.back().orientation().w(), 1.0, 1e-12);
  ASSERT_GE(seen.fixes.size(), 4u);
  EXPECT_NEAR(seen.fixes[0].latitude(), 21.0 + 2.0 / 110'700.0, 1e-6);
  EXPECT_TRUE(std::isnan(seen.fixes[0].altitude()));
}

// The last command is that of 1.9 s; 0.3 s later it brakes, and stands long before the end.
TEST(WorldComponent, ABaseThatIsToldNothingAnyMoreBrakes) {
  const Seen seen = run(kQuiet, 5.0, 1, nullptr, 1.95);
  double last_motion = 0.0, top = 0.0;
  const double begin = from_stamp(seen.truths.front().header().stamp()).to_seconds();
  for (const auto& truth : seen.truths) {
    top = std::max(top, truth.twist().linear().x());
    if (truth.twist().linear().x() > 0.9 * top)
      last_motion = from_stamp(truth.header().stamp()).to_seconds() - begin;
  }
  EXPECT_GT(top, 0.1);
  EXPECT_GE(last_motion, 1.9 + 0.3 - 0.02);  // a truth each 20 ms
  EXPECT_LE(last_motion, 1.9 + 0.3 + 0.1);   // and the tenth of the speed that it loses first
  EXPECT_EQ(seen.truths.back().twist().linear().x(), 0.0);
  EXPECT_GT(run(kQuiet, 5.0, 1).truths.back().twist().linear().x(), 0.9 * top);
}

TEST(WorldComponent, ReadsAHallwayOfWalkersFromYaml) {
  const Seen seen = run(R"(
      start: {x: 1.0, y: 0.0, theta: 0.0}
      people_react: true
      walls:
        - {x1: 0, y1: -3, x2: 20, y2: -3}
        - {x1: 20, y1: -3, x2: 20, y2: 3}
        - {x1: 20, y1: 3, x2: 0, y2: 3}
        - {x1: 0, y1: 3, x2: 0, y2: -3}
      boxes:
        - {x: 6.0, y: 2.2, length: 0.8, width: 0.8}
        - {x: 13.0, y: -2.2, length: 0.8, width: 0.8}
      people:
        scripted:
          - {waypoints: [{x: 9.0, y: -1.6}]}
          - {waypoints: [{x: 9.6, y: -1.9}]}
        social:
          speed_min: 1.0
          speed_max: 1.3
          start_jitter: 0.3
          walkers:
            - {x: 4, y: 1, goal_x: 18, goal_y: 1}
            - {x: 5, y: 0, goal_x: 18, goal_y: 0}
            - {x: 3, y: -1, goal_x: 18, goal_y: -1}
            - {x: 18, y: 1, goal_x: 2, goal_y: 1}
            - {x: 17, y: 0, goal_x: 2, goal_y: 0}
            - {x: 19, y: -1, goal_x: 2, goal_y: -1}
          forces: {social_factor: 5.1}
)",
                        0.0, 1);
  ASSERT_EQ(seen.truths.back().people().size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& person = seen.truths.back().people()[i];
    EXPECT_EQ(person.id(), i + 1);
    EXPECT_EQ(std::hypot(person.velocity().x(), person.velocity().y()) > 0.3, i >= 2)
        << "two stand, six walk";
  }
}

TEST(WorldComponent, TurnsWheelsAsCommanded) {
  const Seen seen = run(kQuiet, 5.0, 1);
  // 5 rad/s on 0.0762 m wheels from 0.1 s on: 0.381 m/s; the ramp at 4 m/s^2 loses v^2 / 2 a = 0.018 m.
  const auto& truth = seen.truths.back();
  const double time =
      (from_stamp(truth.header().stamp()) - from_stamp(seen.truths[0].header().stamp())).to_seconds() + 0.02;
  EXPECT_NEAR(truth.twist().linear().x(), 0.381, 1e-9);
  EXPECT_NEAR(truth.pose().position().x(), 1.0 + 0.381 * (time - 0.1) - 0.018, 0.01);
  EXPECT_NEAR(seen.ticks.back().left(),
              (truth.pose().position().x() - 1.0) / 0.0762 * 2578.0 / (2.0 * std::numbers::pi), 45);
}

TEST(WorldComponent, BrakesOnACommandThatIsNotANumber) {
  EXPECT_EQ(run(kQuiet, std::nan(""), 1).truths.back().twist().linear().x(), 0.0);
}

TEST(WorldComponent, OneSeedIsOneRun) {
  std::string first;
  std::string again;
  std::string other;
  run("{}", 5.0, 7, &first);
  run("{}", 5.0, 7, &again);
  run("{}", 5.0, 8, &other);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
  EXPECT_FALSE(first.empty());
}

TEST(WorldComponent, RefusesAWorldThatCannotBe) {
  EXPECT_THROW(run("{start: {x: 5}, walls: [{x1: 5, y1: -9, x2: 5, y2: 9}]}", 0.0, 1), std::runtime_error);
  EXPECT_THROW(run("{people: {scripted: [{speed: 1}]}}", 0.0, 1), std::runtime_error);
  EXPECT_THROW(run("{tracks: no_such_file.csv}", 0.0, 1), std::runtime_error);
  EXPECT_THROW(run("{laser: {rate: 200}}", 0.0, 1), std::runtime_error);
}

// A wall and a box of four sides, told once.
TEST(WorldComponent, TellsWhatStandsInIt) {
  const Seen seen =
      run("{walls: [{x1: 5, y1: -9, x2: 5, y2: 9}], boxes: [{x: 3, y: 3, length: 1, width: 1}]}", 0.0, 1);
  ASSERT_EQ(seen.obstacles.size(), 1U);
  const bandwagon_msgs::msg::Obstacles& obstacles = seen.obstacles.front();
  EXPECT_EQ(obstacles.header().frame_id(), "map");
  ASSERT_EQ(obstacles.segments().size(), 5U);
  EXPECT_EQ(obstacles.segments()[0].x1(), 5.0F);
  EXPECT_EQ(obstacles.segments()[0].y2(), 9.0F);
  EXPECT_TRUE(obstacles.discs().empty());
}

}  // namespace
}  // namespace bw
