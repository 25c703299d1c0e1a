#include "components/local_planner/adaptor/local_planner_component.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "components/local_planner/adaptor/follow_messages.hpp"
#include "components/local_planner/adaptor/planner_process.hpp"
#include "components/local_planner/back_off.hpp"
#include "components/local_planner/driving.hpp"
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
      {"algorithm", "controller_frequency", "max_iterations", "max_cycle_time", "threads",
       "enable_stamped_cmd_vel"});
  robot_ = setup.shared<Robot>("robot");
  planner_ = make_planner(parameters_.algorithm, parameters_.planners);
  if (is_planner_program(parameters_.algorithm))
    setup.longest_callback(Duration{std::chrono::nanoseconds(PlannerPatience{}.first).count()});
  period_ = 1.0 / parameters_.controller_frequency;
  threads_ = thread_count(parameters_.threads, setup.is_lockstep());
  watch_.emplace(period_, parameters_.max_cycle_time > 0.0 ? parameters_.max_cycle_time : 0.5 * period_,
                 static_cast<int>(parameters_.max_iterations), !setup.is_lockstep());
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  diagnostics_->set_value("planner", planner_label(parameters_.algorithm));
  inputs_.listen(setup, robot_);
  base_.listen(setup);
  setup.input<bandwagon_msgs::msg::FollowRequest>(
      "follow_request", Qos::standard(), [this](const auto& request, const Tick&) { on_request(request); },
      Need::optional);
  command_.offer(setup, "cmd_vel_nav", is_stamped(parameters_.enable_stamped_cmd_vel, setup.ros_distro()));
  brake_hard_ = setup.output<std_msgs::msg::Bool>("brake_hard");
  status_ = setup.output<bandwagon_msgs::msg::FollowStatus>("follow_status");
  cycle_ = setup.output<bandwagon_msgs::msg::PlannerCycle>("local_planner_cycle");
  trajectory_ = setup.output<nav_msgs::msg::Path>("local_plan");
  markers_ = setup.output<visualization_msgs::msg::MarkerArray>("local_planner_markers");
  offer_follow_path(setup);
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
  follow_path_.set_options(parameters.follow_path);
}

PlanningProblem LocalPlannerComponent::make_problem(const Tick& tick, std::string& missing) {
  PlanningProblem problem = inputs_.problem(tick.now, missing);
  problem.limits.v_back_max = backward_.update(commanded_, problem.twist.v, problem.limits.v_back_max);
  problem.control_period = period_;
  problem.command_lead = parameters_.command_lead;
  problem.goal_tolerance = task_.tolerance;
  problem.budget = watch_->budget();
  if (pool_) {
    problem.parallel_for = [this](std::size_t count, const auto& body) { pool_->run(count, body); };
  }
  X_OF_.reset();
  if (!inputs_.pose() || task_.mode != mode::FOLLOW) return problem;
  X_OF_ = inputs_.pose_in_odom(task_.frame, missing, tick.now);
  if (!X_OF_) return problem;
  FollowLimits limits{.lookahead = parameters_.max_global_plan_lookahead_dist, .tolerance = task_.tolerance};
  if (task_.is_of_action) limits.max_deviation = parameters_.follow_path.max_path_deviation;
  const PathLeg& leg = path_.leg(inverse(*X_OF_) * problem.pose, limits);
  for (const Pose2& X_FP : leg.poses) problem.plan.push_back(*X_OF_ * X_FP);
  problem.goal_is_final = leg.goal_is_final;
  problem.goal_tolerance = leg.tolerance;
  if (leg.begins) planner_->reset();
  return problem;
}

void LocalPlannerComponent::control_cycle(const Tick& tick) {
  watch_->begin();
  std::string missing;
  PlanningProblem problem = make_problem(tick, missing);
  PlanningResult result = stopped(problem, PlanningStatus::no_plan, "");
  if (tick.health == Health::stop) {
    result.reason = "a needed input is stale";
  } else if (!missing.empty()) {
    result.reason = missing;
  } else if (task_.mode == mode::BACK_OFF) {
    result = back_off(problem, parameters_.command_lead, parameters_.back_off_margin);
  } else if (task_.mode == mode::FOLLOW) {
    result = planner_->plan(problem);
  }
  if (follow_path_.is_driving()) report(tick, problem, result, missing);
  publish(tick, problem, result);
}

void LocalPlannerComponent::deactivate(const Tick& tick) {
  if (follow_path_.is_driving()) {
    task_ = {};
    at_rest_ = true;
  }
  follow_path_.forget();
  command_.publish({}, tick.now);
}

void LocalPlannerComponent::cleanup() { pool_.reset(); }

BW_COMPONENT(LocalPlannerComponent, "local_planner")

}  // namespace bw
