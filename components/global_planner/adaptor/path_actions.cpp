#include "components/global_planner/adaptor/path_actions.hpp"

#include <chrono>
#include <memory>
#include <utility>

#include "components/global_planner/adaptor/path_answer.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/nav2_error_codes.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

/// What both actions share.
struct PathServer {
  MapPlanner& planner;
  std::function<void(const nav_msgs::msg::Path&)> show;
  Logger log;
  bool is_lockstep = false;
};

template <class Goal>
PathQuestion question_of(const Goal& goal) {
  PathQuestion question{.route = {}, .planner_id = goal.planner_id()};
  if (goal.use_start()) question.route.start = goal.start();
  if constexpr (requires { goal.goal(); }) {
    const auto via = via_points(goal);
    question.route.stops.assign(via.begin(), via.end());
    question.route.stops.push_back(goal.goal());
  } else {
    question.route.stops = goal_poses(goal);
  }
  return question;
}

template <class Action>
constexpr Nav2ErrorCode code_of(Nav2ErrorCode to_pose) {
  return requires(const typename Action::Goal& goal) { goal.goal(); }
  ? to_pose : of_through_poses(to_pose);
}

template <class Action>
void answer(const GoalHandle<Action>& handle, const PathServer& server, const Tick& tick) {
  typename Action::Result result;
  set_last_reached_index(result, -1);
  if (handle.is_canceling()) return handle.canceled(result);
  handle.execute();
  const auto began = std::chrono::steady_clock::now();
  const PathAnswer answer = answer_question(server.planner, question_of(handle.goal()), tick.now);
  if (!answer.is_found) {
    server.log.warn("no path: {}", answer.reason);
    set_error(result, code_of<Action>(answer.error), answer.reason);
    return handle.abort(result);
  }
  // In lock-step nothing measured on a real clock may enter a sample.
  if (!server.is_lockstep)
    result.planning_time(
        to_message(Duration{std::chrono::nanoseconds(std::chrono::steady_clock::now() - began).count()}));
  server.show(answer.path);
  result.path(answer.path);
  handle.succeed(result);
}

template <class Action>
void offer(Setup& setup, const std::string& name, const std::shared_ptr<const PathServer>& server) {
  setup.action<Action>(
      name, {.on_goal = [server](const GoalHandle<Action>& handle,
                                 const Tick& tick) { answer(handle, *server, tick); },
             // Nothing is left to be canceled: a goal is answered when it is heard.
             .on_cancel = [](const GoalHandle<Action>& handle, const Tick&) { handle.canceled({}); },
             .abandoned =
                 [](const std::string& reason) {
                   typename Action::Result result;
                   set_last_reached_index(result, -1);
                   set_error(result, code_of<Action>(compute_path_error::kUnknown), reason);
                   return result;
                 }});
}

}  // namespace

void offer_path_actions(Setup& setup, MapPlanner& planner,
                        std::function<void(const nav_msgs::msg::Path&)> show) {
  const auto server = std::make_shared<const PathServer>(PathServer{
      .planner = planner, .show = std::move(show), .log = setup.log(), .is_lockstep = setup.is_lockstep()});
  with_nav2_layout(setup.ros_distro(), [&]<class Nav2>(Nav2) {
    offer<typename Nav2::ComputePathToPose>(setup, "compute_path_to_pose", server);
    offer<typename Nav2::ComputePathThroughPoses>(setup, "compute_path_through_poses", server);
  });
}

}  // namespace bw
