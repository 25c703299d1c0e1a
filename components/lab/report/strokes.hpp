// Many points as the few that are seen: in pieces, within what is shown, in round numbers.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/report/chart.hpp"

namespace bw::report {

/// How finely a chart is drawn: what it shows, a grid of some hundred steps across it, and numbers as round
/// as that allows.
class Canvas {
 public:
  explicit Canvas(const Chart& chart);

  /// [[x, y, x, y, ...], ...]: a list for each piece of the line.
  [[nodiscard]] nlohmann::ordered_json strokes(const Series& series) const;
  /// [x, y, x, y, ...]
  [[nodiscard]] nlohmann::ordered_json flat(const std::vector<Vector2>& points) const;
  /// Of the x axis (0) or y axis (1), rounded.
  [[nodiscard]] double rounded(double value, int axis) const;

 private:
  [[nodiscard]] Vector2 to_steps(const Vector2& point) const;
  [[nodiscard]] Vector2 from_steps(const Vector2& steps) const;
  [[nodiscard]] bool is_seen(const Vector2& steps) const;

  Eigen::AlignedBox2d shown_;  ///< of a logarithmic axis the exponents
  bool logarithmic_[2];
};

}  // namespace bw::report
