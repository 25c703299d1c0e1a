#include "components/lab/bench/people_page.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "components/lab/bench/people_report.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

using people::TrackError;
using report::Color;
using report::plain;

constexpr double kPause = 0.3;          // a line is interrupted where a track is not reported for longer [s]
constexpr double kBetweenLabels = 0.4;  // of a truth at every sweep not every cross [s]
constexpr double kRow = 18.0;           // of a track's life [px]
constexpr double kNameOfLife = 0.08;    // of the width, behind a life
const Vector2 kNowhere = Vector2::Constant(std::numeric_limits<double>::quiet_NaN());

struct Sighting {
  double time;
  Vector2 position;
  double distance;  ///< from the robot; NaN where its position is not known
  bool is_confirmed;
};
using Tracks = std::map<std::uint32_t, std::vector<Sighting>>;

Tracks tracks_of(const PeopleRun& run) {
  Tracks tracks;
  for (std::size_t i = 0; i < run.sweeps.size(); ++i) {
    const people::TrackedSweep& sweep = run.sweeps[i];
    for (const TrackedPerson& person : sweep.people) {
      const double distance = run.robot[i] ? (person.position - *run.robot[i]).norm() : kNowhere.x();
      tracks[person.id].push_back({sweep.time, person.position, distance, is_confirmed(person)});
    }
  }
  return tracks;
}

Color color_of(std::uint32_t id) {
  constexpr std::array kColors{Color::blue,  Color::vermilion, Color::green, Color::purple,
                               Color::ochre, Color::sky,       Color::violet};
  return kColors[id % kColors.size()];
}

/// A track, thin and dashed while it is only possible. What is not `shown` interrupts it.
template <class Position>
void add_track(report::Chart& chart, std::uint32_t id, const std::vector<Sighting>& track,
               const Position& position_of) {
  report::Series confirmed{"confirmed track", {.color = color_of(id), .width = 1.7, .opacity = 0.85}};
  report::Series possible{
      "possible person", {.color = color_of(id), .dash = report::Dash::dashes, .width = 1.0, .opacity = 0.6}};
  const Sighting* last = nullptr;
  for (const Sighting& sighting : track) {
    report::Series& now = sighting.is_confirmed ? confirmed : possible;
    report::Series& other = sighting.is_confirmed ? possible : confirmed;
    const bool goes_on = last != nullptr && sighting.time - last->time <= kPause;
    if (!goes_on) now.points.push_back(kNowhere);
    if (goes_on && last->is_confirmed != sighting.is_confirmed) other.points.push_back(position_of(sighting));
    if (last != nullptr && last->is_confirmed != sighting.is_confirmed) other.points.push_back(kNowhere);
    now.points.push_back(position_of(sighting));
    last = &sighting;
  }
  for (report::Series* series : {&confirmed, &possible})
    if (!series->points.empty()) chart.series.push_back(std::move(*series));
}

void add_labels(report::Chart& plan, const LabelledStretch& stretch) {
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& instant : stretch.labels) {
    if (instant.time - last < kBetweenLabels) continue;
    last = instant.time;
    for (const auto& person : instant.people)
      if (person.counted)
        plan.marks.push_back(
            {person.position, report::Symbol::cross, Color::ink, "", "labelled person who counts"});
  }
  for (const auto& error : stretch.score.errors) {
    report::Mark mark{error.position, report::Symbol::ring, Color::red, "", "missed"};
    if (error.kind == TrackError::false_track) mark.symbol = report::Symbol::square, mark.name = "false";
    if (error.kind == TrackError::other_identity)
      mark.symbol = report::Symbol::triangle, mark.name = "other identity";
    plan.marks.push_back(mark);
  }
}

/// The floor from `from` to `to` [s].
report::Chart floor_chart(const PeopleRun& run, const Tracks& tracks, const std::string& name, double from,
                          double to) {
  report::Chart plan = report::floor_plan(fmt::format("{}, {:.1f} to {:.1f} s", name, from, to));
  plan.x.label = "x in odom [m]";
  plan.y.label = "y in odom [m]";
  const auto is_shown = [&](double time) { return time >= from && time <= to; };
  report::Series robot{"robot", {.width = 2.5, .opacity = 0.5}};
  for (std::size_t i = 0; i < run.sweeps.size(); ++i)
    if (run.robot[i] && is_shown(run.sweeps[i].time)) robot.points.push_back(*run.robot[i]);
  if (!robot.points.empty()) plan.marks.push_back({.at = robot.points.back()});
  plan.series.push_back(std::move(robot));
  for (const auto& [id, track] : tracks)
    add_track(plan, id, track, [&](const Sighting& s) { return is_shown(s.time) ? s.position : kNowhere; });
  return plan;
}

