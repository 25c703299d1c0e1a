#include "components/tools/bench/crowdnav_report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(CrowdNavOutcome outcome) {
  switch (outcome) {
    case CrowdNavOutcome::reached:
      return "reached";
    case CrowdNavOutcome::collision:
      return "collision";
    case CrowdNavOutcome::timeout:
      return "timeout";
  }
  return "";
}

Json to_json(const CrowdNavEpisode& e) {
  return {{"name", e.name},
          {"outcome", name_of(e.outcome)},
          {"possible", !e.is_excused()},
          {"contacts", to_json(e.judged)},
          {"time_s", e.time},
          {"discomfort_steps", e.discomfort_steps},
          {"min_gap_m", e.min_gap},
          {"rms_jerk_mps3", e.rms_jerk},
          {"mean_ms", mean(e.ms)},
          {"p95_ms", quantile(e.ms, 0.95)},
          {"max_ms", quantile(e.ms, 1.0)}};
}

}  // namespace

CrowdNavSummary summarize(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes) {
  CrowdNavSummary s;
  s.planner = planner;
  s.episodes = static_cast<int>(episodes.size());
  std::vector<double> times, gaps, jerks, ms;
  double discomfort_steps = 0.0, steps = 0.0;
  for (const CrowdNavEpisode& e : episodes) {
    s.successes += e.outcome == CrowdNavOutcome::reached ? 1 : 0;
    s.collisions += e.outcome == CrowdNavOutcome::collision ? 1 : 0;
    s.timeouts += e.outcome == CrowdNavOutcome::timeout ? 1 : 0;
    s.possible += e.is_excused() ? 0 : 1;
    for (const JudgedContact& contact : e.judged) s.hits.add(contact.record);
    if (e.outcome == CrowdNavOutcome::reached) times.push_back(e.time);
    discomfort_steps += e.discomfort_steps;
    steps += e.time / kCrowdNavStep;
    gaps.push_back(e.min_gap);
    jerks.push_back(e.rms_jerk);
    ms.insert(ms.end(), e.ms.begin(), e.ms.end());
  }
  s.wilson = wilson95(s.successes, s.episodes);
  s.wilson_possible = wilson95(s.successes, s.possible);
  s.mean_time = mean(times);
  s.discomfort = steps > 0.0 ? discomfort_steps / steps : 0.0;
  s.mean_min_gap = mean(gaps);
  s.min_gap = quantile(gaps, 0.0);
  s.mean_rms_jerk = mean(jerks);
  s.mean_ms = mean(ms);
  s.p95_ms = quantile(ms, 0.95);
  s.max_ms = quantile(ms, 1.0);
  return s;
}

Json to_json(const CrowdNavSummary& s, const std::vector<CrowdNavEpisode>& episodes) {
  Json rows = Json::array();
  for (const CrowdNavEpisode& e : episodes) rows.push_back(to_json(e));
  return {{"planner", s.planner},
          {"episodes", std::move(rows)},
          {"summary",
           {{"episodes", s.episodes},
            {"successes", s.successes},
            {"wilson95", {s.wilson.low, s.wilson.high}},
            {"possible", s.possible},
            {"wilson95_possible", {s.wilson_possible.low, s.wilson_possible.high}},
            {"hits", s.hits.to_json()},
            {"collisions", s.collisions},
            {"timeouts", s.timeouts},
            {"mean_time_s", s.mean_time},
            {"discomfort", s.discomfort},
            {"mean_min_gap_m", s.mean_min_gap},
            {"min_gap_m", s.min_gap},
            {"mean_rms_jerk_mps3", s.mean_rms_jerk},
            {"mean_ms", s.mean_ms},
            {"p95_ms", s.p95_ms},
            {"max_ms", s.max_ms}}}};
}

Json to_json(const CrowdNavSample& s) {
  Json people = Json::array();
  for (const CrowdNavAgent& p : s.people)
    people.push_back({p.position.x(), p.position.y(), p.velocity.x(), p.velocity.y()});
  return {{"t", s.time},
          {"pose", {s.pose.x, s.pose.y, s.pose.theta}},
          {"velocity", {s.velocity.x(), s.velocity.y()}},
          {"people", std::move(people)}};
}

std::string in_a_line(const CrowdNavEpisode& e) {
  return fmt::format("{:<10} {:<9} {:6.2f} s  discomfort {:3d}  gap {:6.3f}  jerk {:5.2f}  {:5.2f} ms mean\n",
                     e.name, name_of(e.outcome), e.time, e.discomfort_steps, e.min_gap, e.rms_jerk,
                     mean(e.ms));
}

std::string table(const std::vector<CrowdNavSummary>& summaries) {
  constexpr const char* kRow =
      "{:<15} {:>5} {:>8} {:>15} {:>10} {:>15} {:>9} {:>8} {:>7} {:>10} {:>16} {:>6} {:>20}\n";
  std::string out =
      fmt::format(fmt::runtime(kRow), "planner", "cases", "success", "Wilson 95 %", "possible", "Wilson 95 %",
                  "collision", "timeout", "time s", "discomfort", "gap m", "jerk", "decision ms");
  out += fmt::format(fmt::runtime(kRow), "", "", "", "", "", "", "", "", "mean", "of steps", "mean / min",
                     "rms", "mean / p95 / max");
  const auto interval = [](const Interval& i) { return fmt::format("{:.3f} - {:.3f}", i.low, i.high); };
  for (const CrowdNavSummary& s : summaries) {
    const auto three = [](double value) { return fmt::format("{:.3f}", value); };
    out += fmt::format(fmt::runtime(kRow), s.planner, s.episodes, three(s.share(s.successes)),
                       interval(s.wilson), fmt::format("{} of {}", s.successes, s.possible),
                       interval(s.wilson_possible), three(s.share(s.collisions)), three(s.share(s.timeouts)),
                       fmt::format("{:.2f}", s.mean_time), three(s.discomfort),
                       fmt::format("{:.3f} / {:.3f}", s.mean_min_gap, s.min_gap),
                       fmt::format("{:.2f}", s.mean_rms_jerk),
                       fmt::format("{:.2f} / {:.2f} / {:.1f}", s.mean_ms, s.p95_ms, s.max_ms));
  }
  for (const CrowdNavSummary& s : summaries)
    out += fmt::format("contacts of {}: {}\n", s.planner, s.hits.in_words());
  return out;
}

std::string failures(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes) {
  std::string out;
  for (const CrowdNavEpisode& e : episodes) {
    if (e.outcome == CrowdNavOutcome::reached) continue;
    out += fmt::format("failed: {} {}: {}{}\n", planner, e.name, name_of(e.outcome),
                       e.is_excused() ? ", could not succeed" : "");
    for (const Json& contact : to_json(e.judged)) out += "  " + contact_in_words(contact) + "\n";
  }
  return out;
}

}  // namespace bw
