#include "components/tools/program/run_observer.hpp"

#include <iostream>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <fmt/format.h>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

constexpr std::size_t kBeforeDrive = 10;  // looks at the truth: the first score card comes half a second late

}  // namespace

void RunObserver::configure(Setup& setup) {
  finish_run_ = setup.finish_run();
  setup.input<bandwagon_msgs::msg::ScoreCard>(
      "score_card", Qos::standard(), [this](const bandwagon_msgs::msg::ScoreCard& card, const Tick& tick) {
        if (!started_) started_ = tick.now;
        seen_->card = card;
        if (show_progress_) show(card, tick.now);
        if (card.finished() && !stays_) finish_run_(card.reached(), card.reason());
      });
  setup.input<bandwagon_msgs::msg::GroundTruth>(
      "sim/ground_truth", Qos::standard(),
      [this](const auto& truth, const Tick&) {
        const Time time = from_stamp(truth.header().stamp());
        if (!seen_->path.empty() && time - seen_->path.back().time < kPathPeriod) return;
        seen_->path.push_back({time, from_pose(truth.pose())});
        if (!seen_->card && seen_->path.size() > kBeforeDrive) seen_->path.erase(seen_->path.begin());
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
