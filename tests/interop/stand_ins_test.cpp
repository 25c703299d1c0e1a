// What stands in for one server of Nav2, as somebody outside meets it: names, types and states of
// navigation2's jazzy branch, bytes by the rules of plain CDR. The outsider manages as lifecycle_manager
// does.
#include <chrono>

#include <gmock/gmock.h>

#include "tests/interop/stand_in.hpp"

namespace bw::test {
namespace {

using plain::Bytes;
using plain::CdrIn;
using plain::CdrOut;

/// A map of 4 x 2 m, cells of 0.05 m: 80 x 40.
const std::vector<std::string> kFloor = {"map_server.area.length=4", "map_server.area.width=2"};

/// Configures and activates; every state on the way is asked for.
void bring_up(Outsider& outside, const std::string& node) {
  EXPECT_EQ(outside.state(node), kUnconfigured) << node;
  EXPECT_TRUE(outside.change(node, kConfigure)) << node;
  EXPECT_EQ(outside.state(node), kInactive) << node;
  EXPECT_TRUE(outside.change(node, kActivate)) << node;
  EXPECT_EQ(outside.state(node), kActive) << node;
}

void bring_down(Outsider& outside, const std::string& node) {
  EXPECT_TRUE(outside.change(node, kDeactivate)) << node;
  EXPECT_EQ(outside.state(node), kInactive) << node;
  EXPECT_TRUE(outside.change(node, kCleanup)) << node;
  EXPECT_EQ(outside.state(node), kUnconfigured) << node;
}

CdrOut& header(CdrOut& cdr, const std::string& frame, std::chrono::nanoseconds stamp = {}) {
  return cdr.number(static_cast<std::int32_t>(stamp.count() / 1'000'000'000))
      .number(static_cast<std::uint32_t>(stamp.count() % 1'000'000'000))
      .text(frame);
}

CdrOut& pose(CdrOut& cdr, double x, double y) {
  for (const double value : {x, y, 0.0, 0.0, 0.0, 0.0, 1.0}) cdr.number(value);
  return cdr;
}

CdrOut& zeros(CdrOut& cdr, int count) {
  for (int i = 0; i < count; ++i) cdr.number(0.0);
  return cdr;
}

void skip_header(CdrIn& cdr, const std::string& frame) {
  cdr.number<std::int32_t>();
  cdr.number<std::uint32_t>();
  EXPECT_EQ(cdr.text(), frame);
}

void expect_floor(const Bytes& bytes) {
  CdrIn cdr(bytes);
  skip_header(cdr, "map");
  cdr.number<std::int32_t>();
  cdr.number<std::uint32_t>();
  EXPECT_FLOAT_EQ(cdr.number<float>(), 0.05F);
  EXPECT_EQ(cdr.number<std::uint32_t>(), 80U);
  EXPECT_EQ(cdr.number<std::uint32_t>(), 40U);
}

TEST(StandIns, MapServer) {
  StandIn server("map_server", kFloor);
  Outsider outside;
  EXPECT_TRUE(outside.sees_node("/map_server"));
  EXPECT_TRUE(outside.sees_topic("/map", "nav_msgs/msg/OccupancyGrid", true));
  EXPECT_TRUE(outside.sees_topic("/bond", "bond/msg/Status", true));
  EXPECT_TRUE(outside.sees_service("/map_server/map", "nav_msgs/srv/GetMap"));
  EXPECT_TRUE(outside.sees_service("/map_server/load_map", "nav2_msgs/srv/LoadMap"));
  auto* map = outside.listen("/map", "nav_msgs/msg/OccupancyGrid");
  auto* bond = outside.listen("/bond", "bond/msg/Status");
  bring_up(outside, "/map_server");
  EXPECT_TRUE(Outsider::hears(map, [](const Bytes& bytes) {
    expect_floor(bytes);
    return true;
  }));
  // bond/Status: header, id, instance_id, active, two floats.
  EXPECT_TRUE(Outsider::hears(bond, [](const Bytes& bytes) {
    CdrIn cdr(bytes);
    skip_header(cdr, "");
    const std::string id = cdr.text();
    cdr.text();
    return id == "map_server" && cdr.number<std::uint8_t>() == 1;
  }));
  const auto reply = outside.call("/map_server/map", "nav_msgs/srv/GetMap");
  ASSERT_TRUE(reply);
  expect_floor(*reply);
  bring_down(outside, "/map_server");
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

TEST(StandIns, PlannerServerAndTheCostmapInIt) {
  StandIn map("map_server", kFloor), server("planner_server");
  Outsider outside;
  for (const char* node : {"/planner_server", "/global_costmap/global_costmap"})
    EXPECT_TRUE(outside.sees_node(node));
  EXPECT_TRUE(outside.sees_action("/compute_path_to_pose", "nav2_msgs/action/ComputePathToPose"));
  EXPECT_TRUE(outside.sees_action("/compute_path_through_poses", "nav2_msgs/action/ComputePathThroughPoses"));
  EXPECT_TRUE(outside.sees_service("/is_path_valid", "nav2_msgs/srv/IsPathValid"));
  EXPECT_TRUE(outside.sees_topic("/plan", "nav_msgs/msg/Path", true));
  EXPECT_TRUE(outside.sees_topic("/global_costmap/costmap", "nav_msgs/msg/OccupancyGrid", true));
  EXPECT_TRUE(outside.sees_topic("/global_costmap/costmap_raw", "nav2_msgs/msg/Costmap", true));
  EXPECT_TRUE(
      outside.sees_topic("/global_costmap/published_footprint", "geometry_msgs/msg/PolygonStamped", true));
  const std::string folder = "/global_costmap/";
  EXPECT_TRUE(outside.sees_service(folder + "get_costmap", "nav2_msgs/srv/GetCostmap"));
  EXPECT_TRUE(
      outside.sees_service(folder + "clear_entirely_global_costmap", "nav2_msgs/srv/ClearEntireCostmap"));
  EXPECT_TRUE(
      outside.sees_service(folder + "clear_around_global_costmap", "nav2_msgs/srv/ClearCostmapAroundRobot"));
  EXPECT_TRUE(
      outside.sees_service(folder + "clear_except_global_costmap", "nav2_msgs/srv/ClearCostmapExceptRegion"));

  auto* costs = outside.listen("/global_costmap/costmap_raw", "nav2_msgs/msg/Costmap");
  auto* plan = outside.listen("/plan", "nav_msgs/msg/Path");
  bring_up(outside, "/map_server");
  EXPECT_EQ(outside.state("/global_costmap/global_costmap"), kUnconfigured);
  bring_up(outside, "/planner_server");
  EXPECT_EQ(outside.state("/global_costmap/global_costmap"), kActive);
  EXPECT_TRUE(Outsider::hears(costs, [](const Bytes& bytes) {
    CdrIn cdr(bytes);
    skip_header(cdr, "map");
    return true;
  }));
  EXPECT_TRUE(outside.call(folder + "clear_entirely_global_costmap", "nav2_msgs/srv/ClearEntireCostmap"));

  // Goal id, goal, start, planner_id, use_start; from (1, 1) to (3, 1).
  CdrOut goal;
  const std::vector<std::uint8_t> id(16, 7);
  pose(header(goal.octets(id), "map"), 3.0, 1.0);
  pose(header(goal, "map"), 1.0, 1.0);
  goal.text("GridBased").number(std::uint8_t{1});
  const std::string part = "/compute_path_to_pose/_action/", type = "nav2_msgs/action/ComputePathToPose";
  // CostmapMetaData: two stamps, layer, resolution, sizes, origin. The costmap has heard of the map, and so
  // has the planner soon.
  CdrOut specs;
  zeros(specs, 2).text("").number(0.0F).number(std::uint32_t{0}).number(std::uint32_t{0});
  pose(specs, 0.0, 0.0);
  ASSERT_TRUE(eventually([&] {
    const auto reply = outside.call("/global_costmap/get_costmap", "nav2_msgs/srv/GetCostmap", specs.bytes());
    return reply && reply->size() > 80U * 40U;
  }));
  const auto accepted = outside.call(part + "send_goal", type + "_SendGoal", goal.bytes());
  ASSERT_TRUE(accepted);
  EXPECT_EQ(CdrIn(*accepted).number<std::uint8_t>(), 1);
  const auto result = outside.call(part + "get_result", type + "_GetResult", CdrOut().octets(id).bytes());
  ASSERT_TRUE(result);
  CdrIn cdr(*result);
  EXPECT_EQ(cdr.number<std::uint8_t>(), 4) << "succeeded";
  skip_header(cdr, "map");
  EXPECT_EQ(cdr.number<std::uint32_t>(), 21U) << "poses: 2 m by 0.1 m";
  EXPECT_TRUE(Outsider::hears(plan, [](const Bytes&) { return true; }));

  EXPECT_TRUE(outside.change("/planner_server", kDeactivate));
  EXPECT_EQ(outside.state("/global_costmap/global_costmap"), kInactive);
  EXPECT_TRUE(outside.change("/planner_server", kCleanup));
  EXPECT_EQ(outside.state("/global_costmap/global_costmap"), kUnconfigured);
  bring_up(outside, "/planner_server");
  EXPECT_EQ(server.stop(), 0) << server.process().err();
  EXPECT_EQ(map.stop(), 0) << map.process().err();
}

TEST(StandIns, Amcl) {
  StandIn server("amcl");
  Outsider outside;
  EXPECT_TRUE(outside.sees_node("/amcl"));
  for (const auto& [topic, type] :
       std::map<std::string, std::string>{{"/scan", "sensor_msgs/msg/LaserScan"},
                                          {"/map", "nav_msgs/msg/OccupancyGrid"},
                                          {"/initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped"},
                                          {"/tf", "tf2_msgs/msg/TFMessage"}})
    EXPECT_TRUE(outside.sees_topic(topic, type, false)) << topic;
  EXPECT_TRUE(outside.sees_topic("/amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped", true));
  EXPECT_TRUE(outside.sees_topic("/particle_cloud", "nav2_msgs/msg/ParticleCloud", true));
  EXPECT_TRUE(outside.sees_topic("/tf", "tf2_msgs/msg/TFMessage", true));
  EXPECT_TRUE(outside.sees_service("/set_initial_pose", "nav2_msgs/srv/SetInitialPose"));
  EXPECT_TRUE(outside.sees_service("/request_nomotion_update", "std_srvs/srv/Empty"));
  EXPECT_TRUE(outside.sees_service("/reinitialize_global_localization", "std_srvs/srv/Empty"));

  auto* tf = outside.listen("/tf", "tf2_msgs/msg/TFMessage");
  auto* where = outside.listen("/amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped");
  auto* odom = outside.speak("/odom", "nav_msgs/msg/Odometry");
  bring_up(outside, "/amcl");
  CdrOut initial;
  zeros(pose(header(initial, "map"), 3.0, 1.0), 36);
  EXPECT_TRUE(outside.call("/set_initial_pose", "nav2_msgs/srv/SetInitialPose", initial.bytes()));
  EXPECT_TRUE(outside.call("/request_nomotion_update", "std_srvs/srv/Empty"));
  const auto drive = [&] {
    CdrOut cdr;
    zeros(pose(header(cdr, "odom", std::chrono::system_clock::now().time_since_epoch()).text("base_link"),
               0.0, 0.0),
          36 + 6 + 36);
    Bytes bytes = cdr.bytes();
    odom->write(&bytes);
  };
  EXPECT_TRUE(eventually([&] {
    drive();
    const auto bytes = Outsider::take(tf);
    if (!bytes) return false;
    CdrIn cdr(*bytes);
    EXPECT_EQ(cdr.number<std::uint32_t>(), 1U);
    skip_header(cdr, "map");
    EXPECT_EQ(cdr.text(), "odom");
    EXPECT_NEAR(cdr.number<double>(), 3.0, 1.0);  // a particle of the cloud around the pose
    return true;
  })) << server.process().err();
  EXPECT_TRUE(eventually([&] {
    drive();
    return Outsider::take(where).has_value();
  }));
  bring_down(outside, "/amcl");
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

// Without a laser nothing is let through, and the state says why.
TEST(StandIns, CollisionMonitor) {
  StandIn server("collision_monitor");
  Outsider outside;
  EXPECT_TRUE(outside.sees_node("/collision_monitor"));
  EXPECT_TRUE(outside.sees_topic("/cmd_vel_smoothed", "geometry_msgs/msg/Twist", false));
  EXPECT_TRUE(outside.sees_topic("/cmd_vel", "geometry_msgs/msg/Twist", true));
  EXPECT_TRUE(outside.sees_topic("/scan", "sensor_msgs/msg/LaserScan", false));
  EXPECT_TRUE(outside.sees_topic("/collision_monitor_state", "nav2_msgs/msg/CollisionMonitorState", true));
  auto* out = outside.listen("/cmd_vel", "geometry_msgs/msg/Twist");
  auto* state = outside.listen("/collision_monitor_state", "nav2_msgs/msg/CollisionMonitorState");
  auto* wanted = outside.speak("/cmd_vel_smoothed", "geometry_msgs/msg/Twist");
  bring_up(outside, "/collision_monitor");
  CdrOut ahead;
  zeros(ahead.number(0.5), 5);
  Bytes twist = ahead.bytes();
  const auto is_zero = [](const Bytes& bytes) {
    CdrIn cdr(bytes);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(cdr.number<double>(), 0.0);
    return true;
  };
  EXPECT_TRUE(eventually([&] {
    wanted->write(&twist);
    const auto bytes = Outsider::take(out);
    return bytes && is_zero(*bytes);
  }));
  EXPECT_TRUE(Outsider::hears(state, [](const Bytes& bytes) {
    CdrIn cdr(bytes);
    EXPECT_EQ(cdr.number<std::uint8_t>(), 1) << "STOP";
    return !cdr.text().empty();
  }));
  bring_down(outside, "/collision_monitor");
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

// Nav2's enable_stamped_cmd_vel is true from Kilted on.
TEST(StandIns, CollisionMonitorOfKiltedIsStamped) {
  StandIn server("collision_monitor", {"ros_distro=kilted"});
  Outsider outside;
  EXPECT_TRUE(outside.sees_topic("/cmd_vel_smoothed", "geometry_msgs/msg/TwistStamped", false));
  EXPECT_TRUE(outside.sees_topic("/cmd_vel", "geometry_msgs/msg/TwistStamped", true));
  EXPECT_EQ(server.stop(), 0) << server.process().err();
}

TEST(StandIns, TheDistroIsNamed) {
  for (const char* graph : {"planner_server", "amcl", "map_server", "collision_monitor"}) {
    StandIn server(graph, {"ros_distro=auto"});
    EXPECT_EQ(server.process().wait(std::chrono::seconds(20)), 2) << graph;
    EXPECT_THAT(server.process().err(), testing::HasSubstr(std::string(graph) + ".yaml:"));
    EXPECT_THAT(server.process().err(),
                testing::HasSubstr("ros_distro = auto: must be named beside lifecycle: external"));
  }
}

}  // namespace
}  // namespace bw::test
