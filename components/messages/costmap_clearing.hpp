// The services by which Nav2's behaviour tree and rviz clear a costmap. For adaptors only.
#pragma once

#include <functional>
#include <string>

#include "runtime/component.hpp"

namespace bw {

/// What the clear services of a costmap do. Edges are of an axis-aligned square with the robot in its middle
/// [m], finite and not negative.
struct CostmapClearing {
  std::function<void()> entirely;
  std::function<void(double edge)> inside;
  std::function<void(double edge)> outside;
};

/// Offers FOLDERclear_entirely_NAME, clear_around_NAME and clear_except_NAME in the layout of the graph's ROS
/// 2; FOLDER is empty for a node in the costmap's own namespace, as Nav2's is, else NAME/. Up to Kilted their
/// responses are empty: what they do not do is told in the log.
void offer_clear_services(Setup& setup, const std::string& folder, const std::string& name,
                          const CostmapClearing& clearing);

}  // namespace bw
