// Ways on a floor as an SVG picture with equal axes in metres, for the pages of `bandwagon reproduce`.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "components/lab/experiments/plot_style.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct PlotWay {
  PlotStyle style;
  std::vector<Vector2> points;  ///< [m]
  bool dots = false;            ///< points instead of a line
};

/// A body at one moment.
struct PlotDisc {
  Vector2 center{0.0, 0.0};
  double radius = 0.3;  ///< [m]
  std::string_view color = kGrey;
  std::string label = {};   ///< short, within it
  Vector2 arrow{0.0, 0.0};  ///< from the centre [m]; zero: none
};

struct PathPlot {
  std::string title;
  std::vector<PlotWay> ways = {};
  std::vector<PlotDisc> discs = {};
  std::vector<Segment> walls = {};
  std::vector<std::vector<Vector2>> areas = {};  ///< outlines of floor that is shaded
  const OccupancyGrid* map = nullptr;            ///< its occupied cells, when there is one
  Eigen::AlignedBox2d view = {};                 ///< [m]; empty: all ways and discs
};

/// What is shown: `view` or all there is with some room, made higher or wider where it is very flat or steep.
Eigen::AlignedBox2d shown_by(const PathPlot& plot);

/// A whole <svg> element, kPlotWidth wide, as high as the view asks for. Lines lose points that are not seen.
std::string to_svg(const PathPlot& plot);

}  // namespace bw
