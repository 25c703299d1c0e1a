// Truth, map and score card as messages. Pure conversions.
#pragma once

#include <optional>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/score_card.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/evaluation/drive_judge.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

TruthSample to_truth(const bandwagon_msgs::msg::GroundTruth& message);
/// With the usual tolerances where the navigator does not say within what it calls its goal reached.
GoalNews to_goal_news(const bandwagon_msgs::msg::NavigationStatus& message);
/// Nothing when sizes and cells disagree or the resolution is no length.
std::optional<OccupancyGrid> to_grid(const nav_msgs::msg::OccupancyGrid& message);
bandwagon_msgs::msg::ScoreCard to_message(const ScoreCard& card, const PoseErrors& errors,
                                          const std_msgs::msg::Header& header);

}  // namespace bw
