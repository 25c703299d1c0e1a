// Truth, map and score card as messages. Pure conversions.
#pragma once

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/score_card.hpp>

#include "components/evaluation/drive_judge.hpp"

namespace bw {

TruthSample to_truth(const bandwagon_msgs::msg::GroundTruth& message);
/// With the usual tolerances where the navigator does not say within what it calls its goal reached.
GoalNews to_goal_news(const bandwagon_msgs::msg::NavigationStatus& message);
bandwagon_msgs::msg::ScoreCard to_message(const ScoreCard& card, const PoseErrors& errors,
                                          const std_msgs::msg::Header& header);

}  // namespace bw
