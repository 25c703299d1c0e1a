// Adaptor: odometry, tracks, obstacles and follow requests in; velocity commands out. Topics: README.md.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav_msgs/msg/path.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/local_planner/adaptor/cycle_watch.hpp"
#include "components/local_planner/adaptor/surroundings.hpp"
#include "components/local_planner/local_planner_parameters.hpp"
#include "components/local_planner/plan_window.hpp"
#include "components/messages/speed_limit.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/worker_pool.hpp"

namespace bw {

class LocalPlannerComponent final : public Component {
 public:
  void configure(Setup& setup) override;
  void activate(const Tick& tick) override;
  void deactivate(const Tick& tick) override;
  void cleanup() override;

 private:
  /// From the next cycle on; the planner goes on from where it is.
  void use(const LocalPlannerParameters& parameters);
  void on_request(const bandwagon_msgs::msg::FollowRequest& request);
  void control_cycle(const Tick& tick);
  /// `missing` names what is needed and not there yet.
  PlanningProblem make_problem(const Tick& tick, std::string& missing);
  void publish(const Tick& tick, const PlanningProblem& problem, const PlanningResult& result);

  LocalPlannerParameters parameters_;
  Robot robot_;
  double period_ = 0.1;  ///< [s] between cycles
  std::size_t threads_ = 1;
  std::optional<WorkerPool> pool_;  ///< none in lock-step
  std::optional<CycleWatch> watch_;
  std::string odom_frame_;
  std::unique_ptr<LocalPlanner> planner_;
  bandwagon_msgs::msg::FollowRequest request_;
  FollowedPlan plan_;    ///< in map
  std::string told_;     ///< about tolerances that are not used
  bool at_rest_ = true;  ///< STOP was obeyed: nothing more to say

  LimitedSpeed speed_;
  Surroundings surroundings_;
  Output<geometry_msgs::msg::Twist> command_;
  Output<bandwagon_msgs::msg::FollowStatus> status_;
  Output<nav_msgs::msg::Path> trajectory_;
  Output<visualization_msgs::msg::MarkerArray> markers_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  PlanningStatus last_status_ = PlanningStatus::ok;
};

}  // namespace bw
