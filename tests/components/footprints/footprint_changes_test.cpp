// The footprint is changed while the robot drives: a corridor of 0.5 m stops its disc and lets its rectangle
// pass. Collision monitor, costmaps and who else listens hear of it by the parameter and by the topic of
// Nav2's costmaps.
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/polygon.hpp>
#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/collision_monitor_state.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/footprint.hpp"
#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/parameter_change.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kRectangle = "[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]";
constexpr const char* kArrow = "[[0.5, 0.0], [-0.5, 0.4], [-0.2, 0.0], [-0.5, -0.4]]";

geometry_msgs::msg::Polygon polygon(const std::vector<Vector2>& corners) {
  geometry_msgs::msg::Polygon message;
  for (const Vector2& corner : corners) add_point(message, corner);
  return message;
}
geometry_msgs::msg::Polygon rectangle() { return to_polygon(footprint_of(kRectangle, 0.0).footprint); }

/// What happens at which second, and what is seen.
struct Corridor {
  std::map<int, geometry_msgs::msg::Polygon> told;
  std::map<int, std::vector<NamedValue>> changes;
  bool accepts_inputs = true;
  /// A rectangle that carries something round, which the costmap tells from the start on.
  std::string graph =
      "{lifecycle: own, robot: {footprint: [[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]}, "
      "components: {collision_monitor: {}, local_costmap: {parameters: {nav2_names: true, robot_radius: 0.334}}}}";

  std::vector<std::string> refusals;
  std::map<int, double> speed;         ///< allowed at the end of each second
  std::map<int, std::string> cause;    ///< of its limit
  std::map<int, std::size_t> corners;  ///< of published_footprint
  std::map<int, std::size_t> marked;   ///< points of the monitor's outline
  std::vector<geometry_msgs::msg::PolygonStamped> heard;
  std::map<std::string, std::string> costmap_diagnostics;

  void run(double seconds);

 private:
  void script(Setup& setup);
  void publish(const Tick& tick);
  Output<sensor_msgs::msg::LaserScan> scan_;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<geometry_msgs::msg::Twist> wanted_;
  Output<tf2_msgs::msg::TFMessage> tf_;
  Output<geometry_msgs::msg::Polygon> footprint_;
};

/// A laser in the middle of the robot, all round, between two walls along x.
sensor_msgs::msg::LaserScan scan_between(double right, double left, std::uint64_t count) {
  constexpr int kBeams = 1440;
  sensor_msgs::msg::LaserScan scan;
  scan.angle_min(static_cast<float>(-std::numbers::pi));
  scan.angle_increment(static_cast<float>(2.0 * std::numbers::pi / kBeams));
  scan.angle_max(static_cast<float>(std::numbers::pi * (1.0 - 2.0 / kBeams)));
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  for (int i = 0; i < kBeams; ++i) {
    const double y = direction(-std::numbers::pi + 2.0 * std::numbers::pi / kBeams * i).y();
    const double range = y > 0.02 ? left / y : y < -0.02 ? right / y : 12.0;
    scan.ranges().push_back(static_cast<float>(range + 1e-4 * static_cast<double>((count + i) % 7)));
  }
  return scan;
}

void Corridor::script(Setup& setup) {
  scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor());
  odom_ = setup.output<nav_msgs::msg::Odometry>("odom");
  wanted_ = setup.output<geometry_msgs::msg::Twist>("cmd_vel_nav");
  tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
  footprint_ = setup.output<geometry_msgs::msg::Polygon>("footprint");
  setup.input<geometry_msgs::msg::Twist>("cmd_vel", Qos::command(), [this](const auto& m, const Tick& tick) {
    speed[static_cast<int>(seconds_since_start(tick.now))] = m.linear().x();
  });
  setup.input<nav2_msgs::msg::CollisionMonitorState>(
      "collision_monitor_state", Qos::standard(), [this](const auto& m, const Tick& tick) {
        cause[static_cast<int>(seconds_since_start(tick.now))] = m.polygon_name();
      });
  setup.input<geometry_msgs::msg::PolygonStamped>(
      "published_footprint", Qos::standard(), [this](const auto& m, const Tick& tick) {
        corners[static_cast<int>(seconds_since_start(tick.now))] = m.polygon().points().size();
      });
  setup.input<geometry_msgs::msg::PolygonStamped>("robot_footprint", Qos::latched(),
                                                  [this](const auto& m, const Tick&) { heard.push_back(m); });
  setup.input<visualization_msgs::msg::MarkerArray>(
      "collision_monitor_markers", Qos::standard(), [this](const auto& m, const Tick& tick) {
        marked[static_cast<int>(seconds_since_start(tick.now))] = m.markers().front().points().size();
      });
  setup.input<diagnostic_msgs::msg::DiagnosticArray>(
      "/diagnostics", Qos::standard(),
      [this](const auto& m, const Tick&) {
        for (const auto& status : m.status()) {
          if (status.name() != "local_costmap") continue;
          costmap_diagnostics.clear();
          for (const auto& value : status.values()) costmap_diagnostics[value.key()] = value.value();
        }
      },
      Need::optional);
  for (const auto& [second, change] : changes)
    change_parameters(setup, "/local_costmap", second, change, refusals);
  setup.every(Duration::milliseconds(20), "robot", [this](const Tick& tick) { publish(tick); });
}