report::Figure floors(const PeopleRun& run, const Tracks& tracks) {
  report::Figure figure{.title = "From above",
                        .caption = "Colours of tracks as in the diagram of their lives."};
  for (const LabelledStretch& stretch : run.stretches) {
    if (stretch.labels.empty()) continue;
    report::Chart plan =
        floor_chart(run, tracks, stretch.name, stretch.labels.front().time, stretch.labels.back().time);
    add_labels(plan, stretch);
    figure.add(plan);
  }
  if (figure.pictures.empty())
    figure.add(floor_chart(run, tracks, run.bag + ", no labels", 0.0, run.duration));
  return figure;
}

report::Chart over_time(const PeopleRun& run, std::string title, std::string y) {
  report::Chart chart{.title = std::move(title),
                      .x = {"time since the first scan [s]", 0.0, std::max(run.duration, 1.0)},
                      .y = {std::move(y), 0.0}};
  for (const LabelledStretch& stretch : run.stretches)
    if (!stretch.labels.empty())
      chart.spans.push_back({stretch.labels.front().time, stretch.labels.back().time, "labelled"});
  return chart;
}

report::Chart distances(const PeopleRun& run, const Tracks& tracks) {
  report::Chart chart = over_time(run, "Distance from the robot", "distance from the robot [m]");
  for (const auto& [id, track] : tracks)
    add_track(chart, id, track, [](const Sighting& s) { return Vector2(s.time, s.distance); });
  return chart;
}

/// Lives in rows such that neither lines nor their names meet.
report::Chart lives_chart(const PeopleRun& run) {
  report::Chart chart =
      over_time(run, "Lives of tracks: possible (thin), confirmed (thick); number and length", "");
  std::vector<TrackLife> lives = lives_of(run.sweeps);
  std::ranges::stable_sort(lives, {}, &TrackLife::begin);
  std::vector<double> free_from;
  for (const TrackLife& life : lives) {
    std::size_t row = 0;
    while (row < free_from.size() && free_from[row] > life.begin) ++row;
    if (row == free_from.size()) free_from.push_back(0.0);
    free_from[row] = life.end + kNameOfLife * chart.x.high;
    const double y = -0.5 - static_cast<double>(row);
    chart.series.push_back(
        {"", {.color = color_of(life.id), .width = 2.5}, {{life.begin, y}, {life.end, y}}});
    if (life.confirmed)
      chart.series.push_back(
          {"", {.color = color_of(life.id), .width = 9.0}, {{*life.confirmed, y}, {life.end, y}}});
    chart.marks.push_back({.at = {life.end, y},
                           .color = color_of(life.id),
                           .label = fmt::format("{}: {:.1f} s", life.id, life.end - life.begin)});
  }
  const double rows = std::max(1.0, static_cast<double>(free_from.size()));
  chart.y = {"", -rows, 0.0};
  chart.height = kRow * rows;
  return chart;
}

report::Table scores(const PeopleRun& run) {
  report::Table table({"stretch",
                       {"from [s]", 1},
                       {"to [s]", 1},
                       {"MOTA", 3},
                       {"MOTP [m]", 3},
                       "misses",
                       "of",
                       "false",
                       "switches",
                       {"tracks per person", 2},
                       {"recall in plain view", 3},
                       {"precision", 3}});
  for (const LabelledStretch& stretch : run.stretches) {
    if (stretch.labels.empty()) continue;
    const people::Score& s = stretch.score.clear_mot;
    table.row({plain(stretch.name), stretch.labels.front().time, stretch.labels.back().time, s.mota(),
               s.motp(), s.people - s.matched, s.people, s.false_positives, s.switches,
               stretch.score.tracks_per_person(), s.recall(), s.precision()});
  }
  return table;
}

}  // namespace

report::Document people_page(const PeopleRun& run) {
  const Tracks tracks = tracks_of(run);
  report::Document document("People tracked in " + run.bag);
  report::Figure times{.title = "Over time", .columns = 1};
  times.add(distances(run, tracks));
  times.add(lives_chart(run));
  std::vector<std::string> notes;
  for (const std::string& note : run.notes) notes.push_back(plain(note));
  document.heading("People tracked in " + plain(run.bag), 1)
      .text(fmt::format("{} of {} scans looked at, {:.1f} s.", run.sweeps.size(), run.scans, run.duration))
      .list("", notes)
      .table(scores(run))
      .figure(floors(run, tracks))
      .figure(times);
  return document;
}

}  // namespace bw
