// The planner in lock-step, in a world of its own. Map: 10 x 6 m, cells of 0.1 m, a wall one cell thick at x
// = 5.0 to 5.1 m, a block of 2 x 2 m in the corner at (10, 6); the
// robot, of 0.3 m, stands at (1, 3). Odometry began elsewhere: odom is rotated by a right angle.
#pragma once

#include <functional>
#include <numbers>
#include <string>

#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {

inline const Pose2 kX_MO{1.0, 3.0, std::numbers::pi / 2.0};

inline OccupancyGrid floor_with_wall() {
  OccupancyGrid map{.resolution = 0.1, .width = 100, .height = 60};
  map.cells.assign(6000, OccupancyGrid::kFree);
  for (int row = 0; row < map.height; ++row) map.cells[map.index(50, row)] = OccupancyGrid::kOccupied;
  for (int row = 40; row < 60; ++row) {
    for (int column = 80; column < 100; ++column)
      map.cells[map.index(column, row)] = OccupancyGrid::kOccupied;
  }
  return map;
}

struct PlannerWorld {
  bool has_map = true;
  bool knows_its_pose = true;
  std::string distro = "jazzy";
  Pose2 X_OB{};      ///< of the robot in odom
  std::string more;  ///< further components, in YAML, indented by two
  double seconds = 3.0;
};

/// The planner's node is `global_planner`, its costmap /global_costmap/global_costmap.
inline void run_planner(const PlannerWorld& world, const std::function<void(Setup&)>& ask) {
  const std::string yaml =
      "ros_distro: " + world.distro +
      "\ncomponents:\n  global_planner:\n  global_costmap: {namespace: global_costmap, remap: {map: /map, keepout_filter_mask: /keepout_filter_mask}}\n" +
      world.more;
  run_with_script(yaml, world.seconds, [&](Setup& setup) {
    setup.output<bandwagon_msgs::msg::PlanRequest>("plan_request");  // somebody feeds it
    setup.every(Duration::milliseconds(100), "world",
                [world, map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched()),
                 tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                  if (tick.sequence == 0 && world.has_map)
                    map.publish(to_message(floor_with_wall(), "map", tick.now));
                  if (!world.knows_its_pose) return;
                  tf2_msgs::msg::TFMessage message;
                  message.transforms().push_back(to_transform("map", "odom", tick.now, kX_MO));
                  message.transforms().push_back(to_transform("odom", "base_link", tick.now, world.X_OB));
                  tf.publish(message);
                });
    ask(setup);
  });
}

}  // namespace bw
