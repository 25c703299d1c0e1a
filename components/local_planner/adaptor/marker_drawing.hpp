// The markers of one message: numbered in the order they come, and only those that can be drawn.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/markers.hpp"

namespace bw {

class MarkerDrawing {
 public:
  /// Begins with a DELETEALL.
  explicit MarkerDrawing(std_msgs::msg::Header header);

  /// `size` [m]: width of lines, diameter of dots, height of text.
  visualization_msgs::msg::Marker make(const std::string& ns, std::int32_t type, double size,
                                       const Color& color);
  /// Leaves out what is not finite: one such number and rviz2 refuses the whole array.
  void add(visualization_msgs::msg::Marker marker);
  visualization_msgs::msg::MarkerArray take() { return std::move(array_); }

 private:
  std_msgs::msg::Header header_;
  visualization_msgs::msg::MarkerArray array_;
  int id_ = 0;
};

}  // namespace bw
