#include "components/lab/bench/crowdnav_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
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

RatedDrive rated(const CrowdNavEpisode& e) {
  return {.name = e.name,
          .outcome = name_of(e.outcome),
          .success = e.outcome == CrowdNavOutcome::reached,
          .is_late = e.outcome == CrowdNavOutcome::timeout,
          .is_excused = e.is_excused(),
          .contacts = e.judged,
          .rms_jerk = e.rms_jerk,
          .ms = e.ms};
}

Json to_json(const CrowdNavEpisode& e) {
  Json json = to_json(rated(e));
  json.update(Json{{"outcome", name_of(e.outcome)},
                   {"time_s", e.time},
                   {"discomfort_steps", e.discomfort_steps},
                   {"intrusions", e.intrusions},
                   {"steps", e.steps},
                   {"path_m", e.path},
                   {"min_gap_m", e.min_gap}});
  return json;
}

}  // namespace

std::vector<RatedDrive> rated(const std::vector<CrowdNavEpisode>& episodes) {
  std::vector<RatedDrive> drives;
  for (const CrowdNavEpisode& e : episodes) drives.push_back(rated(e));
  return drives;
}

CrowdNavSummary summarize(const std::string& planner, const std::vector<CrowdNavEpisode>& episodes) {
  CrowdNavSummary s;
  s.rates = rates_of(planner, rated(episodes));
  std::vector<double> times, gaps, intrusions, paths;
  double discomfort_steps = 0.0, steps = 0.0;
  for (const CrowdNavEpisode& e : episodes) {
    s.collisions += e.outcome == CrowdNavOutcome::collision ? 1 : 0;
    if (e.outcome == CrowdNavOutcome::reached) times.push_back(e.time);
    discomfort_steps += e.discomfort_steps;
    steps += e.time / kCrowdNavStep;
    gaps.push_back(e.min_gap);
    intrusions.push_back(e.steps > 0 ? static_cast<double>(e.intrusions) / e.steps : 0.0);
    paths.push_back(e.path);
  }
  s.mean_time = mean(times);
  s.discomfort = steps > 0.0 ? discomfort_steps / steps : 0.0;
  s.intrusion = mean(intrusions);
  s.path = mean(paths);
  s.mean_min_gap = mean(gaps);
  s.min_gap = quantile(gaps, 0.0);
  return s;
}

Json to_json(const CrowdNavSummary& s, const std::vector<CrowdNavEpisode>& episodes) {
  Json rows = Json::array();
  for (const CrowdNavEpisode& e : episodes) rows.push_back(to_json(e));
  Json summary = to_json(s.rates);
  summary.update(Json{{"collisions", s.collisions},
                      {"mean_time_s", s.mean_time},
                      {"discomfort", s.discomfort},
                      {"intrusion", s.intrusion},
                      {"path_m", s.path},
                      {"mean_min_gap_m", s.mean_min_gap},
                      {"min_gap_m", s.min_gap}});
  return {{"planner", s.rates.planner}, {"episodes", std::move(rows)}, {"summary", std::move(summary)}};
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
  std::vector<DriveRates> rates;
  OwnColumn success{"success", "share", {}}, collision{"collision", "share", {}},
      timeout{"timeout", "share", {}}, time{"time s", "mean", {}}, path{"path m", "mean", {}},
      discomfort{"discomfort", "of steps", {}}, intrusion{"intrusion", "of steps", {}},
      gap{"gap m", "mean / min", {}};
  for (const CrowdNavSummary& s : summaries) {
    const auto share = [&](int count) { return fmt::format("{:.3f}", s.rates.share(count)); };
    rates.push_back(s.rates);
    success.cells.push_back(share(s.rates.successes));
    collision.cells.push_back(share(s.collisions));
    timeout.cells.push_back(share(s.rates.timeouts));
    time.cells.push_back(fmt::format("{:.2f}", s.mean_time));
    path.cells.push_back(fmt::format("{:.2f}", s.path));
    discomfort.cells.push_back(fmt::format("{:.3f}", s.discomfort));
    intrusion.cells.push_back(fmt::format("{:.3f}", s.intrusion));
    gap.cells.push_back(fmt::format("{:.3f} / {:.3f}", s.mean_min_gap, s.min_gap));
  }
  return drive_table(rates, {success, collision, timeout, time, path, discomfort, intrusion, gap});
}

}  // namespace bw
