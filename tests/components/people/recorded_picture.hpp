// Tracks of a recorded log as one picture: the ways in each labelled stretch, the distance from the laser and
// the life of every track over time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "components/evaluation/svg_writer.hpp"

namespace bw::people::test {

struct Sighting {
  double time;  ///< [s]
  Vector2 place;
};

/// By id; never empty.
using RecordedTracks = std::map<std::uint32_t, std::vector<Sighting>>;

/// What the picture shows of a labelled stretch.
struct PicturedStretch {
  std::string title;
  std::string score;
  std::vector<Sighting> labels;  ///< people who count, by time
  std::vector<Sighting> misses;  ///< those of them without a track
};

/// Multiples of `step` from `low` to `high`; none for a step of 0.
inline std::vector<double> ticks(double low, double high, double step) {
  std::vector<double> multiples;
  if (step <= 0.0) return multiples;
  const auto last = std::lround(std::floor(high / step));
  for (auto i = std::lround(std::ceil(low / step)); i <= last; ++i)
    multiples.push_back(static_cast<double>(i) * step);
  return multiples;
}

/// A frame with ticks; `left` may be greater than `right`.
struct Axes {
  Vector2 corner;
  double width, height;
  double left, right, bottom, top;

  Vector2 at(double h, double v) const {
    return corner + Vector2(width * (h - left) / (right - left), height * (top - v) / (top - bottom));
  }