void Corridor::publish(const Tick& tick) {
  tf2_msgs::msg::TFMessage tf;
  tf.transforms().push_back(to_transform("odom", "base_link", tick.now, Pose2{}));
  tf.transforms().push_back(to_transform("base_link", "laser", tick.now, Pose2{}));
  tf_.publish(tf);
  nav_msgs::msg::Odometry odometry;
  odometry.header(make_header("odom", tick.now));
  odometry.pose().pose(to_pose(Pose2{}));
  odom_.publish(odometry);
  geometry_msgs::msg::Twist wanted;
  wanted.linear().x(0.5);
  wanted_.publish(wanted);
  if (tick.sequence % 5 == 0) {
    sensor_msgs::msg::LaserScan scan = scan_between(-0.25, 0.25, tick.sequence);
    scan.header(make_header("laser", tick.now));
    scan_.publish(scan);
  }
  if (tick.sequence % 50 != 0) return;
  const auto message = told.find(static_cast<int>(std::lround(seconds_since_start(tick.now))));
  if (message != told.end()) footprint_.publish(message->second);
}

void Corridor::run(double seconds) {
  const auto path = scratch_file(::testing::UnitTest::GetInstance()->current_test_info()->name());
  std::ofstream(path) << graph;
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>([this](Setup& setup) { script(setup); })});
  Host host(load_graph(path, {}), {.clock = ClockMode::lockstep, .accept_inputs = accepts_inputs},
            std::move(extra));
  host.run(Duration::seconds(seconds));
  std::filesystem::remove(path);
}

TEST(FootprintChanges, ByTopicForEveryComponent) {
  Corridor corridor;
  corridor.told = {{2, rectangle()}, {4, polygon({{0.5, 0.0}, {-0.5, 0.4}, {-0.2, 0.0}, {-0.5, -0.4}})}};
  corridor.run(6.5);
  EXPECT_EQ(corridor.cause[1], "stopping_distance");
  EXPECT_EQ(corridor.speed[1], 0.0) << "a disc of 0.334 m beside walls at 0.25 m";
  EXPECT_EQ(corridor.corners[1], 16U);
  EXPECT_EQ(corridor.marked[1], 49U);
  EXPECT_EQ(corridor.speed[3], 0.5) << corridor.cause[3];
  EXPECT_EQ(corridor.corners[3], 4U);
  EXPECT_EQ(corridor.marked[3], 5U);
  // The arrow turns inwards: refused, and the rectangle stays.
  EXPECT_EQ(corridor.speed[5], 0.5);
  EXPECT_EQ(corridor.corners[5], 4U);
  EXPECT_EQ(corridor.heard.size(), 2U);
  EXPECT_EQ(corridor.heard.front().header().frame_id(), "base_link");
  EXPECT_THAT(corridor.costmap_diagnostics["footprint"], HasSubstr("refused: it must be convex"));
}

TEST(FootprintChanges, ByTheParametersOfNav2) {
  Corridor corridor;
  corridor.changes = {{2, {{"footprint", std::string(kRectangle)}}},
                      {3, {{"footprint", std::string(kArrow)}}},
                      {5, {{"footprint_padding", 0.1}}},
                      {7, {{"footprint_padding", 0.0}, {"footprint", std::string()}, {"robot_radius", 0.2}}},
                      {9, {{"robot_radius", 0.0}}}};
  corridor.run(10.9);
  EXPECT_EQ(corridor.speed[1], 0.0);
  EXPECT_EQ(corridor.speed[4], 0.5) << "a rectangle, and no arrow";
  EXPECT_EQ(corridor.corners[4], 4U);
  EXPECT_EQ(corridor.speed[6], 0.0) << "0.215 m and 0.1 m are more than 0.25 m";
  EXPECT_EQ(corridor.speed[8], 0.5)
      << "a disc of 0.2 m for who plans; the monitor keeps the robot file's rectangle";
  EXPECT_EQ(corridor.corners[8], 16U);
  EXPECT_EQ(corridor.marked[8], 5U);
  EXPECT_EQ(corridor.speed[10], 0.5) << "the robot's own rectangle again";
  EXPECT_EQ(corridor.corners[10], 4U);
  ASSERT_EQ(corridor.refusals.size(), 7U);
  EXPECT_EQ(corridor.refusals[0], "");
  EXPECT_THAT(corridor.refusals[1], HasSubstr("footprint = "));
  EXPECT_THAT(corridor.refusals[1], HasSubstr("must be convex"));
  for (std::size_t i = 2; i < corridor.refusals.size(); ++i) EXPECT_EQ(corridor.refusals[i], "") << i;
}

// What the graph says of the costmap holds for all from the start, but the monitor takes no less than the
// robot file says.
TEST(FootprintChanges, FromTheGraphOfACostmap) {
  Corridor corridor;
  corridor.graph =
      "{robot: {radius: 0.334}, components: {collision_monitor: {}, local_costmap: {parameters: {nav2_names: true, "
      "footprint: [[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]}}}}";
  corridor.run(1.9);
  EXPECT_EQ(corridor.speed[1], 0.0) << "a disc of 0.334 m";
  EXPECT_EQ(corridor.corners[1], 4U);
  EXPECT_EQ(corridor.marked[1], 49U);
}

// Where nothing may change from outside, nobody listens, and the parameter says so.
TEST(FootprintChanges, NotInLockStepWithoutInputs) {
  Corridor corridor;
  corridor.accepts_inputs = false;
  corridor.graph =
      "{lifecycle: own, robot: {radius: 0.334}, components: {collision_monitor: {}, local_costmap: {parameters: {nav2_names: true}}}}";
  corridor.told = {{2, rectangle()}};
  corridor.changes = {{1, {{"footprint", std::string(kRectangle)}}}};
  corridor.run(3.9);
  EXPECT_EQ(corridor.speed[3], 0.0);
  EXPECT_TRUE(corridor.heard.empty());
  ASSERT_EQ(corridor.refusals.size(), 1U);
  EXPECT_THAT(corridor.refusals[0], HasSubstr("--accept-inputs"));
  EXPECT_EQ(corridor.costmap_diagnostics.count("age /robot_footprint"), 0U);
}

}  // namespace
}  // namespace bw
