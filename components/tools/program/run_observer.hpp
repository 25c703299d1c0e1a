// The run verb's own component: follows the score card, shows progress on one line, ends the run when the
// goal is decided.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/score_card.hpp>

#include "runtime/component.hpp"

namespace bw {

/// What the observer has seen; shared with the verb, read after the run.
struct Observation {
  std::optional<bandwagon_msgs::msg::ScoreCard> card;
};

class RunObserver final : public Component {
 public:
  /// `planner_ms`: the planner's last known median cycle time, for the progress line. `show_progress`: write
  /// that line to stderr.
  RunObserver(std::shared_ptr<Observation> seen, bool show_progress, std::function<double()> planner_ms)
      : seen_(std::move(seen)), show_progress_(show_progress), planner_ms_(std::move(planner_ms)) {}

  void configure(Setup& setup) override;

 private:
  void show(const bandwagon_msgs::msg::ScoreCard& card, Time now);

  std::shared_ptr<Observation> seen_;
  bool show_progress_;
  std::function<double()> planner_ms_;
  std::optional<Time> started_;
  std::function<void(bool, const std::string&)> finish_run_;
};

}  // namespace bw
