// Scenes that are absurd, degenerate or crowded: every planner answers each of them with a command that the
// base can follow and a status with its reason. BANDWAGON_FUZZ_SCENES sets how many each planner gets.
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "tests/components/local_planner/fuzz_scenes.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kSeed = 41;
constexpr double kRounding = 1e-9;  // of a value, and absolute below 1
constexpr std::size_t kMaxCandidates = 20;
constexpr std::size_t kMaxPoints = 1000;  // of a trajectory

int scenes_per_planner() {
  const char* asked = std::getenv("BANDWAGON_FUZZ_SCENES");
  return asked ? std::atoi(asked) : 1000;
}

bool at_most(double value, double limit) {
  return value <= limit + kRounding * std::max(1.0, std::abs(limit));
}

bool are_finite(const std::vector<TrajectoryPoint>& trajectory) {
  return std::all_of(trajectory.begin(), trajectory.end(), [](const TrajectoryPoint& p) {
    return std::isfinite(p.time) && is_finite(p.pose) && is_finite(p.twist);
  });
}

// Empty when `command` may follow `now`: it changes no faster than the limits allow, where slowing down may
// use `braking`, and it is in [low, high] or, from outside, no further away.
std::string excess(double command, double now, double low, double high, double acceleration, double braking,
                   double period) {
  const bool slows = std::abs(command) <= std::abs(now) && command * now >= 0.0;
  const double change = (slows ? std::max(acceleration, braking) : acceleration) * period;
  if (!at_most(std::abs(command - now), change + 1e-12 * std::abs(now))) return "changes too fast";
  if (!at_most(command, std::max(high, now)) || !at_most(std::min(low, now), command))
    return "outside its limits";
  return "";
}

std::string complaint_about(const PlanningResult& result, const FuzzScene& scene) {
  const PlanningProblem& p = scene.problem;
  const Limits& limits = p.limits;
  if (!is_finite(result.command)) return "the command is not finite";
  if (scene.unsound && result.status != PlanningStatus::bad_input) return "unsound, but not refused";
  if (result.status != PlanningStatus::ok && result.reason.empty()) return "no reason";
  if (result.status == PlanningStatus::no_plan && !p.plan.empty()) return "there is a plan";
  if (result.status == PlanningStatus::bad_input) {
    // Never faster than the robot is.
    if (is_finite(p.twist) && (std::abs(result.command.v) > std::abs(p.twist.v) ||
                               std::abs(result.command.omega) > std::abs(p.twist.omega)))
      return "refused, but speeds up";
    return result.iterations == 0 ? "" : "refused, but worked";
  }
  if (const std::string v = excess(result.command.v, p.twist.v, -limits.v_back_max, limits.v_max,
                                   limits.acc_max, limits.stop_deceleration, p.command_lead);
      !v.empty())
    return "speed " + v;
  if (const std::string omega = excess(result.command.omega, p.twist.omega, -limits.omega_max,
                                       limits.omega_max, limits.alpha_max, limits.alpha_max, p.command_lead);
      !omega.empty())
    return "turn rate " + omega;
  if (result.iterations < 0 || result.iterations > p.budget.max_iterations)
    return "more iterations than its budget";
  if (result.status == PlanningStatus::ok && result.trajectory.empty()) return "ok without a trajectory";
  if (result.candidates.size() > kMaxCandidates) return "too many candidates";
  if (!are_finite(result.trajectory) || result.trajectory.size() > kMaxPoints) return "bad trajectory";
  for (const Candidate& c : result.candidates) {
    if (!std::isfinite(c.cost)) return "a cost is not finite";
    if (!are_finite(c.trajectory) || c.trajectory.size() > kMaxPoints)
      return "bad trajectory of a candidate";
  }
  return "";
}

class EveryPlanner : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(PlannerFuzz, EveryPlanner, testing::ValuesIn(planner_names()),
                         [](const auto& planner) { return std::string(planner.param); });

TEST_P(EveryPlanner, AnswersAbsurdScenes) {
  Random random(kSeed);
  const auto planner = make_planner(GetParam(), {});
  const int count = scenes_per_planner();
  std::map<PlanningStatus, int> statuses;
  double slowest = 0.0, total = 0.0;
  std::string slowest_scene;
  FuzzScene scene;
  for (int i = 0; i < count; ++i) {
    const bool goes_on = i > 0 && !scene.unsound && random.uniform() < 0.3;
    if (!goes_on) scene = fuzz_scene(random);
    if (!goes_on && random.uniform() < 0.5) planner->reset();
    const std::string where =
        "seed " + std::to_string(kSeed) + " scene " + std::to_string(i) + ": " + scene.what;
    PlanningResult result;
    const std::clock_t begin = std::clock();
    ASSERT_NO_THROW(result = planner->plan(scene.problem)) << where;
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    total += seconds;
    if (seconds > slowest) {
      slowest = seconds;
      slowest_scene = where;
    }
    ++statuses[result.status];
    EXPECT_EQ(complaint_about(result, scene), "")
        << where << "; v " << scene.problem.twist.v << " -> " << result.command.v << ", omega "
        << scene.problem.twist.omega << " -> " << result.command.omega << ", '" << result.reason << "'";
    if (!is_finite(scene.problem.pose) || result.status == PlanningStatus::bad_input) continue;
    advance_scene(scene.problem, result.command);
  }
  EXPECT_GE(statuses.size(), 4U) << "some status never occurred";
  RecordProperty("scenes", count);
  RecordProperty("slowest_scene", slowest_scene);
  // For information: what the scenes cost here. Work is bounded by counts, which is what is tested.
  std::printf(
      "%s: %d scenes, seed %d: ok %d, no plan %d, bad input %d, infeasible %d; CPU mean %.2f ms, most %.1f "
      "ms (%s)\n",
      std::string(GetParam()).c_str(), count, static_cast<int>(kSeed), statuses[PlanningStatus::ok],
      statuses[PlanningStatus::no_plan], statuses[PlanningStatus::bad_input],
      statuses[PlanningStatus::infeasible], 1e3 * total / count, 1e3 * slowest, slowest_scene.c_str());
}

}  // namespace
}  // namespace bw
