#include "components/program/several_cards.hpp"

#include <algorithm>

namespace bw {
namespace {

using Card = bandwagon_msgs::msg::ScoreCard;

/// A figure that was not measured (NaN) is no worst one.
double larger(double a, double b) { return a > b || b != b ? a : b; }

void add_outcome(Card& all, const Card& one, const std::string& robot) {
  if (all.reached() && !one.reached()) all.reason(robot + ": " + one.reason());
  all.reached(all.reached() && one.reached());
  all.finished(all.finished() && one.finished());
}

void add_figures(Card& all, const Card& one) {
  all.time_to_goal_s(std::max(all.time_to_goal_s(), one.time_to_goal_s()));
  all.path_length_m(std::max(all.path_length_m(), one.path_length_m()));
  all.distance_to_goal_m(std::max(all.distance_to_goal_m(), one.distance_to_goal_m()));
  all.min_distance_m(std::min(all.min_distance_m(), one.min_distance_m()));
  all.closest_person_m(std::min(all.closest_person_m(), one.closest_person_m()));
  all.collisions(all.collisions() + one.collisions());
  all.collisions_at_speed(all.collisions_at_speed() + one.collisions_at_speed());
  all.max_collision_index(std::max(all.max_collision_index(), one.max_collision_index()));
  all.max_collision_index_045(std::max(all.max_collision_index_045(), one.max_collision_index_045()));
  all.share_ci_above_0_54(std::max(all.share_ci_above_0_54(), one.share_ci_above_0_54()));
  all.share_ci_above_0_14(std::max(all.share_ci_above_0_14(), one.share_ci_above_0_14()));
  all.mean_speed_mps(std::min(all.mean_speed_mps(), one.mean_speed_mps()));
  all.rms_jerk_mps3(std::max(all.rms_jerk_mps3(), one.rms_jerk_mps3()));
  all.localization_poses(std::min(all.localization_poses(), one.localization_poses()));
  all.localization_mean_m(larger(all.localization_mean_m(), one.localization_mean_m()));
  all.localization_rms_m(larger(all.localization_rms_m(), one.localization_rms_m()));
  all.localization_max_m(larger(all.localization_max_m(), one.localization_max_m()));
  all.localization_rms_rad(larger(all.localization_rms_rad(), one.localization_rms_rad()));
}

}  // namespace

std::optional<Card> card_of_all(const std::vector<RobotCard>& cards) {
  std::optional<Card> all;
  bool is_somebody_missing = false;
  for (const auto& [robot, card] : cards) {
    is_somebody_missing = is_somebody_missing || !card;
    if (!card) continue;
    if (all) {
      add_outcome(*all, *card, robot);
      add_figures(*all, *card);
    } else {
      all = card;
      if (cards.size() > 1 && !card->reached()) all->reason(robot + ": " + card->reason());
    }
  }
  if (all && is_somebody_missing) {
    if (all->reached()) all->reason("not all robots have begun");
    all->reached(false);
    all->finished(false);
  }
  return all;
}

}  // namespace bw
