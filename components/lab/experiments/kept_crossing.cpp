#include "components/lab/experiments/kept_crossing.hpp"

#include <limits>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::json;

Json to_json(const CrossingRun& run) {
  Json path = Json::array();
  for (const TimedPosition& p : run.path) path.push_back({p.time, p.position.x(), p.position.y()});
  return {{"seed", run.seed},
          {"a", static_cast<int>(run.passing_a)},
          {"b", static_cast<int>(run.passing_b)},
          {"name", run.episode.name},
          {"success", run.episode.success},
          {"collision", run.episode.collision},
          {"collision_at_speed", run.episode.collision_at_speed},
          {"time", run.episode.time},
          {"min_clearance", run.episode.min_clearance},  // null: nobody was near
          {"max_collision_index", run.episode.max_collision_index},
          {"rms_jerk", run.episode.rms_jerk},
          {"not_ok", run.episode.not_ok},
          {"path", std::move(path)}};
}

CrossingRun run_of(const Json& json) {
  CrossingRun run{.seed = json.at("seed"),
                  .passing_a = static_cast<Passing>(json.at("a").get<int>()),
                  .passing_b = static_cast<Passing>(json.at("b").get<int>())};
  run.episode.name = json.at("name");
  run.episode.success = json.at("success");
  run.episode.collision = json.at("collision");
  run.episode.collision_at_speed = json.at("collision_at_speed");
  run.episode.time = json.at("time");
  const Json& clearance = json.at("min_clearance");
  run.episode.min_clearance =
      clearance.is_null() ? std::numeric_limits<double>::infinity() : clearance.get<double>();
  run.episode.max_collision_index = json.at("max_collision_index");
  run.episode.rms_jerk = json.at("rms_jerk");
  run.episode.not_ok = json.at("not_ok");
  for (const Json& p : json.at("path")) run.path.push_back({p.at(0), Vector2(p.at(1), p.at(2))});
  return run;
}

}  // namespace

CrossingResult kept_crossing(const Kept& kept, const std::string& name, const std::string& program,
                             const CrossingEntry& entry, const CrossingGeometry& geometry, int runs) {
  const std::string made_by =
      fmt::format("{}\n{} runs\nA {} {} B {} {}\n{} {}", program, runs, geometry.a.x(), geometry.a.y(),
                  geometry.b.x(), geometry.b.y(), entry.planner, Json(entry.set).dump());
  CrossingResult result{entry, {}};
  if (const std::optional<Json> found = kept.find(name, made_by)) {
    for (const Json& run : *found) result.runs.push_back(run_of(run));
    return result;
  }
  result = run_crossing(entry, geometry, runs);
  Json list = Json::array();
  for (CrossingRun& run : result.runs) {
    list.push_back(to_json(run));
    run = run_of(list.back());
  }
  kept.put(name, made_by, list);
  return result;
}

}  // namespace bw
