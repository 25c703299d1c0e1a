#include "components/lab/bench/crowd_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> figures(const std::vector<CrowdEpisode>& episodes, double CrowdEpisode::*figure) {
  std::vector<double> values;
  values.reserve(episodes.size());
  for (const CrowdEpisode& e : episodes) values.push_back(e.*figure);
  return values;
}

RatedDrive rated(const CrowdEpisode& e) {
  return {.name = e.name,
          .outcome = e.collision ? "contact" : "timeout",
          .success = e.success,
          .is_late = !e.success && !e.collision,
          .is_excused = e.is_excused(),
          .contacts = e.judged,
          .rms_jerk = e.rms_jerk,
          .ms = e.ms};
}

Json to_json(const CrowdEpisode& e) {
  Json json = to_json(rated(e));
  json.update(Json{{"success", e.success},
                   {"collision", e.collision},
                   {"collision_at_speed", e.collision_at_speed},
                   {"time_s", e.time},
                   {"min_clearance_m", e.min_clearance},
                   {"max_collision_index", e.max_collision_index},
                   {"not_ok_cycles", e.not_ok}});
  return json;
}

}  // namespace

std::vector<RatedDrive> rated(const std::vector<CrowdEpisode>& episodes) {
  std::vector<RatedDrive> drives;
  for (const CrowdEpisode& e : episodes) drives.push_back(rated(e));
  return drives;
}

CrowdSummary summarize(const std::string& planner, const std::vector<CrowdEpisode>& episodes) {
  CrowdSummary s;
  s.rates = rates_of(planner, rated(episodes));
  for (const CrowdEpisode& e : episodes) {
    s.contacts += e.collision ? 1 : 0;
    s.contacts_at_speed += e.collision_at_speed ? 1 : 0;
    s.reached_without_contact_at_speed += e.reached && !e.collision_at_speed ? 1 : 0;
  }
  s.mean_time = mean(figures(episodes, &CrowdEpisode::time));
  const std::vector<double> clearances = figures(episodes, &CrowdEpisode::min_clearance);
  s.mean_min_clearance = mean(clearances);
  s.min_clearance = quantile(clearances, 0.0);
  const std::vector<double> indices = figures(episodes, &CrowdEpisode::max_collision_index);
  s.mean_max_collision_index = mean(indices);
  s.max_collision_index = quantile(indices, 1.0);
  return s;
}

Json to_json(const CrowdSummary& s, const std::vector<CrowdEpisode>& episodes) {
  Json rows = Json::array();
  for (const CrowdEpisode& e : episodes) rows.push_back(to_json(e));
  Json summary = to_json(s.rates);
  summary.update(Json{{"reached_without_contact_at_speed", s.reached_without_contact_at_speed},
                      {"contacts", s.contacts},
                      {"contacts_at_speed", s.contacts_at_speed},
                      {"mean_time_s", s.mean_time},
                      {"mean_min_clearance_m", s.mean_min_clearance},
                      {"min_clearance_m", s.min_clearance},
                      {"mean_max_collision_index", s.mean_max_collision_index},
                      {"max_collision_index", s.max_collision_index}});
  return {{"planner", s.rates.planner}, {"episodes", std::move(rows)}, {"summary", std::move(summary)}};
}

std::string in_a_line(const CrowdEpisode& e) {
  const char* outcome = e.success ? "ok" : e.collision ? "COLLISION" : "TIMEOUT";
  return fmt::format(
      "{:<14} {:<9} {:5.1f} s  clearance {:.3f}  CI {:.3f}  jerk {:.2f}  {:5.2f} ms mean {:5.2f} p95 {:5.2f} "
      "max  stops {}\n",
      e.name, outcome, e.time, e.min_clearance, e.max_collision_index, e.rms_jerk, mean(e.ms),
      quantile(e.ms, 0.95), quantile(e.ms, 1.0), e.not_ok);
}

std::string table(const std::vector<CrowdSummary>& summaries) {
  std::vector<DriveRates> rates;
  OwnColumn unhit{"no contact", "at speed", {}}, contacts{"contacts", "", {}}, at_speed{"at speed", "", {}},
      time{"time s", "mean", {}}, clearance{"clearance m", "mean / min", {}}, index{"CI", "mean / max", {}};
  for (const CrowdSummary& s : summaries) {
    rates.push_back(s.rates);
    unhit.cells.push_back(std::to_string(s.reached_without_contact_at_speed));
    contacts.cells.push_back(std::to_string(s.contacts));
    at_speed.cells.push_back(std::to_string(s.contacts_at_speed));
    time.cells.push_back(fmt::format("{:.2f}", s.mean_time));
    clearance.cells.push_back(fmt::format("{:.3f} / {:.3f}", s.mean_min_clearance, s.min_clearance));
    index.cells.push_back(fmt::format("{:.3f} / {:.3f}", s.mean_max_collision_index, s.max_collision_index));
  }
  return drive_table(rates, {unhit, contacts, at_speed, time, clearance, index});
}

std::string outcome_in_words(const CrowdEpisode& e) {
  std::string text =
      e.contacts.empty() ? "no contact" : fmt::format("contact at {:.2f} s", e.contacts[0].time);
  text += e.reached ? fmt::format(", goal reached in {:.1f} s", e.time)
                    : fmt::format(", goal not reached in {:.0f} s", e.time);
  return text + (e.is_excused() ? ", could not succeed" : "");
}

std::vector<PairedEpisode> paired(const std::vector<CrowdEpisode>& episodes) {
  std::vector<PairedEpisode> pairs;
  for (const CrowdEpisode& e : episodes) {
    pairs.push_back({.key = e.name,
                     .success = e.success,
                     .possible = !e.is_excused(),
                     .collision_index = e.max_collision_index,
                     .closest = e.min_clearance,
                     .jerk = e.rms_jerk,
                     .time = e.time});
  }
  return pairs;
}

}  // namespace bw
