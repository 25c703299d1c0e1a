// Curves over an axis as an SVG picture, for the pages of `bandwagon reproduce`.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/plot_frame.hpp"
#include "components/lab/experiments/plot_style.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct PlotCurve {
  PlotStyle style;
  std::vector<Vector2> points;  ///< in the units of the axes, rising in x
};

/// A part of the x axis that is shaded.
struct PlotSpan {
  double from = 0.0;
  double to = 0.0;
  std::string label;
};

/// A value that the curves are compared with: a dashed line with its name.
struct PlotLimit {
  double value = 0.0;
  std::string label;
};

struct LinePlot {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSpan> spans = {};
  std::vector<PlotLimit> limits = {};
  std::vector<PlotCurve> curves = {};
  double height = 170.0;  ///< of the axes [px]
};

/// A whole <svg> element, kPlotWidth wide. Curves lose points that are not seen at this size.
std::string to_svg(const LinePlot& plot);

/// A limit across the axes of `frame`, for every kind of plot.
void draw_limit(SvgWriter& svg, const PlotFrame& frame, const PlotLimit& limit);

}  // namespace bw
