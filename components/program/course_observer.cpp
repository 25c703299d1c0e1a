#include "components/program/course_observer.hpp"

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/obstacles.hpp"
#include "components/model/robot.hpp"

namespace bw {

void CourseObserver::configure(Setup& setup) {
  listener_.listen(setup);
  setup.input<bandwagon_msgs::msg::GroundTruth>(
      listener_.topics().truth, Qos::standard(),
      [this](const auto& truth, const Tick&) { listener_.on_truth(truth); }, Need::optional);
}

void CourseListener::listen(Setup& setup) {
  const auto robot = setup.shared<Robot>("robot");
  course_->emplace(robot.outline(), robot.limits.v_max);
  (*course_)->set_limits(robot.limits);
  hear_goals(setup);
  hear_map(setup);
}

void CourseListener::on_truth(const bandwagon_msgs::msg::GroundTruth& truth) {
  if (started_) (*course_)->add(to_truth(truth));
}

void CourseListener::hear_goals(Setup& setup) {
  setup.input<bandwagon_msgs::msg::NavigationStatus>(
      topics_.status, Qos::standard(),
      [this](const auto& message, const Tick& tick) {
        const GoalNews news = to_goal_news(message);
        if (news.is_over || (started_ && news.goal_id == goal_id_)) return;
        goal_id_ = news.goal_id;
        if (!started_) (*course_)->start(tick.now);
        started_ = true;
        (*course_)->add_goal(news.goal);
      },
      Need::optional);
}

void CourseListener::hear_map(Setup& setup) {
  listen_to_map(
      setup, [this](const KnownMap& map, const Tick&) { (*course_)->set_map(map.grid); }, Need::optional,
      topics_.map);
  setup.input<nav_msgs::msg::OccupancyGrid>(
      topics_.true_map, Qos::latched(),
      [this](const auto& message, const Tick&) {
        OccupancyGrid map;
        if (read_grid(message, map).empty()) (*course_)->set_true_map(map);
      },
      Need::optional);
  setup.input<bandwagon_msgs::msg::Obstacles>(
      topics_.shapes, Qos::latched(),
      [this](const auto& message, const Tick&) { (*course_)->set_shapes(to_obstacles(message, Pose2{})); },
      Need::optional);
}

}  // namespace bw
