#include "components/lab/bench/people_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/model/mover_weight.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;
using people::Score;
using people::StretchScore;
using people::TrackError;
using people::TrackErrorAt;

constexpr double kBrief = 2.0;  // a track that is shorter [s]

const char* name_of(TrackError kind) {
  switch (kind) {
    case TrackError::miss:
      return "miss";
    case TrackError::false_track:
      return "false";
    case TrackError::other_identity:
      return "switch";
  }
  return "";
}

std::string figure(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string confirmation_text(const std::vector<double>& seconds) {
  if (seconds.empty()) return "nobody";
  return fmt::format("{} people, {:.1f} s (median), {:.1f} s (95 %)", seconds.size(), quantile(seconds, 0.5),
                     quantile(seconds, 0.95));
}

std::string score_text(const StretchScore& score, bool has_velocities) {
  const Score& s = score.clear_mot;
  std::string text = fmt::format(
      "  MOTA {}  MOTP {} m  misses {} of {} ({} of them possible)  false {}  switches {}  tracks per person {}\n",
      figure(s.mota(), "{:.3f}"), figure(s.motp(), "{:.3f}"), s.people - s.matched, s.people,
      score.possible_at_misses, s.false_positives, s.switches, figure(score.tracks_per_person(), "{:.2f}"));
  text += fmt::format(
      "  IDF1 {}  GOSPA {} m  in plain view: recall {} of {}; precision {}; {:.1f} person-minutes; possible people elsewhere {}\n",
      figure(s.idf1(), "{:.3f}"), figure(s.mean_gospa(), "{:.3f}"), figure(s.recall(), "{:.3f}"), s.plain,
      figure(s.precision(), "{:.3f}"), s.person_minutes(), score.possible_elsewhere);
  text += "  confirmed after: " + confirmation_text(s.confirmation) +
          "; who walks: " + confirmation_text(s.walkers_confirmation) + "\n";
  if (has_velocities) text += "  velocity error " + figure(s.velocity_rmse(), "{:.3f}") + " m/s rms\n";
  if (!score.horizons.empty()) {
    text += "  predictions, mean error and truths in the 95 % ellipse:";
    for (const people::HorizonScore& h : score.horizons)
      text += fmt::format("  {:.1f} s {:.2f} m {:.1f} %", h.ahead, h.mean_error(), 100.0 * h.share_inside());
    text += "\n";
  }
  return text;
}

std::string errors_text(const StretchScore& score) {
  std::string text;
  for (const TrackErrorAt& error : score.errors) {
    text += fmt::format("  {:7.2f} s  {:6} {} {} at ({:.2f}, {:.2f}){}\n", error.time, name_of(error.kind),
                        error.kind == TrackError::false_track ? "track" : "person", error.id,
                        error.position.x(), error.position.y(), error.is_possible ? ", possible" : "");
  }
  return text;
}

std::string lives_text(const std::vector<TrackLife>& lives) {
  std::string text = "  track    from [s]      to [s]  lasts [s]  confirmed at [s]  confirmed for\n";
  for (const TrackLife& life : lives) {
    text += fmt::format(
        "  {:>5}  {:>10.2f}  {:>10.2f}  {:>9.1f}  {:>16}  {:>11.0f} %\n", life.id, life.begin, life.end,
        life.end - life.begin, life.confirmed ? fmt::format("{:.2f}", *life.confirmed) : "never",
        100.0 * static_cast<double>(life.confirmed_sweeps) / static_cast<double>(life.sweeps));
  }
  return text;
}

struct LifeFigures {
  std::size_t confirmed = 0;  ///< of all, once at least
  std::size_t brief = 0;      ///< of the confirmed
  double mean = 0.0;          ///< length of the confirmed [s]
};

LifeFigures figures_of(const std::vector<TrackLife>& lives) {
  LifeFigures figures;
  for (const TrackLife& life : lives) {
    if (!life.confirmed) continue;
    ++figures.confirmed;
    figures.mean += life.end - life.begin;
    figures.brief += life.end - life.begin < kBrief ? 1 : 0;
  }
  if (figures.confirmed > 0) figures.mean /= static_cast<double>(figures.confirmed);
  return figures;
}

StretchScore sum_of(const PeopleRun& run) {
  StretchScore all;
  for (const LabelledStretch& stretch : run.stretches) all.add(stretch.score);
  return all;
}

ordered_json to_json(const StretchScore& score, bool has_velocities) {
  const Score& s = score.clear_mot;
  ordered_json json = {{"instants", score.instants},
                       {"people", score.tracks.size()},
                       {"mota", s.mota()},
                       {"motp_m", s.motp()},
                       {"idf1", s.idf1()},
                       {"gospa_m", s.mean_gospa()},
                       {"places", s.people},
                       {"misses", s.people - s.matched},
                       {"misses_possible", score.possible_at_misses},
                       {"false", s.false_positives},
                       {"possible_elsewhere", score.possible_elsewhere},
                       {"switches", s.switches},
                       {"switches_in_view", s.switches_seen},
                       {"tracks_per_person", score.tracks_per_person()},
                       {"recall_in_plain_view", s.recall()},
                       {"precision", s.precision()},
                       {"person_minutes", s.person_minutes()},
                       {"confirmation_s", s.confirmation},
                       {"walkers_confirmation_s", s.walkers_confirmation}};
  if (has_velocities) json["velocity_rmse_mps"] = s.velocity_rmse();
  json["predictions"] = ordered_json::array();
  for (const people::HorizonScore& h : score.horizons) {
    json["predictions"].push_back({{"ahead_s", h.ahead},
                                   {"count", h.count},
                                   {"mean_error_m", h.mean_error()},
                                   {"share_in_95_ellipse", h.share_inside()}});
  }
  return json;
}

ordered_json to_json(const std::vector<TrackErrorAt>& errors) {
  ordered_json json = ordered_json::array();
  for (const TrackErrorAt& error : errors) {
    ordered_json entry = {{"time_s", error.time},
                          {"kind", name_of(error.kind)},
                          {"id", error.id},
                          {"x_m", error.position.x()},
                          {"y_m", error.position.y()}};
    if (error.kind == TrackError::miss) entry["possible"] = error.is_possible;
    json.push_back(std::move(entry));
  }
  return json;
}

ordered_json to_json(const TrackLife& life) {
  return {{"id", life.id},
          {"from_s", life.begin},
          {"to_s", life.end},
          {"sweeps", life.sweeps},
          {"confirmed_sweeps", life.confirmed_sweeps},
          {"confirmed_at_s", life.confirmed ? ordered_json(*life.confirmed) : ordered_json(nullptr)}};
}

}  // namespace

