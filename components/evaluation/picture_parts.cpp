#include "components/evaluation/picture_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "components/model/footprint_outline.hpp"
#include "components/model/footprint_touch.hpp"

namespace bw::drawing {
namespace {

using Color = std::array<double, 3>;
constexpr std::array<Color, 3> kSpeedColors = {{{214, 48, 49}, {240, 173, 46}, {15, 134, 140}}};

/// The longest of 1, 2, 5 times a power of ten that fits into `room` [m].
double round_length(double room) {
  const double power = std::pow(10.0, std::floor(std::log10(room)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= room) return factor * power;
  }
  return power;
}

}  // namespace

std::string style(std::initializer_list<std::pair<std::string_view, std::string>> attributes) {
  std::string text;
  for (const auto& [name, value] : attributes) text += std::string(name) + "=\"" + value + "\" ";
  return text;
}

std::string fill(std::string_view color) { return style({{"fill", std::string(color)}}); }

std::string label_style(std::string_view color, int size, std::string_view anchor, int weight) {
  return style({{"fill", std::string(color)},
                {"font-size", std::to_string(size)},
                {"text-anchor", std::string(anchor)},
                {"font-weight", std::to_string(weight)}});
}

std::string speed_color(double share) {
  const double level = std::clamp(share, 0.0, 1.0) * (kSpeedColors.size() - 1);
  const std::size_t low = std::min<std::size_t>(static_cast<std::size_t>(level), kSpeedColors.size() - 2);
  const double t = level - static_cast<double>(low);
  std::string text = "rgb(";
  for (std::size_t i = 0; i < 3; ++i) {
    text += fixed(kSpeedColors[low][i] * (1.0 - t) + kSpeedColors[low + 1][i] * t, 0) + (i < 2 ? "," : ")");
  }
  return text;
}

void draw_surroundings(SvgWriter& svg, const RunRecording& recording, const PictureView& view) {
  svg.rectangle(view.corner, view.width(), view.height(), fill(recording.map ? "#e4e8ed" : "#fbfcfd"));
  if (recording.map) {
    svg.path(cells_path(*recording.map, view, 0, 64),
             "fill=\"#fbfcfd\" stroke=\"#fbfcfd\" stroke-width=\"0.6\"");
    svg.path(cells_path(*recording.map, view, 65, 100),
             "fill=\"#34414f\" stroke=\"#34414f\" stroke-width=\"0.6\"");
  }
  for (const Segment& wall : recording.shapes.segments) {
    svg.line(view(wall.a), view(wall.b), "stroke=\"#34414f\" stroke-width=\"4\" stroke-linecap=\"round\"");
  }
  for (const Disc& disc : recording.shapes.discs) {
    svg.circle(view(disc.center), disc.radius * view.scale, "fill=\"#34414f\"");
  }
}

void draw_footprint(SvgWriter& svg, const PictureView& view, const Footprint& robot, const Pose2& X_MB,
                    const std::string& look) {
  if (!robot.is_polygon() || !std::isfinite(X_MB.theta))  // else the truth has no heading
    return svg.circle(view(X_MB.position()), robot.radius * view.scale, look);
  std::string data;
  for (const Vector2& corner : outline(robot, X_MB, 0)) {
    const Vector2 at = view(corner);
    data += (data.empty() ? "M" : "L") + fixed(at.x(), 1) + " " + fixed(at.y(), 1);
  }
  svg.path(data + "Z", look);
}

double front_of(const Footprint& robot) {
  if (!robot.is_polygon()) return robot.radius;
  return -first_touch({1.0, 0.0}, robot.polygon, {2.0 * robot.radius, 0.0}).distance + 2.0 * robot.radius;
}

void draw_scale_bar(SvgWriter& svg, const PictureView& view, const Vector2& left) {
  const double length = round_length(180.0 / view.scale);
  const double pixels = length * view.scale;
  const std::string ink = style({{"stroke", std::string(kInk)}, {"stroke-width", "2"}});
  svg.line(left, left + Vector2(pixels, 0), ink);
  svg.line(left - Vector2(0, 5), left + Vector2(0, 5), ink);
  svg.line(left + Vector2(pixels, -5), left + Vector2(pixels, 5), ink);
  svg.text(left + Vector2(pixels / 2, 20), fixed(length, length < 1.0 ? 1 : 0) + " m",
           label_style(kSoftInk, 13, "middle"));
}

}  // namespace bw::drawing
