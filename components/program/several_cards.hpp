// One score card for a run of several robots.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/score_card.hpp>

namespace bw {

/// By robot; none before its drive began.
using RobotCard = std::pair<std::string, std::optional<bandwagon_msgs::msg::ScoreCard>>;

/// Of one robot its own. Of several the worst of each figure, contacts of all: reached when all have reached,
/// finished when all have finished. None before the first card.
std::optional<bandwagon_msgs::msg::ScoreCard> card_of_all(const std::vector<RobotCard>& cards);

}  // namespace bw
