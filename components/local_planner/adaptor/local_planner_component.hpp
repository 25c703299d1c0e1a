// Adaptor: odometry, tracks, obstacles and what is to be followed in; velocity commands out. Topics:
// README.md.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/planner_cycle.hpp>
#include <nav_msgs/msg/path.hpp>
#include <std_msgs/msg/bool.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/local_planner/adaptor/cycle_watch.hpp"
#include "components/local_planner/adaptor/follow_path_server.hpp"
#include "components/local_planner/backward_speed.hpp"
#include "components/local_planner/followed_path.hpp"
#include "components/local_planner/local_planner_parameters.hpp"
#include "components/messages/base_stop_source.hpp"
#include "components/messages/planning_inputs.hpp"
#include "components/messages/velocity_output.hpp"
#include "components/model/robot.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/worker_pool.hpp"

namespace bw {

/// What is to be done until something else is asked for.
struct FollowTask {
  std::uint8_t mode = bandwagon_msgs::msg::FollowRequest_Constants::STOP;
  std::string frame;  ///< of the path
  GoalTolerance tolerance;
  bool is_of_action = false;  ///< not of follow_request
};

class LocalPlannerComponent final : public Component {
 public:
  void configure(Setup& setup) override;
  void activate(const Tick& tick) override;
  void deactivate(const Tick& tick) override;
  void cleanup() override;

 private:
  void offer_follow_path(Setup& setup);
  /// From the next cycle on; the planner goes on from where it is.
  void use(const LocalPlannerParameters& parameters);
  void on_request(const bandwagon_msgs::msg::FollowRequest& request);
  void on_path(const std::string& frame, std::vector<Pose2> poses);
  void begin(FollowTask task, std::vector<Pose2> path);
  void come_to_rest(const Tick& tick);
  void control_cycle(const Tick& tick);
  /// `missing` names what is needed and not there yet.
  PlanningProblem make_problem(const Tick& tick, std::string& missing);
  /// For the goal of follow_path in hand: how it stands.
  void report(const Tick& tick, const PlanningProblem& problem, const PlanningResult& result,
              const std::string& missing);
  void publish(const Tick& tick, const PlanningProblem& problem, const PlanningResult& result);
  void tell_doubts();
  void publish_status(const Tick& tick, const PlanningResult& result, bool idle);
  void publish_cycle(const Tick& tick, const PlanningResult& result, bool idle);

  LocalPlannerParameters parameters_;
  Robot robot_;
  double period_ = 0.1;  ///< [s] between cycles
  std::size_t threads_ = 1;
  std::optional<WorkerPool> pool_;  ///< none in lock-step
  std::optional<CycleWatch> watch_;
  std::unique_ptr<LocalPlanner> planner_;
  FollowTask task_;
  FollowedPath path_;
  std::optional<Pose2> X_OF_;     ///< of the path's frame in odom, as of this cycle
  std::uint64_t request_id_ = 0;  ///< of the last follow_request
  std::string request_lost_;  ///< why that is not what is done any more; empty: it is, or was only to stop
  std::string told_;          ///< about tolerances that are not used
  Complaint doubt_;           ///< about tracks that do not tell their confidence
  bool at_rest_ = true;       ///< a stop was obeyed: nothing more to say

  PlanningInputs inputs_;
  BaseStopSource base_;
  FollowPathServer follow_path_;
  VelocityOutput command_;
  Output<std_msgs::msg::Bool> brake_hard_;
  Output<bandwagon_msgs::msg::FollowStatus> status_;
  Output<bandwagon_msgs::msg::PlannerCycle> cycle_;
  Output<nav_msgs::msg::Path> trajectory_;
  Output<visualization_msgs::msg::MarkerArray> markers_;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  PlanningStatus last_status_ = PlanningStatus::ok;
  BackwardSpeed backward_;
  double commanded_ = 0.0;  ///< speed of the last command [m/s]
  bool was_hard_ = false;   ///< brake_hard was told last
};

}  // namespace bw
