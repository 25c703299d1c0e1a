#include "components/program/score_card_json.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/program/contacts/contact_report.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

/// JSON knows no infinity: nobody was met, nothing was measured.
nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json planner_json(const RunFacts& facts, const std::vector<CallbackStatistics>& statistics) {
  if (facts.planner_component.empty()) return nullptr;
  const DurationHistogram& run = planner_cycle(statistics, facts.planner_component).run;
  return {{"name", facts.planner_name},
          {"cycles", run.count()},
          {"mean_ms", run.mean_ms()},
          {"median_ms", run.quantile_ms(0.5)},
          {"p95_ms", run.quantile_ms(0.95)},
          {"p99_ms", run.quantile_ms(0.99)},
          {"max_ms", run.max().to_seconds() * 1e3}};
}

nlohmann::json callbacks_json(const std::vector<CallbackStatistics>& statistics) {
  nlohmann::json all = nlohmann::json::array();
  for (const CallbackStatistics& s : statistics) {
    all.push_back({{"component", s.component},
                   {"callback", s.callback},
                   {"count", s.run.count()},
                   {"run_p50_ms", s.run.quantile_ms(0.5)},
                   {"run_p99_ms", s.run.quantile_ms(0.99)},
                   {"run_max_ms", s.run.max().to_seconds() * 1e3},
                   {"wait_p50_ms", s.wait.quantile_ms(0.5)},
                   {"wait_p99_ms", s.wait.quantile_ms(0.99)},
                   {"wait_max_ms", s.wait.max().to_seconds() * 1e3},
                   {"rejected", s.rejected},
                   {"missed", s.missed}});
  }
  return all;
}

std::string meters(const nlohmann::json& value) {
  return value.is_number() ? fmt::format("{:.2f} m", value.get<double>()) : "-";
}

/// Empty where nothing was measured.
std::string pose_error_in_words(const nlohmann::json& card) {
  const nlohmann::json pose = card.value("localization", nlohmann::json());
  if (!pose.is_object() || !pose["rms_m"].is_number()) return "";
  const std::string heading =
      pose["rms_rad"].is_number() ? fmt::format(" and {:.4f} rad", pose["rms_rad"].get<double>()) : "";
  return fmt::format(
      "Localization off by {:.3f} m on average, {:.3f} m{} rms, {:.3f} m at most ({} poses).\n",
      pose["mean_m"].get<double>(), pose["rms_m"].get<double>(), heading, pose["max_m"].get<double>(),
      pose["poses"].get<std::uint32_t>());
}

/// How close the robot came to people, and how it moved.
std::string company_in_words(const nlohmann::json& card) {
  const auto value = [&](const char* key) { return card[key].is_number() ? card[key].get<double>() : 0.0; };
  return fmt::format(
             "Closest to a person {} (boundary to boundary), collision index at most {:.2f}, above 0.54 for "
             "{:.1f} % of the time.\n",
             meters(card["closest_person_m"]), value("max_collision_index"),
             100.0 * value("share_ci_above_0_54")) +
         fmt::format("Mean speed {:.2f} m/s, RMS jerk {:.2f} m/s^3.\n", value("mean_speed_mps"),
                     value("rms_jerk_mps3"));
}

/// Who hit whom, and what could have been done; empty without a contact with somebody.
std::string contacts_of(const nlohmann::json& card) {
  const std::string lines = contacts_in_words(card, "  ");
  if (lines.empty()) return "";
  return std::string(card.value("possible", true)
                         ? "Contacts:\n"
                         : "Success was not possible for people who walk as they did. Contacts:\n") +
         lines;
}

/// Of a run that nobody drove.
std::string run_in_words(const nlohmann::json& card) {
  std::string text = fmt::format("Run over: {}", card.value("reason", ""));
  if (!card.contains("path_length_m")) return text + "; nobody told the truth, and nothing is scored.\n";
  text += fmt::format("; {} in {:.1f} s.\n", meters(card["path_length_m"]),
                      card["time_to_goal_s"].is_number() ? card["time_to_goal_s"].get<double>() : 0.0);
  if (card["closest_person_m"].is_number()) text += company_in_words(card);
  if (!card["localization"].is_object()) return text;
  const std::string error = pose_error_in_words(card);
  return text + (error.empty() ? "The localization gave no pose that could be compared.\n" : error);
}

std::string outcome_in_words(const nlohmann::json& card) {
  if (card.contains("reached") && card["reached"].is_null())
    return "Not known whether the goal was reached: " + card.value("reason", "");
  const bool is_reached = card.value("reached", false);
  const auto time = card.find("time_to_goal_s");
  const double seconds = time != card.end() && time->is_number() ? time->get<double>() : 0.0;
  if (!card.value("stayed", false)) {
    return is_reached ? fmt::format("Goal reached in {:.1f} s", seconds)
                      : fmt::format("Goal not reached: {}", card.value("reason", "no score card"));
  }
  if (!card.contains("collisions")) return "No goal was set: " + card.value("reason", "");
  const std::string outcome =
      is_reached ? "Last goal reached" : "Last goal not reached: " + card.value("reason", "");
  return fmt::format("{}; the whole run since the first, {:.1f} s", outcome, seconds);
}

}  // namespace

