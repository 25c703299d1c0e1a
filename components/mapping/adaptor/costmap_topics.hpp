// The costs around the robot on topics: one for people to look at, and with Nav2's names those that its
// behaviour server reads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <nav2_msgs/msg/costmap.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/mapping/costmap/inflation.hpp"
#include "components/messages/costmap.hpp"
#include "components/messages/footprint.hpp"
#include "components/messages/grid.hpp"
#include "runtime/component.hpp"

namespace bw::costmap {

class CostmapTopics {
 public:
  void offer(Setup& setup, bool nav2_names) {
    if (!nav2_names) {
      shown_ = setup.output<nav_msgs::msg::OccupancyGrid>("local_costmap");
      return;
    }
    shown_ = setup.output<nav_msgs::msg::OccupancyGrid>("costmap", Qos::latched());
    raw_ = setup.output<nav2_msgs::msg::Costmap>("costmap_raw", Qos::latched());
    footprint_ = setup.output<geometry_msgs::msg::PolygonStamped>("published_footprint");
  }
  bool has_readers() const {
    return shown_.has_readers() || (raw_ && (raw_->has_readers() || footprint_->has_readers()));
  }
  /// `costs` are those of `cells`, X_OB is the robot in their frame.
  void publish(OccupancyGrid cells, const std::vector<std::uint8_t>& costs, const Pose2& X_OB,
               const Footprint& footprint, const std_msgs::msg::Header& header) const {
    const Time stamp = from_stamp(header.stamp());
    if (raw_) {
      raw_->publish(to_costmap(cells, costs, header.frame_id(), stamp));
      footprint_->publish(to_published_footprint(X_OB, footprint, header));
    }
    for (std::size_t i = 0; i < costs.size(); ++i) cells.cells[i] = occupancy_of(costs[i]);
    shown_.publish(to_message(cells, header.frame_id(), stamp));
  }

 private:
  Output<nav_msgs::msg::OccupancyGrid> shown_;
  std::optional<Output<nav2_msgs::msg::Costmap>> raw_;
  std::optional<Output<geometry_msgs::msg::PolygonStamped>> footprint_;
};

}  // namespace bw::costmap
