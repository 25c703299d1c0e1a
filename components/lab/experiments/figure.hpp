// A figure of a page: caption, one legend for all its pictures, and the pictures, beside one another where there is
// room.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/plot_style.hpp"

namespace bw {

enum class LegendSymbol { line, dots, body, published, measured, area };

struct LegendEntry {
  std::string label;
  PlotStyle style;
  LegendSymbol symbol = LegendSymbol::line;
};

struct Figure {
  std::string title;    ///< "Figure 2.2: trajectories"
  std::string caption;  ///< HTML: what is shown, and what differs from the source
  std::vector<LegendEntry> legend = {};
  std::vector<std::string> pictures = {};  ///< <svg> elements
  int columns = 3;                         ///< at most, where there is room: 1 to 3
};

/// A whole <figure> element; its looks are those of page_parts.hpp.
std::string to_html(const Figure& figure);

}  // namespace bw
