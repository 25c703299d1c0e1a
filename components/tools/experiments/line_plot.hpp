// Curves over time as an SVG picture, for the pages of `bandwagon reproduce`.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct PlotCurve {
  std::string label;
  std::string color;            ///< as CSS
  std::vector<Vector2> points;  ///< (time [s], value)
};

struct LinePlot {
  std::string title;
  std::string y_label;
  double y_max = 1.0;  ///< values from 0 to here; time from 0 to the last point of any curve
  std::vector<PlotCurve> curves;
};

/// A whole <svg> element, 460 x 240 pixels.
std::string to_svg(const LinePlot& plot);

}  // namespace bw
