#include "components/lab/bench/flows/flow_scenes.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/bench/scene_actors.hpp"

namespace bw {
namespace {

template <int kHundredths>
DriveScene flow(std::uint64_t seed) {
  return flow_scene(0.01 * kHundredths, seed);
}

constexpr SceneGate kEncounter{.most_stuck = 0.05, .no_contact_at_speed = true};

}  // namespace

const std::vector<FlowScene>& flow_scenes() {
  static const std::vector<FlowScene> kScenes = {
      {"F1", "flow of .05 per m^2", {.least_success = 0.99}, flow<5>},
      {"F2", "flow of .10 per m^2", {.least_success = 0.99}, flow<10>},
      {"F3", "flow of .20 per m^2", {.least_success = 0.99}, flow<20>},
      {"F4", "flow of .30 per m^2", {.least_success = 0.97}, flow<30>},
      {"F5", "flow of .50 per m^2", {.least_success = 0.90, .no_robot_closing = true}, flow<50>},
      {"G1", "door of 0.9 m", kEncounter, door_scene},
      {"G2", "blind corner", kEncounter, corner_scene},
      {"G3a", "row with a gap of 0.8 m", kEncounter, standing_row_scene},
      {"G3b", "row without a gap", kEncounter, closed_row_scene},
      {"G4", "overtaking in 1.8 m", kEncounter, overtaking_scene},
      {"G5a", "rusher", kEncounter, rusher_scene},
      {"G5b", "stop-and-go child", kEncounter, child_scene},
  };
  return kScenes;
}

std::vector<SceneSet> flow_sets(const std::vector<std::string>& names, int drives, std::uint64_t first) {
  std::vector<SceneSet> sets;
  for (const std::string& name : names)
    if (std::ranges::none_of(flow_scenes(),
                             [&](const FlowScene& s) { return std::string(s.name).starts_with(name); }))
      throw std::runtime_error(
          fmt::format("no scene begins with \"{}\": F1 to F5, G1, G2, G3a, G3b, G4, G5a, G5b", name));
  for (const FlowScene& scene : flow_scenes()) {
    if (std::ranges::none_of(
            names, [&](const std::string& name) { return std::string(scene.name).starts_with(name); }))
      continue;
    SceneSet set{.name = fmt::format("{}, {}", scene.name, scene.what),
                 .empty = scene.make(first),
                 .gate = scene.gate};
    set.empty.movers = std::make_shared<SceneActors>();
    for (int i = 0; i < drives; ++i) set.scenes.push_back(scene.make(first + static_cast<std::uint64_t>(i)));
    sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace bw
