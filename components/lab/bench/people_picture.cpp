#include "components/lab/bench/people_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "components/evaluation/axis_ticks.hpp"
#include "components/evaluation/svg_writer.hpp"
#include "components/lab/bench/diagram_axes.hpp"
#include "components/lab/bench/people_report.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

using people::TrackError;

constexpr double kLeft = 70.0;     // of every diagram [px]
constexpr double kWidth = 1400.0;  // of those over time [px]
constexpr double kPanel = 420.0;   // height of a view from above [px]
constexpr double kRow = 18.0;      // of a track's life [px]
constexpr double kBetween = 65.0;  // views side by side [px]
constexpr double kPause = 0.3;     // a line is interrupted where a track is not reported for longer [s]
constexpr const char* kLegend = R"(font-size="14")";

struct Sighting {
  double time;
  Vector2 place;
  double distance;  ///< from the robot; NaN where its place is not known
  bool is_confirmed;
};
using Tracks = std::map<std::uint32_t, std::vector<Sighting>>;

Tracks tracks_of(const PeopleRun& run) {
  Tracks tracks;
  for (std::size_t i = 0; i < run.sweeps.size(); ++i) {
    const people::TrackedSweep& sweep = run.sweeps[i];
    for (const TrackedPerson& person : sweep.people) {
      const double distance =
          run.robot[i] ? (person.position - *run.robot[i]).norm() : std::numeric_limits<double>::quiet_NaN();
      tracks[person.id].push_back({sweep.time, person.position, distance, is_confirmed(person)});
    }
  }
  return tracks;
}

std::string color_of(std::uint32_t id) {
  static constexpr std::array<const char*, 9> kColors{"#0072b2", "#d55e00", "#009e73", "#cc3fa0", "#8a6d00",
                                                      "#56b4e9", "#6a3d9a", "#444444", "#b00020"};
  return kColors[id % kColors.size()];
}

