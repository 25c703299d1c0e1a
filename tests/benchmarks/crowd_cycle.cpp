// What a whole cycle of a planner costs with 40 people around: process CPU of every call of closed drives
// through a hall in which they walk to and fro and react to nobody. Prints median, p99 and most, and how the
// drives went.
//   crowd_cycle [--people N] [--drives N] [--rectangle] [--first] [PLANNER...]
// --rectangle: a robot of 0.51 x 0.43 m, not a disc; --first: first plans alone, with what they cost.
// Asked: p99 of eteb at most 10 ms. A measurement, not a test: it judges nothing.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

constexpr double kHalfWidth = 6.0;  // [m] of the hall, which is 18 m long
constexpr double kLength = 12.0;    // [m] to go
constexpr double kBeyond = 3.0;     // [m] of the hall behind start and goal
constexpr double kTimeout = 60.0;   // [s]
constexpr double kArrived = 0.3;    // [m]

double cpu_ms() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

PlanningProblem hall(int people, bool rectangle, std::uint64_t seed) {
  Random random(seed);
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.plan = {{0.0, 0.0, 0.0}, {kLength, 0.0, 0.0}};
  if (rectangle)
    problem.footprint = {0.334, {{-0.255, -0.215}, {0.255, -0.215}, {0.255, 0.215}, {-0.255, 0.215}}};
  const double left = -kBeyond - 0.5, right = kLength + kBeyond + 0.5, side = kHalfWidth + 0.5;
  problem.obstacles.segments = {{{left, -side}, {right, -side}},
                                {{right, -side}, {right, side}},
                                {{right, side}, {left, side}},
                                {{left, side}, {left, -side}}};
  while (static_cast<int>(problem.movers.size()) < people) {
    Mover mover;
    mover.id = static_cast<std::uint32_t>(problem.movers.size());
    mover.position = {random.uniform(-kBeyond, kLength + kBeyond), random.uniform(-kHalfWidth, kHalfWidth)};
    mover.velocity =
        random.uniform(0.3, 1.2) * direction(random.uniform(-std::numbers::pi, std::numbers::pi));
    if (mover.position.norm() > 1.5) problem.movers.push_back(mover);
  }
  return problem;
}

// Walkers turn at the walls.
void follow(PlanningProblem& problem, const PlanningResult& result) {
  const double period = problem.control_period;
  problem.twist = result.command;
  problem.pose = advance_exact(problem.pose, result.command, period);
  problem.now = problem.now + Duration::seconds(period);
  for (Mover& m : problem.movers) {
    m.position += period * m.velocity;
    const auto keep = [](double x, double low, double high, double& v) {
      if ((x < low && v < 0.0) || (x > high && v > 0.0)) v = -v;
    };
    keep(m.position.x(), -kBeyond, kLength + kBeyond, m.velocity.x());
    keep(m.position.y(), -kHalfWidth, kHalfWidth, m.velocity.y());
  }
}

struct Drives {
  int people = 40;
  int count = 10;
  bool rectangle = false;
  bool first_alone = false;
};

double chosen_cost(const PlanningResult& result) {
  for (const Candidate& c : result.candidates) {
    if (c.chosen) return c.cost;
  }
  return 0.0;
}

void measure_first(const std::string& planner_name, const Drives& drives) {
  std::vector<double> times, costs;
  for (int drive = 1; drive <= drives.count; ++drive) {
    const auto planner = make_planner(planner_name, {});
    const PlanningProblem problem = hall(drives.people, drives.rectangle, static_cast<std::uint64_t>(drive));
    const double before = cpu_ms();
    const PlanningResult result = planner->plan(problem);
    times.push_back(cpu_ms() - before);
    costs.push_back(chosen_cost(result));
  }
  std::printf("%-13s %d people, %d first plans: cost mean %.2f, median %.2f, most %.2f; median %.2f ms\n",
              planner_name.c_str(), drives.people, drives.count,
              std::accumulate(costs.begin(), costs.end(), 0.0) / drives.count, quantile(costs, 0.5),
              quantile(costs, 1.0), quantile(times, 0.5));
}

void measure(const std::string& planner_name, const Drives& drives) {
  std::vector<double> times;
  int arrived = 0, touched = 0;
  double driven = 0.0;
  for (int drive = 1; drive <= drives.count; ++drive) {
    const auto planner = make_planner(planner_name, {});
    PlanningProblem problem = hall(drives.people, drives.rectangle, static_cast<std::uint64_t>(drive));
    bool touches = false, is_there = false;
    for (double time = 0.0; time < kTimeout && !is_there; time += problem.control_period) {
      const double before = cpu_ms();
      const PlanningResult result = planner->plan(problem);
      times.push_back(cpu_ms() - before);
      follow(problem, result);
      touches =
          touches || gap_at(problem.pose, 0.0, problem.footprint, problem.obstacles, problem.movers) < 0.0;
      is_there = (problem.pose.position() - problem.plan.back().position()).norm() < kArrived;
      driven += problem.control_period / drives.count;
    }
    arrived += is_there;
    touched += touches;
  }
  std::printf(
      "%-13s %d people, %s, %d drives: %zu cycles, median %.2f ms, p90 %.2f, p99 %.2f, most %.2f; %d arrived, %d "
      "touched somebody, mean %.2f s\n",
      planner_name.c_str(), drives.people, drives.rectangle ? "rectangle" : "disc", drives.count,
      times.size(), quantile(times, 0.5), quantile(times, 0.9), quantile(times, 0.99), quantile(times, 1.0),
      arrived, touched, driven);
}

}  // namespace
}  // namespace bw

int main(int argc, char** argv) {
  bw::Drives drives;
  std::vector<std::string> planners;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if ((word == "--people" || word == "--drives") && i + 1 < argc) {
      (word == "--people" ? drives.people : drives.count) = std::atoi(argv[++i]);
    } else if (word == "--rectangle") {
      drives.rectangle = true;
    } else if (word == "--first") {
      drives.first_alone = true;
    } else {
      planners.push_back(word);
    }
  }
  if (planners.empty()) planners = {"teb", "teb_homotopy", "eteb"};
  for (const std::string& planner : planners) {
    drives.first_alone ? bw::measure_first(planner, drives) : bw::measure(planner, drives);
  }
}
