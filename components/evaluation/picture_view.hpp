// Which part of the map the picture shows, and where a position in it lands on the page.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "components/evaluation/run_recorder.hpp"

namespace bw {

struct PictureView {
  Eigen::AlignedBox2d window_in_map;  ///< [m]
  double scale = 50.0;                ///< [px/m]
  Vector2 corner{0.0, 0.0};           ///< upper left corner on the page [px]

  double width() const { return window_in_map.sizes().x() * scale; }
  double height() const { return window_in_map.sizes().y() * scale; }
  Vector2 operator()(const Vector2& p_M) const {
    return {corner.x() + (p_M.x() - window_in_map.min().x()) * scale,
            corner.y() + (window_in_map.max().y() - p_M.y()) * scale};
  }
};

/// The drive with room about it, cut at the border of the map, `width` pixels wide and at most as high as
/// wide.
PictureView view_of(const RunRecording& recording, double width, const Vector2& corner);

/// All cells of the window at or above `lowest` and at or below `highest`: rectangles, merged along rows and
/// columns.
std::vector<Eigen::AlignedBox2d> cell_blocks(const OccupancyGrid& grid, const Eigen::AlignedBox2d& window,
                                             int lowest, int highest);

/// Their outlines on the page (SVG path).
std::string cells_path(const OccupancyGrid& grid, const PictureView& view, int lowest, int highest);

}  // namespace bw