std::vector<TrackLife> lives_of(const std::vector<people::TrackedSweep>& sweeps) {
  std::map<std::uint32_t, TrackLife> lives;
  for (const people::TrackedSweep& sweep : sweeps) {
    for (const TrackedPerson& track : sweep.people) {
      TrackLife& life =
          lives.try_emplace(track.id, TrackLife{.id = track.id, .begin = sweep.time}).first->second;
      life.end = sweep.time;
      ++life.sweeps;
      if (!is_confirmed(track)) continue;
      ++life.confirmed_sweeps;
      if (!life.confirmed) life.confirmed = sweep.time;
    }
  }
  std::vector<TrackLife> by_id;
  for (const auto& [id, life] : lives) by_id.push_back(life);
  return by_id;
}

std::string people_text(const PeopleRun& run, bool with_errors) {
  const std::vector<TrackLife> lives = lives_of(run.sweeps);
  const LifeFigures figures = figures_of(lives);
  std::string text;
  for (const std::string& note : run.notes) text += "note: " + note + "\n";
  text += fmt::format(
      "{}: {} of {} scans looked at, {:.1f} s; {} confirmed tracks, {:.1f} s on average, {} of less than 2 s; {} "
      "that were only possible\n",
      run.bag, run.sweeps.size(), run.scans, run.duration, figures.confirmed, figures.mean, figures.brief,
      lives.size() - figures.confirmed);
  if (run.stretches.empty()) return text + lives_text(lives);
  for (const LabelledStretch& stretch : run.stretches) {
    if (stretch.labels.empty()) continue;
    text += fmt::format("{}: {:.1f} to {:.1f} s, {} instants, {} people\n", stretch.name,
                        stretch.labels.front().time, stretch.labels.back().time, stretch.score.instants,
                        stretch.score.tracks.size());
    text += score_text(stretch.score, run.is_truth);
    if (with_errors) text += errors_text(stretch.score);
  }
  if (run.stretches.size() > 1) text += "all of these\n" + score_text(sum_of(run), run.is_truth);
  return text;
}

ordered_json people_json(const PeopleRun& run) {
  const std::vector<TrackLife> lives = lives_of(run.sweeps);
  const LifeFigures figures = figures_of(lives);
  ordered_json json = {{"bag", run.bag},
                       {"scans", run.scans},
                       {"scans_looked_at", run.sweeps.size()},
                       {"duration_s", run.duration},
                       {"notes", run.notes},
                       {"truth", run.is_truth},
                       {"confirmed_tracks", figures.confirmed},
                       {"only_possible_tracks", lives.size() - figures.confirmed},
                       {"mean_confirmed_track_s", figures.mean},
                       {"confirmed_tracks_below_2_s", figures.brief},
                       {"stretches", ordered_json::array()}};
  for (const LabelledStretch& stretch : run.stretches) {
    ordered_json entry = {{"labels", stretch.name},
                          {"from_s", stretch.labels.empty() ? 0.0 : stretch.labels.front().time},
                          {"to_s", stretch.labels.empty() ? 0.0 : stretch.labels.back().time}};
    entry.update(to_json(stretch.score, run.is_truth));
    entry["errors"] = to_json(stretch.score.errors);
    json["stretches"].push_back(std::move(entry));
  }
  if (!run.stretches.empty()) json["all"] = to_json(sum_of(run), run.is_truth);
  json["tracks"] = ordered_json::array();
  for (const TrackLife& life : lives) json["tracks"].push_back(to_json(life));
  return json;
}

}  // namespace bw
