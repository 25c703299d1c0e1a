// Lines over an axis, or paths on a floor: what a picture of a report holds. Beside lines it may hold bodies,
// marks, areas and limits.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "components/lab/report/look.hpp"
#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::report {

/// Without ends the page takes those of what is shown.
struct Axis {
  std::string label = {};  ///< with its unit: "time [s]"; empty: the axis has no measure
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  bool logarithmic = false;  ///< values below `low` are drawn there
};

// The legend of a figure names each `name` once, whatever holds it; an empty one is not in it.

struct Series {
  std::string name = {};
  Look look = {};
  std::vector<Vector2> points = {};  ///< a point that is not finite interrupts the line
  bool dots = false;                 ///< points instead of a line
};

/// A part of the x axis that is shaded.
struct Span {
  double from = 0.0;
  double to = 0.0;
  std::string label = {};
};

/// A value of the y axis that the lines are compared with.
struct Limit {
  double value = 0.0;
  std::string label = {};
};

/// A body at one moment.
struct Body {
  Vector2 center{0.0, 0.0};
  double radius = 0.3;  ///< [m]
  Color color = Color::grey;
  std::string label = {};   ///< short, within it
  Vector2 arrow{0.0, 0.0};  ///< from the centre [m]; zero: none
  std::string name = {};
};

enum class Symbol : std::uint8_t { dot, ring, square, triangle, cross };

NLOHMANN_JSON_SERIALIZE_ENUM(Symbol, {{Symbol::dot, "dot"},
                                      {Symbol::ring, "ring"},
                                      {Symbol::square, "square"},
                                      {Symbol::triangle, "triangle"},
                                      {Symbol::cross, "cross"}})

/// A place of a size on the screen.
struct Mark {
  Vector2 at{0.0, 0.0};
  Symbol symbol = Symbol::dot;
  Color color = Color::ink;
  std::string label = {};  ///< beside it
  std::string name = {};
};

/// An outline that is closed.
struct Area {
  std::vector<Vector2> outline = {};
  Color color = Color::grey;
  Dash dash = Dash::none;
  bool is_shade = false;  ///< filled, without a line
  std::string name = {};
};

struct Chart {
  std::string title;
  Axis x = {};
  Axis y = {};
  bool is_floor = false;  ///< both axes in the same metres; what would be very flat or steep is widened
  double height = 0.0;    ///< of what the axes enclose [px]; 0: as high as most are
  std::vector<Series> series = {};
  std::vector<Span> spans = {};
  std::vector<Limit> limits = {};
  std::vector<Body> bodies = {};
  std::vector<Mark> marks = {};
  std::vector<Area> areas = {};
  std::vector<Segment> walls = {};
  std::vector<Eigen::AlignedBox2d> blocks = {};  ///< of a map: what is occupied

  /// Only this part is shown.
  void show(const Eigen::AlignedBox2d& view);
};

/// A floor in metres.
Chart floor_plan(std::string title);

/// Lines lose points that nobody sees, and what is out of sight. What is not told has its default.
nlohmann::ordered_json to_json(const Chart& chart);

}  // namespace bw::report
