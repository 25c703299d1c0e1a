// Figures side by side, each in a column of its own: every run, mean with spread, and what was published.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/lab/report/chart.hpp"

namespace bw::report {

/// A figure and where most of its values lie.
struct Interval {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct Column {
  std::string label;
  Color color = Color::blue;
  std::vector<double> runs = {};  ///< a dot each
  std::optional<Interval> measured = std::nullopt;
  std::optional<double> published = std::nullopt;
};

/// What is beyond the axis is drawn at its end.
struct Columns {
  std::string title;
  Axis y = {};
  std::string measured = {};  ///< what the intervals are, for the legend
  std::string runs = {};      ///< what the dots are, likewise
  std::vector<Column> columns = {};
  std::vector<Limit> limits = {};
};

nlohmann::ordered_json to_json(const Columns& columns);

}  // namespace bw::report
