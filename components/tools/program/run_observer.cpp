#include "components/tools/program/run_observer.hpp"

#include <iostream>

#include <fmt/format.h>

namespace bw {

void RunObserver::configure(Setup& setup) {
  finish_run_ = setup.finish_run();
  setup.input<bandwagon_msgs::msg::ScoreCard>(
      "score_card", Qos::standard(), [this](const bandwagon_msgs::msg::ScoreCard& card, const Tick& tick) {
        if (!started_) started_ = tick.now;
        seen_->card = card;
        if (show_progress_) show(card, tick.now);
        if (card.finished()) finish_run_(card.reached(), card.reason());
      });
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
