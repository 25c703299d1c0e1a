// A monitor that cannot be beaten. Claims, whoever commands whatever, with the true world as judge:
//
//   seen         the robot itself never closes in on what its laser could see and touches it at more than 0.05 m/s
//   ahead        where its laser does not look, in the sector of travel: at no more than base_link and the rim at creep_speed together
//   turned into  by a rotation in place, where it does not look: the rim at no more than creep_speed
//   braked       who walks is touched by a robot that brakes with stop_deceleration, since reaction_time after the first sweep that showed
//                them where a stop would still have touched them; or at no more than 0.05 m/s of the robot
//                itself
//
// Premises: a position counts as seen when each sweep of the last second shows it (four of five beams), and
// of as long as the robot needs to stop from its top speed where that is longer, so that
// what is in a blind sector, behind something else, or thinner than three beams is not;
// stopping.reaction_time is at least the true one (motor control, wheels); sweeps say when they were taken,
// those of another clock with their delay; odometry is right. Told and not claimed: what is hidden, what a
// side sweeps on an arc, and who walks in sooner than the robot can stand.
//
// BANDWAGON_MONITOR_CASES=1000000 build/release/bin/test_monitor_property     as many, on all cores
// BANDWAGON_MONITOR_SEED=...                                               another beginning
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "components/safety/collision_monitor_options.hpp"
#include "tests/components/safety/monitor_simulation.hpp"

namespace bw::safety::test {
namespace {

constexpr double kClaim = 0.05;  // [m/s]
const double kCreep = CollisionMonitorOptions{}.sight.creep_speed;

/// How much faster than claimed, the worst of all [m/s].
double excess(const Result& result) {
  return std::max({result.worst - kClaim, result.ahead - 2.0 * kCreep, result.rotated_into - kCreep,
                   result.not_braked - kClaim});
}

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

struct Finding {
  std::uint64_t seed = 0;
  double excess = 0.0;
};

TEST(MonitorProperty, NoCommandMakesTheRobotTouchWhatItCouldSee) {
  const std::uint64_t cases = from_environment("BANDWAGON_MONITOR_CASES", 3'000);
  const std::uint64_t first = from_environment("BANDWAGON_MONITOR_SEED", 1);
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  std::vector<Finding> findings;
  double driven = 0.0;
  Result worst;
  const auto work = [&] {
    for (std::uint64_t i = next++; i < cases; i = next++) {
      const Result result = run(random_scene(first + i));
      const std::lock_guard lock(mutex);
      driven += result.driven;
      for (double Result::*kind : {&Result::worst, &Result::ahead, &Result::rotated_into, &Result::not_braked,
                                   &Result::swept, &Result::hidden, &Result::walked_in})
        worst.*kind = std::max(worst.*kind, result.*kind);
      if (excess(result) > 0.0) findings.push_back({first + i, excess(result)});
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  std::printf(
      "%llu cases from seed %llu, %.0f m driven, %zu touched faster than claimed; fastest [m/s]: seen %.3f, ahead %.3f, "
      "turned into %.3f, not braked for %.3f; swept %.3f, hidden %.3f, walked in %.3f\n",
      static_cast<unsigned long long>(cases), static_cast<unsigned long long>(first), driven, findings.size(),
      worst.worst, worst.ahead, worst.rotated_into, worst.not_braked, worst.swept, worst.hidden,
      worst.walked_in);
  std::fflush(stdout);
  std::ranges::sort(findings, {}, [](const Finding& finding) { return -finding.excess; });
  for (std::size_t i = 0; i < findings.size() && i < 3; ++i)
    std::printf("seed %llu by %.3f m/s, smaller: %s\n", static_cast<unsigned long long>(findings[i].seed),
                findings[i].excess, to_text(shrunk(random_scene(findings[i].seed), excess)).c_str());
  EXPECT_EQ(findings.size(), 0U);
}

// What the search has found, made smaller: one scene a line, its story in the line before.
TEST(MonitorProperty, ScenesThatBeatItOnceDoNotAnyMore) {
  std::ifstream file(std::string(BANDWAGON_SOURCE_DIR) + "/tests/components/safety/monitor_scenes.txt");
  ASSERT_TRUE(file.is_open());
  int scenes = 0;
  for (std::string line, story; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') {
      story = line;
      continue;
    }
    EXPECT_LE(excess(run(scene_of(line))), 0.0) << story;
    ++scenes;
  }
  std::printf("%d scenes\n", scenes);
}

}  // namespace
}  // namespace bw::safety::test
