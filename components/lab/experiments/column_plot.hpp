// Figures side by side, each in a column of its own: every run, mean with spread, and what was published. For the
// pages of `bandwagon reproduce`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/lab/experiments/line_plot.hpp"

namespace bw {

struct ColumnSpread {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct PlotColumn {
  std::string label;
  std::string_view color = kBlue;
  std::vector<double> runs = {};  ///< a small dot each
  std::optional<ColumnSpread> measured = std::nullopt;
  std::optional<double> published = std::nullopt;
};

struct ColumnPlot {
  std::string title;
  PlotAxis y;
  std::vector<PlotColumn> columns;
  std::vector<PlotLimit> limits = {};
  double height = 170.0;  ///< of the axes [px]
};

/// A whole <svg> element, kPlotWidth wide. What is beyond the axis is drawn at its end.
std::string to_svg(const ColumnPlot& plot);

}  // namespace bw
