#include "components/program/run_observer.hpp"

#include <iostream>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "components/program/several_cards.hpp"

namespace bw {
namespace {

constexpr std::size_t kBeforeDrive = 10;  // looks at the truth: the first score card comes half a second late

}  // namespace

std::optional<bandwagon_msgs::msg::ScoreCard> Observation::card() const {
  std::vector<RobotCard> cards;
  for (const RobotObservation& robot : robots) cards.emplace_back(robot.robot, robot.card);
  return card_of_all(cards);
}

void RunObserver::configure(Setup& setup) {
  finish_run_ = setup.finish_run();
  for (CourseListener& course : courses_) course.listen(setup);
  for (std::size_t i = 0; i < seen_->robots.size(); ++i) listen(setup, i);
}

void RunObserver::listen(Setup& setup, std::size_t index) {
  RobotObservation& robot = seen_->robots[index];
  setup.input<bandwagon_msgs::msg::ScoreCard>(
      robot.card_topic, Qos::standard(),
      [this, &robot](const bandwagon_msgs::msg::ScoreCard& card, const Tick& tick) {
        if (!started_) started_ = tick.now;
        robot.card = card;
        const auto all = seen_->card();
        if (show_progress_) show(*all, tick.now);
        if (all->finished() && !stays_) finish_run_(all->reached(), all->reason());
      });
  setup.input<bandwagon_msgs::msg::GroundTruth>(
      robot.truth_topic, Qos::standard(),
      [this, &robot, index](const auto& truth, const Tick&) {
        if (index < courses_.size()) courses_[index].on_truth(truth);
        const Time time = from_stamp(truth.header().stamp());
        if (!robot.thinning.is_due(time)) return;
        robot.thinning.add(time, PathPoint{time, from_pose(truth.pose())}, robot.path);
        if (!robot.card && robot.path.size() > kBeforeDrive) robot.path.erase(robot.path.begin());
      },
      Need::optional);
}

void RunObserver::show(const bandwagon_msgs::msg::ScoreCard& card, Time now) {
  const std::string person = card.closest_person_m() < 1e3 ? fmt::format("{:5.2f} m", card.closest_person_m())
                                                           : std::string("   none");
  std::cerr << fmt::format(
                   "\r{:6.1f} s | to goal {:5.1f} m | planner {:5.2f} ms | closest person so far {} | "
                   "contacts {}   ",
                   (now - *started_).to_seconds(), card.distance_to_goal_m(), planner_ms_(), person,
                   card.collisions())
            << (card.finished() ? "\n" : "") << std::flush;
}

}  // namespace bw
