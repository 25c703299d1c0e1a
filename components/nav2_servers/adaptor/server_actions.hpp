// Actions and services of Nav2's servers as the bridge asks them, whichever distribution lays them out.
#pragma once

#include <functional>
#include <string>

#include <bandwagon_msgs/msg/plan_request.hpp>
#include <nav_msgs/msg/path.hpp>

#include "components/nav2_servers/drive_relay.hpp"
#include "components/nav2_servers/nav2_servers_parameters.hpp"
#include "runtime/component.hpp"

namespace bw {

struct ServerCallbacks {
  std::function<void(bool accepted, const Tick& tick)> on_acknowledged;
  /// The path of a planner; empty of others.
  std::function<void(const ServerEnd& end, const nav_msgs::msg::Path& path, const Tick& tick)> on_end;
};

/// An action that is asked with an Order.
template <class Order>
struct ServerAction {
  std::function<bool()> is_ready;
  std::function<GoalId(const Order& order, const ServerCallbacks& callbacks)> send;
  std::function<void(const GoalId& id)> cancel;
};

/// How far and how fast to drive back.
struct BackUpOrder {
  double distance = 0.0;  ///< [m]
  double speed = 0.0;     ///< [m/s]
  Duration time;          ///< at most
};

struct ServerActions {
  ServerAction<bandwagon_msgs::msg::PlanRequest> compute_path;  ///< through its via poses, where it has some
  ServerAction<nav_msgs::msg::Path> follow_path;
  ServerAction<BackUpOrder> back_up;
  std::function<void()> clear_local_costmap;
  std::function<void()> clear_global_costmap;
};

/// Clients of them, in the layout of the graph's `ros_distro`. None of the servers has to be there.
/// `parameters` outlive them.
ServerActions declare_server_actions(Setup& setup, const Nav2ServersParameters& parameters);

}  // namespace bw
