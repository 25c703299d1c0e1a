#include "components/tools/bench/crowd_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

Json to_json(const CrowdEpisode& e) {
  return {{"name", e.name},
          {"success", e.success},
          {"possible", !e.is_excused()},
          {"contacts", to_json(e.judged)},
          {"collision", e.collision},
          {"collision_at_speed", e.collision_at_speed},
          {"time_s", e.time},
          {"min_clearance_m", e.min_clearance},
          {"max_collision_index", e.max_collision_index},
          {"rms_jerk_mps3", e.rms_jerk},
          {"not_ok_cycles", e.not_ok},
          {"mean_ms", mean(e.ms)},
          {"p95_ms", quantile(e.ms, 0.95)},
          {"max_ms", quantile(e.ms, 1.0)}};
}

}  // namespace

CrowdSummary summarize(const std::string& planner, const std::vector<CrowdEpisode>& episodes) {
  CrowdSummary s;
  s.planner = planner;
  s.episodes = static_cast<int>(episodes.size());
  std::vector<double> ms;
  for (const CrowdEpisode& e : episodes) {
    s.successes += e.success ? 1 : 0;
    s.contacts += e.collision ? 1 : 0;
    s.contacts_at_speed += e.collision_at_speed ? 1 : 0;
    s.timeouts += e.success || e.collision ? 0 : 1;
    s.possible += e.is_excused() ? 0 : 1;
    for (const ContactRecord& contact : e.contacts) s.hits.add(contact);
    ms.insert(ms.end(), e.ms.begin(), e.ms.end());
  }
  s.wilson = wilson95(s.successes, s.episodes);
  s.wilson_possible = wilson95(s.successes, s.possible);
  s.mean_time = mean(figures(episodes, &CrowdEpisode::time));
  const std::vector<double> clearances = figures(episodes, &CrowdEpisode::min_clearance);
  s.mean_min_clearance = mean(clearances);
  s.min_clearance = quantile(clearances, 0.0);
  const std::vector<double> indices = figures(episodes, &CrowdEpisode::max_collision_index);
  s.mean_max_collision_index = mean(indices);
  s.max_collision_index = quantile(indices, 1.0);
  s.mean_rms_jerk = mean(figures(episodes, &CrowdEpisode::rms_jerk));
  s.mean_ms = mean(ms);
  s.p95_ms = quantile(ms, 0.95);
  s.max_ms = quantile(ms, 1.0);
  return s;
}

Json to_json(const CrowdSummary& s, const std::vector<CrowdEpisode>& episodes) {
  Json rows = Json::array();
  for (const CrowdEpisode& e : episodes) rows.push_back(to_json(e));
  return {{"planner", s.planner},
          {"episodes", std::move(rows)},
          {"summary",
           {{"episodes", s.episodes},
            {"successes", s.successes},
            {"wilson95", {s.wilson.low, s.wilson.high}},
            {"possible", s.possible},
            {"wilson95_possible", {s.wilson_possible.low, s.wilson_possible.high}},
            {"hits", s.hits.to_json()},
            {"contacts", s.contacts},
            {"contacts_at_speed", s.contacts_at_speed},
            {"timeouts", s.timeouts},
            {"mean_time_s", s.mean_time},
            {"mean_min_clearance_m", s.mean_min_clearance},
            {"min_clearance_m", s.min_clearance},
            {"mean_max_collision_index", s.mean_max_collision_index},
            {"max_collision_index", s.max_collision_index},
            {"mean_rms_jerk_mps3", s.mean_rms_jerk},
            {"mean_ms", s.mean_ms},
            {"p95_ms", s.p95_ms},
            {"max_ms", s.max_ms}}}};
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
  constexpr auto kRow =
      "{:<14} {:>10} {:>15} {:>10} {:>15} {:>8} {:>8} {:>8} {:>6} {:>13} {:>13} {:>6} {:>20}\n";
  const auto interval = [](const Interval& i) { return fmt::format("{:.3f} - {:.3f}", i.low, i.high); };
  std::string out =
      fmt::format(kRow, "planner", "success", "Wilson 95 %", "possible", "Wilson 95 %", "contacts",
                  "at speed", "timeouts", "time s", "clearance m", "CI", "jerk", "cycle ms");
  out += fmt::format(kRow, "", "", "", "", "", "", "", "", "mean", "mean / min", "mean / max", "rms",
                     "mean / p95 / max");
  for (const CrowdSummary& s : summaries) {
    out += fmt::format(kRow, s.planner, fmt::format("{} of {}", s.successes, s.episodes), interval(s.wilson),
                       fmt::format("{} of {}", s.successes, s.possible), interval(s.wilson_possible),
                       s.contacts, s.contacts_at_speed, s.timeouts, fmt::format("{:.2f}", s.mean_time),
                       fmt::format("{:.3f} / {:.3f}", s.mean_min_clearance, s.min_clearance),
                       fmt::format("{:.3f} / {:.3f}", s.mean_max_collision_index, s.max_collision_index),
                       fmt::format("{:.2f}", s.mean_rms_jerk),
                       fmt::format("{:.2f} / {:.2f} / {:.1f}", s.mean_ms, s.p95_ms, s.max_ms));
  }
  for (const CrowdSummary& s : summaries)
    out += fmt::format("contacts of {}: {}\n", s.planner, s.hits.in_words());
  return out;
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

std::string failures(const std::string& planner, const std::vector<CrowdEpisode>& episodes) {
  std::string out;
  for (const CrowdEpisode& e : episodes) {
    if (e.success) continue;
    out += fmt::format("failed: {} {}: {}{}\n", planner, e.name, e.collision ? "contact" : "timeout",
                       e.is_excused() ? ", could not succeed" : "");
    for (const Json& contact : to_json(e.judged)) out += "  " + contact_in_words(contact) + "\n";
  }
  return out;
}

}  // namespace bw