  void draw(SvgWriter& svg, double step_h, double step_v, const std::string& name_h,
            const std::string& name_v) const {
    for (const double h : ticks(std::min(left, right), std::max(left, right), step_h)) {
      svg.line(at(h, bottom), at(h, top), R"(stroke="#e4e4e4")");
      svg.text(at(h, bottom) + Vector2(0, 16), fixed(h, 0), R"(font-size="12" text-anchor="middle")");
    }
    for (const double v : ticks(bottom, top, step_v)) {
      svg.line(at(left, v), at(right, v), R"(stroke="#e4e4e4")");
      svg.text(at(left, v) + Vector2(-6, 4), fixed(v, 0), R"(font-size="12" text-anchor="end")");
    }
    svg.rectangle(corner, width, height, R"(fill="none" stroke="#444")");
    svg.text(corner + Vector2(width / 2, height + 33), name_h, R"(font-size="13" text-anchor="middle")");
    svg.text(corner + Vector2(0, -6), name_v, R"(font-size="13")");
  }
};

inline std::string track_color(std::uint32_t id) {
  static constexpr std::array<const char*, 9> kColors{"#0072b2", "#d55e00", "#009e73", "#cc3fa0", "#8a6d00",
                                                      "#56b4e9", "#6a3d9a", "#444444", "#b00020"};
  return kColors[(id - 1) % kColors.size()];
}

/// Part of a track between two times, as lines; interrupted where it was not reported for 0.25 s.
template <class Place>
void draw_track(SvgWriter& svg, const std::vector<Sighting>& track, double from, double to,
                const std::string& color, const Place& place) {
  const std::string style = "stroke-width=\"1.6\" stroke-opacity=\"0.85\" stroke=\"" + color + '"';
  std::vector<Vector2> line;
  double last = 0.0;
  for (const Sighting& sighting : track) {
    if (sighting.time < from || sighting.time > to) continue;
    if (!line.empty() && sighting.time - last > 0.25) svg.polyline(std::exchange(line, {}), style);
    last = sighting.time;
    line.push_back(place(sighting));
  }
  if (!line.empty()) svg.polyline(line, style);
}

inline void draw_cross(SvgWriter& svg, const Vector2& p) {
  svg.line(p - Vector2(3, 3), p + Vector2(3, 3), R"(stroke="#000")");
  svg.line(p - Vector2(3, -3), p + Vector2(3, -3), R"(stroke="#000")");
}

inline void draw_ring(SvgWriter& svg, const Vector2& p) {
  svg.circle(p, 7, R"(fill="none" stroke="#e00000" stroke-width="1.5")");
}

/// The ways of one stretch, seen from above, the laser looking up.
inline void draw_ways(SvgWriter& svg, const Vector2& corner, const RecordedTracks& tracks,
                      const PicturedStretch& stretch) {
  const Axes axes{corner, 420, 420, 3.5, -3.5, 0, 7};
  svg.text(corner + Vector2(0, -44), stretch.title, R"(font-size="15" font-weight="bold")");
  svg.text(corner + Vector2(0, -26), stretch.score, R"(font-size="13")");
  axes.draw(svg, 1, 1, "to the left of the laser [m]", "ahead [m]");
  svg.circle(axes.at(0, 0), 6, R"(fill="#000")");
  const auto place = [&](const Sighting& s) { return axes.at(s.place.y(), s.place.x()); };
  for (const auto& [id, track] : tracks)
    draw_track(svg, track, stretch.labels.front().time, stretch.labels.back().time, track_color(id), place);
  for (const Sighting& label : stretch.labels) draw_cross(svg, place(label));
  for (const Sighting& miss : stretch.misses) draw_ring(svg, place(miss));
}

inline void shade(SvgWriter& svg, const Axes& axes, const std::vector<PicturedStretch>& stretches) {
  for (const PicturedStretch& stretch : stretches) {
    const Vector2 corner = axes.at(stretch.labels.front().time, axes.top);
    const double width = axes.at(stretch.labels.back().time, axes.top).x() - corner.x();
    svg.rectangle(corner, width, axes.height, R"(fill="#fff3cc")");
  }
}

inline std::string recorded_picture(const RecordedTracks& tracks, double duration,
                                    const std::vector<PicturedStretch>& stretches) {
  constexpr double kRow = 20.0;
  const double life_height = kRow * static_cast<double>(tracks.size());
  const double height = 970.0 + life_height;
  SvgWriter svg(1500, height);
  svg.rectangle({0, 0}, 1500, height, R"(fill="#fff")");
  draw_cross(svg, {60, 24});
  svg.text({72, 29}, "labelled person, every 0.5 s", R"(font-size="14")");
  draw_ring(svg, {280, 24});
  svg.text({294, 29}, "missed: no track within 0.75 m", R"(font-size="14")");
  svg.rectangle({520, 14}, 24, 20, R"(fill="#fff3cc")");
  svg.text({552, 29}, "labelled stretch", R"(font-size="14")");
  svg.text({690, 29}, "lines: tracks, coloured as in the lowest diagram", R"(font-size="14")");
  for (std::size_t i = 0; i < stretches.size(); ++i)
    draw_ways(svg, {60.0 + 480.0 * static_cast<double>(i), 110}, tracks, stretches[i]);

  const Axes distance{{60, 620}, 1400, 240, 0, duration, 0, 7};
  shade(svg, distance, stretches);
  distance.draw(svg, 10, 1, "time [s]", "distance from the laser [m]");
  const auto place = [&](const Sighting& s) { return distance.at(s.time, s.place.norm()); };
  for (const auto& [id, track] : tracks) draw_track(svg, track, 0, duration, track_color(id), place);
  for (const PicturedStretch& stretch : stretches)
    for (const Sighting& miss : stretch.misses) draw_ring(svg, place(miss));

  const Axes life{{60, 920}, 1400, life_height, 0, duration, 0, static_cast<double>(tracks.size())};
  shade(svg, life, stretches);
  life.draw(svg, 10, 0, "time [s]", "tracks by number, from first to last report");
  double row = static_cast<double>(tracks.size()) - 0.5;
  for (const auto& [id, track] : tracks) {
    svg.text(life.at(0, row) + Vector2(-6, 4), std::to_string(id), R"(font-size="12" text-anchor="end")");
    const Vector2 begin = life.at(track.front().time, row);
    const Vector2 end = life.at(track.back().time, row);
    svg.rectangle(begin - Vector2(0, 5), std::max(end.x() - begin.x(), 2.0), 10,
                  "fill=\"" + track_color(id) + '"');
    const std::string length = fixed(track.back().time - track.front().time, 1) + " s";
    const bool room = end.x() < 1400;
    svg.text(room ? end + Vector2(6, 4) : begin + Vector2(-6, 4), length,
             room ? R"(font-size="12")" : R"(font-size="12" text-anchor="end")");
    row -= 1.0;
  }
  return std::move(svg).finish();
}

}  // namespace bw::people::test
