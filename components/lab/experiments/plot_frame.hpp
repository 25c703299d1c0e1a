// The axes of a plot: where a value lands on the picture, and grid, ticks and labels about it.
#pragma once

#include <string>
#include <vector>

#include "components/evaluation/svg_writer.hpp"

namespace bw {

struct PlotAxis {
  std::string label;  ///< with its unit: "time [s]"
  double low = 0.0;
  double high = 1.0;         ///< above `low`
  bool logarithmic = false;  ///< `low` above 0; values below it are drawn there
};

/// Pictures are this wide [px]: what a phone shows without making them smaller.
inline constexpr double kPlotWidth = 360.0;

class PlotFrame {
 public:
  /// The area of the axes is `height` high [px], below room for a title.
  PlotFrame(PlotAxis x, PlotAxis y, double height);

  /// On the picture [px].
  [[nodiscard]] Vector2 at(double x, double y) const;
  [[nodiscard]] std::vector<Vector2> at(const std::vector<Vector2>& points) const;
  [[nodiscard]] double left() const;
  [[nodiscard]] double right() const;
  [[nodiscard]] double top() const;
  [[nodiscard]] double bottom() const { return top() + height_; }
  /// Of the whole picture [px].
  [[nodiscard]] double picture_height() const;

  void draw_title(SvgWriter& svg, const std::string& title) const;
  /// Grid lines, ticks at round numbers and the label of one axis.
  void draw_x(SvgWriter& svg) const;
  void draw_y(SvgWriter& svg) const;
  /// What is drawn between the two shows only within the axes.
  void open_area(SvgWriter& svg) const;
  void close_area(SvgWriter& svg) const;

 private:
  PlotAxis x_, y_;
  double height_;
};

}  // namespace bw