const CallbackStatistics& planner_cycle(const std::vector<CallbackStatistics>& statistics,
                                        const std::string& component) {
  std::string others;
  for (const CallbackStatistics& s : statistics) {
    if (s.component != component) continue;
    if (s.callback == "control_cycle") return s;
    others.append(others.empty() ? "" : ", ").append(s.callback);
  }
  throw std::runtime_error("the planner's time is that of the callback control_cycle, which " + component +
                           " does not have; it has: " + (others.empty() ? "none" : others));
}

nlohmann::json path_json(const std::vector<PathPoint>& path, const bandwagon_msgs::msg::ScoreCard& card) {
  const auto rounded = [](double value) { return std::round(value * 1e3) / 1e3; };
  const Time began = from_stamp(card.header().stamp()) - Duration::seconds(card.time_to_goal_s());
  constexpr double kPeriod = 0.5;  // [s]: at 1 m/s every half metre
  double next = 0.0;
  nlohmann::json points = nlohmann::json::array();
  for (const auto& [time, X_MB] : path) {
    const double t = rounded((time - began).to_seconds());
    if (t < next) continue;
    next = kPeriod * (std::floor(t / kPeriod) + 1.0);
    points.push_back({t, rounded(X_MB.x), rounded(X_MB.y), rounded(X_MB.theta)});
  }
  return points;
}

nlohmann::json card_json(const bandwagon_msgs::msg::ScoreCard& card) {
  return {{"reached", card.reached()},
          {"reason", card.reason()},
          {"time_to_goal_s", number(card.time_to_goal_s())},
          {"path_length_m", number(card.path_length_m())},
          {"distance_to_goal_m", number(card.distance_to_goal_m())},
          {"min_distance_m", number(card.min_distance_m())},
          {"closest_person_m", number(card.closest_person_m())},
          {"collisions", card.collisions()},
          {"collisions_at_speed", card.collisions_at_speed()},
          {"max_collision_index", number(card.max_collision_index())},
          {"max_collision_index_045", number(card.max_collision_index_045())},
          {"share_ci_above_0_54", number(card.share_ci_above_0_54())},
          {"share_ci_above_0_14", number(card.share_ci_above_0_14())},
          {"mean_speed_mps", number(card.mean_speed_mps())},
          {"rms_jerk_mps3", number(card.rms_jerk_mps3())},
          {"localization",
           {{"poses", card.localization_poses()},
            {"mean_m", number(card.localization_mean_m())},
            {"rms_m", number(card.localization_rms_m())},
            {"max_m", number(card.localization_max_m())},
            {"rms_rad", number(card.localization_rms_rad())}}}};
}

nlohmann::json to_json(const std::optional<bandwagon_msgs::msg::ScoreCard>& card, const RunFacts& facts,
                       const std::vector<CallbackStatistics>& statistics) {
  nlohmann::json json = {{"reached", false}};
  if (card) json = card_json(*card);
  const bool has_outcome = card && (card->finished() || (facts.stays && !card->reason().empty()));
  if (!has_outcome) json["reason"] = facts.end_reason;
  json["graph"] = facts.graph;
  json["seed"] = facts.seed;
  if (!facts.has_goal) json["has_goal"] = false;
  if (facts.stays) json["stayed"] = true;
  json["planner"] = planner_json(facts, statistics);
  json["realtime_factor"] = number(facts.realtime_factor);
  if (!facts.samples_sha256.empty()) json["samples_sha256"] = facts.samples_sha256;
  json["callbacks"] = callbacks_json(statistics);
  return json;
}

nlohmann::json robot_json(const RobotObservation& seen, const RunFacts& facts,
                          const std::vector<CallbackStatistics>& statistics) {
  nlohmann::json json = {{"reached", false}, {"reason", facts.end_reason}};
  if (seen.card) json = card_json(*seen.card);
  json["planner"] = planner_json(facts, statistics);
  if (seen.card) json["robot_path"] = path_json(seen.path, *seen.card);
  return json;
}

std::string in_words(const nlohmann::json& card) {
  if (!card.value("has_goal", true)) return run_in_words(card);
  std::string text = outcome_in_words(card);
  if (!card.contains("collisions")) return text + ".\n";
  if (card["collisions"].is_null()) return text + ". Nothing of the drive is in the recording.\n";
  if (card["reached"].is_null()) text += "; recorded";
  if (card.contains("robots"))
    text = fmt::format("{} robots, the worst of each figure. {}", card["robots"].size(), text);
  text += fmt::format(" over {}, {} contacts ({} while the robot moved).\n", meters(card["path_length_m"]),
                      card["collisions"].get<int>(), card["collisions_at_speed"].get<int>());
  text += contacts_of(card);
  text += company_in_words(card);
  text += pose_error_in_words(card);
  if (const auto planner = card.value("planner", nlohmann::json()); planner.is_object()) {
    text +=
        fmt::format("Planner {}: {} cycles, CPU median {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms.\n",
                    planner.value("name", ""), planner.value("cycles", 0), planner.value("median_ms", 0.0),
                    planner.value("p99_ms", 0.0), planner.value("max_ms", 0.0));
  }
  if (card.contains("realtime_factor") && card["realtime_factor"].is_number()) {
    text += fmt::format("Simulated at {:.1f} times real time.\n", card["realtime_factor"].get<double>());
  }
  return text;
}

}  // namespace bw
