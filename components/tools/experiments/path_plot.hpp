// Ways on a floor as an SVG picture with equal axes, for the pages of `bandwagon reproduce`.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct PlotWay {
  std::string label;
  std::string color;  ///< as CSS
  std::vector<Vector2> points;
  bool dots = false;  ///< points instead of a line
};

/// A whole <svg> element, 560 pixels wide, with a bar of a round length as scale.
std::string path_plot(const std::string& title, const std::vector<PlotWay>& ways);

}  // namespace bw
