#include "components/evaluation/adaptor/truth_messages.hpp"

#include <cmath>
#include <limits>

#include "components/messages/geometry.hpp"

namespace bw {

TruthSample to_truth(const bandwagon_msgs::msg::GroundTruth& message) {
  TruthSample sample;
  sample.time = from_stamp(message.header().stamp());
  sample.X_MB = from_pose(message.pose());
  sample.twist = from_twist(message.twist());
  sample.wall_gap = message.wall_clearance();
  sample.contacts = message.contacts();
  sample.people.reserve(message.people().size());
  for (const auto& person : message.people()) {
    sample.people.push_back({person.id(),
                             {person.position().x(), person.position().y()},
                             {person.velocity().x(), person.velocity().y()},
                             person.radius()});
  }
  return sample;
}

GoalNews to_goal_news(const bandwagon_msgs::msg::NavigationStatus& message) {
  namespace status_value = bandwagon_msgs::msg::NavigationStatus_Constants;
  GoalNews news;
  news.goal_id = message.goal_id();
  news.is_over = message.status() >= status_value::SUCCEEDED;
  news.is_claimed = message.status() == status_value::SUCCEEDED;
  news.others_follow = message.number_of_goals_remaining() > 0;
  news.reason = message.reason();
  news.goal = from_pose(message.goal().pose()).position();
  if (message.xy_tolerance() > 0.0) news.tolerance.xy = message.xy_tolerance();
  if (message.yaw_tolerance() > 0.0) news.tolerance.yaw = message.yaw_tolerance();
  return news;
}

bandwagon_msgs::msg::ScoreCard to_message(const ScoreCard& card, const PoseErrors& errors,
                                          const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::ScoreCard message;
  message.header(header);
  message.finished(card.finished);
  message.reached(card.reached);
  message.reason(card.reason);
  message.time_to_goal_s(card.time_to_goal);
  message.path_length_m(card.path_length);
  message.distance_to_goal_m(card.distance_to_goal);
  message.min_distance_m(card.min_distance);
  message.closest_person_m(card.closest ? card.closest->gap : std::numeric_limits<double>::infinity());
  message.collisions(static_cast<std::uint32_t>(card.collisions));
  message.collisions_at_speed(static_cast<std::uint32_t>(card.collisions_at_speed));
  message.max_collision_index(card.max_collision_index);
  message.max_collision_index_045(card.max_collision_index_045);
  message.share_ci_above_0_54(card.share_ci_above_0_54);
  message.share_ci_above_0_14(card.share_ci_above_0_14);
  message.mean_speed_mps(card.mean_speed);
  message.rms_jerk_mps3(card.rms_jerk);
  message.localization_poses(static_cast<std::uint32_t>(errors.count()));
  message.localization_mean_m(errors.mean_position());
  message.localization_rms_m(errors.rms_position());
  message.localization_max_m(errors.max_position());
  message.localization_rms_rad(errors.rms_heading());
  return message;
}

}  // namespace bw