void draw_cross(SvgWriter& svg, const Vector2& p) {
  svg.line(p - Vector2(3, 3), p + Vector2(3, 3), R"(stroke="#000")");
  svg.line(p - Vector2(3, -3), p + Vector2(3, -3), R"(stroke="#000")");
}

void draw_error(SvgWriter& svg, const Vector2& p, TrackError kind) {
  if (kind == TrackError::miss) svg.circle(p, 7, R"(fill="none" stroke="#e00000" stroke-width="1.5")");
  if (kind == TrackError::false_track)
    svg.rectangle(p - Vector2(6, 6), 12, 12, R"(fill="none" stroke="#e00000" stroke-width="1.5")");
  if (kind == TrackError::other_identity)
    svg.polyline({p + Vector2(0, -8), p + Vector2(8, 6), p + Vector2(-8, 6), p + Vector2(0, -8)},
                 R"(stroke="#e00000" stroke-width="1.5")");
}

/// Part of a track, thin and dashed while it is only possible.
template <class Place>
void draw_track(SvgWriter& svg, std::uint32_t id, const std::vector<Sighting>& track, const Range& times,
                const Place& place) {
  std::vector<Vector2> line;
  const Sighting* last = nullptr;
  const auto finish = [&] {
    const bool is_confirmed = last != nullptr && last->is_confirmed;
    const std::string style = is_confirmed
                                  ? R"(stroke-width="1.7" stroke-opacity="0.85")"
                                  : R"(stroke-width="1" stroke-opacity="0.6" stroke-dasharray="3 3")";
    if (line.size() > 1) svg.polyline(line, style + " stroke=\"" + color_of(id) + '"');
    line.clear();
  };
  for (const Sighting& sighting : track) {
    const Vector2 p = place(sighting);
    if (sighting.time < times.low || sighting.time > times.high || !p.allFinite()) continue;
    const bool goes_on = last != nullptr && sighting.time - last->time <= kPause;
    if (!goes_on) finish();
    line.push_back(p);
    if (goes_on && sighting.is_confirmed != last->is_confirmed) {
      finish();
      line.push_back(p);
    }
    last = &sighting;
  }
  finish();
}

/// What one view from above shows.
struct View {
  std::string title;
  std::string score;
  Range times;
  const LabelledStretch* stretch = nullptr;
};

Range times_of(const LabelledStretch& stretch) {
  return {stretch.labels.front().time, stretch.labels.back().time};
}

std::vector<View> views_of(const PeopleRun& run) {
  std::vector<View> views;
  for (const LabelledStretch& stretch : run.stretches) {
    if (stretch.labels.empty()) continue;
    const people::Score& s = stretch.score.clear_mot;
    const Range times = times_of(stretch);
    views.push_back({stretch.name + ", " + fixed(times.low, 1) + " to " + fixed(times.high, 1) + " s",
                     "MOTA " + fixed(s.mota(), 3) + ", MOTP " + fixed(s.motp(), 3) + " m, misses " +
                         std::to_string(s.people - s.matched) + " of " + std::to_string(s.people) +
                         ", false " + std::to_string(s.false_positives) + ", switches " +
                         std::to_string(s.switches),
                     times, &stretch});
  }
  if (views.empty()) views.push_back({run.bag, "no labels", {0.0, run.duration}, nullptr});
  return views;
}

/// What the view holds, as little as a frame around the robot.
std::pair<Range, Range> bounds_of(const PeopleRun& run, const Tracks& tracks, const View& view) {
  Range x;
  Range y;
  const auto hold = [&](const Vector2& p) {
    x.hold(p.x());
    y.hold(p.y());
  };
  const auto is_shown = [&](double time) { return time >= view.times.low && time <= view.times.high; };
  for (const auto& [id, track] : tracks) {
    for (const Sighting& s : track) {
      if (is_shown(s.time)) hold(s.place);
    }
  }
  for (std::size_t i = 0; i < run.sweeps.size(); ++i) {
    if (run.robot[i] && is_shown(run.sweeps[i].time)) hold(*run.robot[i]);
  }
  if (view.stretch != nullptr) {
    for (const auto& instant : view.stretch->labels) {
      for (const auto& person : instant.people) {
        if (person.counted) hold(person.position);
      }
    }
  }
  if (!(x.length() >= 0.0)) hold({0.0, 0.0});
  return {x, y};
}

/// Equal steps along both axes, everything in.
DiagramAxes axes_of(const PeopleRun& run, const Tracks& tracks, const View& view, const Vector2& corner,
                    double width) {
  const auto [x, y] = bounds_of(run, tracks, view);
  const double px_per_m =
      std::min(width / std::max(x.length() + 0.6, 1.0), kPanel / std::max(y.length() + 0.6, 1.0));
  const double half_x = 0.5 * width / px_per_m;
  const double half_y = 0.5 * kPanel / px_per_m;
  return {corner,
          width,
          kPanel,
          {x.middle() - half_x, x.middle() + half_x},
          {y.middle() - half_y, y.middle() + half_y}};
}

void draw_view(SvgWriter& svg, const PeopleRun& run, const Tracks& tracks, const View& view,
               const Vector2& corner, double width) {
  const DiagramAxes axes = axes_of(run, tracks, view, corner, width);
  svg.text(corner + Vector2(0, -44), view.title, R"(font-size="14" font-weight="bold")");
  svg.text(corner + Vector2(0, -26), view.score, R"(font-size="13")");
  axes.draw(svg, "x in odom [m]", "y in odom [m]");
  const auto at = [&](const Vector2& p) { return axes.at(p.x(), p.y()); };
  std::vector<Vector2> way;
  for (std::size_t i = 0; i < run.sweeps.size(); ++i) {
    const double time = run.sweeps[i].time;
    if (run.robot[i] && time >= view.times.low && time <= view.times.high) way.push_back(at(*run.robot[i]));
  }
  if (!way.empty()) {
    svg.polyline(way, R"(stroke="#000" stroke-width="2.5" stroke-opacity="0.5")");
    svg.circle(way.back(), 6, R"(fill="#000")");
  }
  for (const auto& [id, track] : tracks)
    draw_track(svg, id, track, view.times, [&](const Sighting& s) { return at(s.place); });
  if (view.stretch == nullptr) return;
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& instant : view.stretch->labels) {
    if (instant.time - last < 0.4) continue;  // of a truth at every sweep not every cross
    last = instant.time;
    for (const auto& person : instant.people)
      if (person.counted) draw_cross(svg, at(person.position));
  }
  for (const auto& error : view.stretch->score.errors) draw_error(svg, at(error.position), error.kind);
}

void draw_legend(SvgWriter& svg) {
  draw_cross(svg, {76, 24});
  svg.text({88, 29}, "labelled person who counts", kLegend);
  draw_error(svg, {300, 24}, TrackError::miss);
  svg.text({314, 29}, "missed", kLegend);
  draw_error(svg, {390, 24}, TrackError::false_track);
  svg.text({404, 29}, "false", kLegend);
  draw_error(svg, {464, 24}, TrackError::other_identity);
  svg.text({478, 29}, "other identity", kLegend);
  svg.line({600, 24}, {630, 24}, R"(stroke="#0072b2" stroke-width="1.7")");
  svg.text({638, 29}, "confirmed track", kLegend);
  svg.line({770, 24}, {800, 24}, R"(stroke="#0072b2" stroke-dasharray="3 3")");
  svg.text({808, 29}, "possible person", kLegend);
  svg.line({940, 24}, {970, 24}, R"(stroke="#000" stroke-width="2.5" stroke-opacity="0.5")");
  svg.text({978, 29}, "robot", kLegend);
  svg.rectangle({1050, 14}, 24, 20, R"(fill="#fff3cc")");
  svg.text({1082, 29}, "labelled; colours of tracks as in the lowest diagram", kLegend);
}

void shade(SvgWriter& svg, const DiagramAxes& axes, const PeopleRun& run) {
  for (const LabelledStretch& stretch : run.stretches) {
    if (stretch.labels.empty()) continue;
    const Range times = times_of(stretch);
    const Vector2 corner = axes.at(times.low, axes.v.high);
    svg.rectangle(corner, axes.at(times.high, axes.v.high).x() - corner.x(), axes.height,
                  R"(fill="#fff3cc")");
  }
}

void draw_distances(SvgWriter& svg, const PeopleRun& run, const Tracks& tracks, double top) {
  Range distances{0.0, 1.0};
  for (const auto& [id, track] : tracks)
    for (const Sighting& s : track) distances.hold(s.distance);
  const Range times{0.0, std::max(run.duration, 1.0)};
  const DiagramAxes axes{{kLeft, top}, kWidth, 240, times, {0.0, round_end(distances.high)}};
  shade(svg, axes, run);
  axes.draw(svg, "time since the first scan [s]", "distance from the robot [m]");
  for (const auto& [id, track] : tracks)
    draw_track(svg, id, track, times, [&](const Sighting& s) { return axes.at(s.time, s.distance); });
}

/// Rows such that neither bars nor their texts, `text` [s] wide, meet: row by track, in the order of `lives`.
std::vector<std::size_t> rows_of(const std::vector<TrackLife>& lives, double text) {
  std::vector<double> free_from;
  std::vector<std::size_t> rows;
  for (const TrackLife& life : lives) {
    std::size_t row = 0;
    while (row < free_from.size() && free_from[row] > life.begin) ++row;
    if (row == free_from.size()) free_from.push_back(0.0);
    free_from[row] = life.end + text;
    rows.push_back(row);
  }
  return rows;
}

void draw_lives(SvgWriter& svg, const PeopleRun& run, const std::vector<TrackLife>& lives,
                const std::vector<std::size_t>& rows, double top) {
  const Range times{0.0, std::max(run.duration, 1.0)};
  const double count = rows.empty() ? 1.0 : 1.0 + static_cast<double>(*std::ranges::max_element(rows));
  const DiagramAxes axes{{kLeft, top}, kWidth, kRow * count, times, {0.0, count}};
  shade(svg, axes, run);
  axes.draw(svg, "time since the first scan [s]",
            "lives of tracks: possible (thin), confirmed (thick); number and length", false);
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const TrackLife& life = lives[i];
    const double row = count - 0.5 - static_cast<double>(rows[i]);
    const Vector2 begin = axes.at(life.begin, row);
    const Vector2 end = axes.at(life.end, row);
    const std::string fill = "fill=\"" + color_of(life.id) + '"';
    svg.rectangle(begin - Vector2(0, 1.5), std::max(end.x() - begin.x(), 2.0), 3, fill);
    if (life.confirmed) {
      const Vector2 since = axes.at(*life.confirmed, row);
      svg.rectangle(since - Vector2(0, 5), std::max(end.x() - since.x(), 2.0), 10, fill);
    }
    const std::string text = std::to_string(life.id) + ": " + fixed(life.end - life.begin, 1) + " s";
    if (end.x() < kLeft + kWidth - 70) {
      svg.text(end + Vector2(4, 4), text, R"(font-size="11")");
    } else if (begin.x() > kLeft + 70) {
      svg.text(begin + Vector2(-4, 4), text, R"(font-size="11" text-anchor="end")");
    } else {
      const bool is_on_bar = life.confirmed && axes.at(*life.confirmed, row).x() < kLeft + 60;
      svg.text(begin + Vector2(6, is_on_bar ? 4 : -3), text,
               is_on_bar ? R"svg(font-size="11" fill="#fff" font-weight="bold")svg" : R"(font-size="11")");
    }
  }
}

}  // namespace

std::string people_picture(const PeopleRun& run) {
  const Tracks tracks = tracks_of(run);
  const std::vector<View> views = views_of(run);
  std::vector<TrackLife> lives = lives_of(run.sweeps);
  std::ranges::stable_sort(lives, {}, &TrackLife::begin);
  const std::vector<std::size_t> rows = rows_of(lives, 80.0 * std::max(run.duration, 1.0) / kWidth);
  const double view_rows = std::ceil(static_cast<double>(views.size()) / 3.0);
  const double distances_at = 110.0 + 520.0 * view_rows;
  const double lives_at = distances_at + 310.0;
  const double count = rows.empty() ? 1.0 : 1.0 + static_cast<double>(*std::ranges::max_element(rows));
  const double height = lives_at + kRow * count + 60.0;
  SvgWriter svg(1500, height);
  svg.rectangle({0, 0}, 1500, height, R"(fill="#fff")");
  draw_legend(svg);
  const std::size_t in_row = std::min<std::size_t>(views.size(), 3);
  const double width = (kWidth + kBetween) / static_cast<double>(in_row) - kBetween;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Vector2 corner(kLeft + (width + kBetween) * static_cast<double>(i % in_row),
                         110.0 + 520.0 * static_cast<double>(i / in_row));
    draw_view(svg, run, tracks, views[i], corner, width);
  }
  draw_distances(svg, run, tracks, distances_at);
  draw_lives(svg, run, lives, rows, lives_at);
  return std::move(svg).finish();
}

}  // namespace bw
