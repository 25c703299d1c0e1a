// A frame with ticks for a diagram, and where in it a point is.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "components/evaluation/svg_writer.hpp"

namespace bw {

/// Empty until it holds a value.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void hold(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
};

struct DiagramAxes {
  Vector2 corner;        ///< left and top [px]
  double width, height;  ///< [px]
  Range h, v;            ///< shown, to the right and upwards

  Vector2 at(double x, double y) const {
    return corner + Vector2(width * (x - h.low) / h.length(), height * (v.high - y) / v.length());
  }
  /// The names tell the units. Without ticks upwards where rows have no measure.
  void draw(SvgWriter& svg, const std::string& name_h, const std::string& name_v,
            bool has_ticks_v = true) const;
};

}  // namespace bw
