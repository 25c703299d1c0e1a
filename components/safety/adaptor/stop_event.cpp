// `stop`: somebody wants to drive, and the collision monitor stops it.
#include <nav2_msgs/msg/collision_monitor_state.hpp>

#include "runtime/event.hpp"

using bw::EventRule;

BW_EVENT(stop, "collision_monitor", "collision_monitor_state", "the collision monitor stops the robot",
         {{.field = "action_type",
           .rule = EventRule::is,
           .number = nav2_msgs::msg::CollisionMonitorState_Constants::STOP},
          {.field = "polygon_name", .rule = EventRule::is_not, .text = "command_silent"}})
