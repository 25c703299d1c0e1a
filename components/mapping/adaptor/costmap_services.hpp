// The services of Nav2's local costmap, under the names that its node there gives them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nav2_msgs/msg/costmap.hpp>

#include "components/mapping/costmap/local_grid.hpp"
#include "runtime/component.hpp"

namespace bw::costmap {

/// What the services look at: members of the component.
struct CostmapAnswers {
  std::optional<LocalGrid>& grid;
  const Pose2& X_OB;  ///< of base_link
  std::function<nav2_msgs::msg::Costmap(Time now)> costs;
};

/// `folder` comes before each name: empty for a node in a namespace of its own.
void offer_services(Setup& setup, const std::string& folder, const CostmapAnswers& answers);

}  // namespace bw::costmap
