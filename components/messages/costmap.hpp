// Costs as nav2_msgs/Costmap, and the services by which Nav2's behaviour tree and rviz clear a costmap. For adaptors only.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nav2_msgs/msg/costmap.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
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

/// Offers one of the two services that name an edge.
template <class S>
void offer_clearing_by_edge(Setup& setup, const std::string& service, std::function<void(double)> clear) {
  const auto answer = [](bool is_done) {
    typename S::Response response;
    set_success(response, is_done);
    return response;
  };
  setup.service<S>(
      service,
      [=, log = setup.log()](const typename S::Request& request, const Tick&) {
        const auto edge = static_cast<double>(request.reset_distance());
        const bool is_edge = std::isfinite(edge) && edge >= 0.0;
        if (is_edge) {
          clear(edge);
        } else {
          log.error("{}: a reset_distance of {} is none: nothing is cleared", service, edge);
        }
        return answer(is_edge);
      },
      [answer](const std::string&) { return answer(false); });
}

/// Offers FOLDERclear_entirely_NAME, clear_around_NAME and clear_except_NAME in the layout of the graph's ROS 2; FOLDER is
/// empty for a node in the costmap's own namespace, as Nav2's is, else NAME/. Up to Kilted their responses are empty: what
/// they do not do is told in the log.
inline void offer_clear_services(Setup& setup, const std::string& folder, const std::string& name,
                                 const CostmapClearing& clearing) {
  with_nav2_layout(setup.ros_distro(), [&]<class Nav2>(Nav2) {
    using Entirely = typename Nav2::ClearEntireCostmap;
    const auto answer = [](bool is_done) {
      typename Entirely::Response response;
      set_success(response, is_done);
      return response;
    };
    setup.service<Entirely>(
        folder + "clear_entirely_" + name,
        [answer, entirely = clearing.entirely](const auto&, const Tick&) {
          entirely();
          return answer(true);
        },
        [answer](const std::string&) { return answer(false); });
    offer_clearing_by_edge<typename Nav2::ClearCostmapAroundRobot>(setup, folder + "clear_around_" + name,
                                                                   clearing.inside);
    offer_clearing_by_edge<typename Nav2::ClearCostmapExceptRegion>(setup, folder + "clear_except_" + name,
                                                                    clearing.outside);
  });
}

}  // namespace bw
