// The hallway suite driven twice with the same seeds: by follow_request, and with each path of the navigator
// sent as a goal of follow_path, a new one each second. Both are the same planner in the same crowd, so that
// success, time and jerk differ by what a crowd makes of small differences, and by no more.
//   BANDWAGON_PAIRS=20 build/release/bin/test_follow_path_pairs       seeds 1 to 20, both episodes: 40 pairs
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "components/evaluation/success.hpp"
#include "components/lab/evaluate/suite.hpp"
#include "components/program/drive.hpp"
#include "runtime/registry.hpp"
#include "tests/components/local_planner/follow_path_relay.hpp"

namespace bw {
namespace {

[[maybe_unused]] const bool registered =
    register_component("follow_path_relay", [] { return std::make_unique<FollowPathRelay>(); });

struct Drive {
  bool success = false;
  double time = 0.0;  ///< [s]
  double jerk = 0.0;  ///< [m/s^3]
};

/// With the relay between navigator and planner.
void put_relay_into(Graph& graph) {
  for (ComponentNode& node : graph.components) {
    if (node.name != "local_planner") continue;
    node.remaps.push_back({"follow_request", "relayed_request", node.where});
    node.remaps.push_back({"follow_status", "planner_status", node.where});
  }
  // The same goal for both: that of the navigator.
  for (const char* text : {"local_planner.goal_checker.xy_goal_tolerance=0.2",
                           "local_planner.goal_checker.yaw_goal_tolerance=0.3"})
    apply_override(graph, parse_override(text));
  ComponentNode relay{.name = "follow_path_relay", .type = "follow_path_relay"};
  relay.where = graph.components.front().where;
  graph.components.push_back(std::move(relay));
}

Drive drive_once(const Suite& suite, std::size_t episode, int seed, bool by_action) {
  Graph graph = suite.graph_of(episode);
  if (by_action) put_relay_into(graph);
  DriveSettings options;
  options.host.clock = ClockMode::lockstep;
  options.host.seed = static_cast<std::uint64_t>(seed);
  options.longest = Duration::seconds(suite.options.time_limit);
  const nlohmann::json card = drive(std::move(graph), options).json;
  return {.success = is_success(card["reached"], card["collisions"]),
          .time = card["time_to_goal_s"].is_number() ? card["time_to_goal_s"].get<double>() : 0.0,
          .jerk = card["rms_jerk_mps3"].get<double>()};
}

/// Of the differences of pairs.
struct Difference {
  int count = 0;
  double sum = 0.0;
  double squares = 0.0;
  void add(double d) {
    ++count;
    sum += d;
    squares += d * d;
  }
  double mean() const { return sum / count; }
  double standard_error() const { return std::sqrt((squares / count - mean() * mean()) / (count - 1)); }
};

int seeds() {
  const char* asked = std::getenv("BANDWAGON_PAIRS");
  return asked == nullptr ? 1 : std::max(1, std::atoi(asked));
}

TEST(FollowPathPairs, DriveTheHallwayAsWellAsTheNativeWay) {
  const Suite suite = load_suite(std::string(BANDWAGON_SOURCE_DIR) + "/config/suites/hallway.yaml");
  int native_successes = 0, action_successes = 0, pairs = 0;
  Difference time, jerk;
  for (std::size_t episode = 0; episode < suite.options.episodes.size(); ++episode) {
    for (int seed = 1; seed <= seeds(); ++seed) {
      const Drive native = drive_once(suite, episode, seed, false);
      const Drive action = drive_once(suite, episode, seed, true);
      ++pairs;
      native_successes += native.success ? 1 : 0;
      action_successes += action.success ? 1 : 0;
      std::cout << fmt::format(
          "{:5} {:2}  native {} {:.2f} s {:.3f} m/s^3   follow_path {} {:.2f} s {:.3f} m/s^3\n",
          suite.options.episodes[episode].name, seed, native.success, native.time, native.jerk,
          action.success, action.time, action.jerk);
      if (!native.success || !action.success) continue;
      time.add(action.time - native.time);
      jerk.add(action.jerk - native.jerk);
    }
  }
  ASSERT_GE(time.count, 2);
  EXPECT_GT(FollowPathRelay::goals_taken, 15 * pairs) << "a path each second of 20 s was a goal";
  std::cout << fmt::format(
      "{} pairs: success {} native, {} follow_path; follow_path minus native: {:+.2f} +- {:.2f} s, {:+.3f} +- {:.3f} "
      "m/s^3 (standard errors)\n",
      pairs, native_successes, action_successes, time.mean(), time.standard_error(), jerk.mean(),
      jerk.standard_error());
  // Of few pairs only what is plainly worse shows: one lost drive, and a mean beyond a tenth of 22 s and a fifth of 1.5
  // m/s^3, of which two pairs tell no more than 0.13.
  EXPECT_GE(action_successes, native_successes - 1);
  const bool is_full = pairs >= 40;
  EXPECT_LE(std::abs(time.mean()), is_full ? 3.0 * time.standard_error() : 2.2);
  EXPECT_LE(std::abs(jerk.mean()), is_full ? 3.0 * jerk.standard_error() : 0.3);
}

}  // namespace
}  // namespace bw
