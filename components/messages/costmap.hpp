// Costs as nav2_msgs/Costmap, and the services by which Nav2's behaviour tree and rviz clear a costmap. For adaptors only.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nav2_msgs/msg/costmap.hpp>
#include <nav2_msgs/srv/clear_costmap_around_robot.hpp>
#include <nav2_msgs/srv/clear_costmap_except_region.hpp>
#include <nav2_msgs/srv/clear_entire_costmap.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/component.hpp"

namespace bw {

/// `costs` are those of the cells of `grid`, by cell_cost.hpp.
inline nav2_msgs::msg::Costmap to_costmap(const OccupancyGrid& grid, const std::vector<std::uint8_t>& costs,
                                          const std::string& frame, Time stamp) {
  nav2_msgs::msg::Costmap message;
  message.header(make_header(frame, stamp));
  message.metadata().map_load_time(to_stamp(stamp));
  message.metadata().update_time(to_stamp(stamp));
  message.metadata().layer("master");
  message.metadata().resolution(static_cast<float>(grid.resolution));
  message.metadata().size_x(static_cast<std::uint32_t>(grid.width));
  message.metadata().size_y(static_cast<std::uint32_t>(grid.height));
  message.metadata().origin(to_pose({grid.origin.x(), grid.origin.y(), 0.0}));
  message.data().assign(costs.begin(), costs.end());
  return message;
}

/// What the clear services of a costmap do. Edges are of an axis-aligned square with the robot in its middle [m], finite
/// and not negative.
struct CostmapClearing {
  std::function<void()> entirely;
  std::function<void(double edge)> inside;
  std::function<void(double edge)> outside;
};

/// Offers NAME/clear_entirely_NAME, clear_around_NAME and clear_except_NAME. Their responses are empty: what they do not
/// do is told in the log.
inline void offer_clear_services(Setup& setup, const std::string& name, CostmapClearing clearing) {
  using nav2_msgs::srv::ClearCostmapAroundRobot;
  using nav2_msgs::srv::ClearCostmapExceptRegion;
  using nav2_msgs::srv::ClearEntireCostmap;
  setup.service<ClearEntireCostmap>(
      name + "/clear_entirely_" + name,
      [entirely = std::move(clearing.entirely)](const auto&, const Tick&) {
        entirely();
        return ClearEntireCostmap::Response();
      },
      [](const std::string&) { return ClearEntireCostmap::Response(); });
  const auto offer = [&]<class S>(std::type_identity<S>, const std::string& service,
                                  std::function<void(double)> clear) {
    setup.service<S>(
        service,
        [service, clear = std::move(clear), log = setup.log()](const typename S::Request& request,
                                                               const Tick&) {
          const auto edge = static_cast<double>(request.reset_distance());
          if (std::isfinite(edge) && edge >= 0.0) {
            clear(edge);
          } else {
            log.error("{}: a reset_distance of {} is none: nothing is cleared", service, edge);
          }
          return typename S::Response();
        },
        [](const std::string&) { return typename S::Response(); });
  };
  offer(std::type_identity<ClearCostmapAroundRobot>{}, name + "/clear_around_" + name,
        std::move(clearing.inside));
  offer(std::type_identity<ClearCostmapExceptRegion>{}, name + "/clear_except_" + name,
        std::move(clearing.outside));
}

}  // namespace bw
