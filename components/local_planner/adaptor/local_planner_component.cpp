#include "components/local_planner/adaptor/local_planner_component.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "components/local_planner/adaptor/planner_markers.hpp"
#include "components/local_planner/adaptor/problem_messages.hpp"
#include "components/local_planner/back_off.hpp"
#include "components/local_planner/command_limits.hpp"
#include "components/messages/geometry.hpp"

namespace bw {
namespace {

namespace mode = bandwagon_msgs::msg::FollowRequest_Constants;

/// The parameter `threads`, for this machine and clock.
std::size_t thread_count(std::int64_t wanted, bool lockstep) {
  if (lockstep) return 1;
  return wanted > 0 ? static_cast<std::size_t>(wanted)
                    : std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 4);
}

}  // namespace

void LocalPlannerComponent::configure(Setup& setup) {
  parameters_ = setup.parameters<LocalPlannerParameters>(
      [this](const LocalPlannerParameters& changed, const Tick&) { use(changed); },
      {"algorithm", "controller_frequency", "max_iterations", "max_cycle_time", "threads"});
  robot_ = setup.shared<Robot>("robot");
  planner_ = make_planner(parameters_.algorithm, parameters_.planners);
  period_ = 1.0 / parameters_.controller_frequency;
  threads_ = thread_count(parameters_.threads, setup.is_lockstep());
  watch_.emplace(period_, parameters_.max_cycle_time > 0.0 ? parameters_.max_cycle_time : 0.5 * period_,
                 static_cast<int>(parameters_.max_iterations), !setup.is_lockstep());
  odom_frame_ = setup.frame("odom");
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  diagnostics_->set_value("planner", parameters_.algorithm);
  surroundings_.listen(setup);
  speed_.listen(setup, robot_.limits);
  setup.input<bandwagon_msgs::msg::FollowRequest>(
      "follow_request", Qos::standard(), [this](const auto& request, const Tick&) { on_request(request); });
  command_ = setup.command<geometry_msgs::msg::Twist>("cmd_vel_nav");
  status_ = setup.output<bandwagon_msgs::msg::FollowStatus>("follow_status");
  trajectory_ = setup.output<nav_msgs::msg::Path>("local_plan");
  markers_ = setup.output<visualization_msgs::msg::MarkerArray>("local_planner_markers");
  setup.every(Duration::seconds(period_), "control_cycle", [this](const Tick& tick) { control_cycle(tick); });
}

void LocalPlannerComponent::activate(const Tick&) {
  if (threads_ > 1) pool_.emplace(threads_);
}

void LocalPlannerComponent::use(const LocalPlannerParameters& parameters) {
  std::unique_ptr<LocalPlanner> planner = make_planner(parameters.algorithm, parameters.planners);
  planner->continue_from(*planner_);
  planner_ = std::move(planner);
  parameters_ = parameters;
}

void LocalPlannerComponent::on_request(const bandwagon_msgs::msg::FollowRequest& request) {
  if (request.mode() != request_.mode()) planner_->reset();
  request_ = request;
  plan_.start(from_path(request.path()));
  const std::string complaint = tolerance_complaint(goal_tolerance_of(request), parameters_.planners.driving);
  if (complaint != std::exchange(told_, complaint) && !complaint.empty()) log_.warn("{}", complaint);
  if (request.mode() != mode::STOP) at_rest_ = false;
}

PlanningProblem LocalPlannerComponent::make_problem(const Tick& tick, std::string& missing) {
  PlanningProblem problem{.now = tick.now, .footprint = {.radius = robot_.radius}, .limits = speed_.limits()};
  problem.control_period = period_;
  problem.command_lead = parameters_.command_lead;
  problem.goal_tolerance = goal_tolerance_of(request_);
  problem.budget = watch_->budget();
  if (pool_) {
    problem.parallel_for = [this](std::size_t count, const auto& body) { pool_->run(count, body); };
  }
  missing = surroundings_.fill(problem);
  if (!missing.empty() || request_.mode() != mode::FOLLOW) return problem;
  const auto X_OM = surroundings_.pose_of(request_.path().header().frame_id(), missing);
  if (!X_OM) return problem;
  const PlanWindow& window =
      plan_.window(inverse(*X_OM) * problem.pose, parameters_.max_global_plan_lookahead_dist);
  for (const Pose2& X_MP : window.poses) problem.plan.push_back(*X_OM * X_MP);
  problem.goal_is_final = window.goal_is_final;
  return problem;
}

void LocalPlannerComponent::control_cycle(const Tick& tick) {
  watch_->begin();
  std::string missing;
  PlanningProblem problem = make_problem(tick, missing);
  PlanningResult result;
  result.command = stop_twist(problem.twist, robot_.limits, parameters_.command_lead);
  if (tick.health == Health::stop) {
    result.reason = "a needed input is stale";
  } else if (!missing.empty()) {
    result.reason = missing;
  } else if (request_.mode() == mode::BACK_OFF) {
    result = back_off(problem, parameters_.command_lead, parameters_.back_off_margin);
  } else if (request_.mode() == mode::FOLLOW) {
    result = planner_->plan(problem);
  }
  publish(tick, problem, result);
}

void LocalPlannerComponent::publish(const Tick& tick, const PlanningProblem& problem,
                                    const PlanningResult& result) {
  const bool idle = request_.mode() == mode::STOP;
  if (!(idle && at_rest_)) command_.publish(to_twist_message(result.command));
  at_rest_ = idle && result.command == Twist2{};

  bandwagon_msgs::msg::FollowStatus status = to_follow_status(result, idle);
  status.header(make_header(odom_frame_, tick.now));
  status.id(request_.id());
  status.distance_to_goal(plan_.distance_to_goal());
  status_.publish(status);
  watch_->report(result, idle, *diagnostics_);
  if (idle) return;
  if (result.status != last_status_ && result.status != PlanningStatus::ok) log_.warn("{}", result.reason);
  last_status_ = result.status;
  if (trajectory_.has_readers()) {
    std::vector<Pose2> poses;
    for (const TrajectoryPoint& point : result.trajectory) poses.push_back(point.pose);
    trajectory_.publish(to_path(odom_frame_, tick.now, poses));
  }
  if (markers_.has_readers()) markers_.publish(to_markers(problem, result, odom_frame_));
  watch_->end(result);
}

void LocalPlannerComponent::deactivate(const Tick&) { command_.publish({}); }

void LocalPlannerComponent::cleanup() { pool_.reset(); }

BW_COMPONENT(LocalPlannerComponent, "local_planner")

}  // namespace bw
