// What the local planner tells of itself: diagnostics, its cycles, the stamps of its trajectory.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_neighbours.hpp"

namespace bw {
namespace {

// The picture in lock-step holds nothing measured: budget as the parameter says, no times.
TEST(LocalPlannerComponent, DiagnosticsTellPlannerAndWork) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  n.run(2.5, "parameters: {algorithm: teb, max_iterations: 77, max_cycle_time: 0.000001}");
  EXPECT_EQ(n.diagnostic_message, "following");
  EXPECT_EQ(n.diagnostics["planner"], "teb");
  EXPECT_EQ(n.diagnostics["candidates"], "1");
  EXPECT_EQ(n.diagnostics["iteration_budget"], "77");
  EXPECT_GT(std::stoi(n.diagnostics["iterations"]), 0);
  EXPECT_FALSE(n.diagnostics.contains("cycle_p95_ms"));
  EXPECT_FALSE(n.diagnostics.contains("overruns"));
}

// One message a cycle, at 10 Hz: idle until it is told at 1 s, following until 2 s, braking and idle from
// there on. What only a real clock could tell is left open; half of the period is what the parameters leave
// to a cycle.
TEST(LocalPlannerComponent, TellsOfEveryCycle) {
  Neighbours n;
  n.requests = {{50, FollowRequest_Constants::FOLLOW}, {100, FollowRequest_Constants::STOP}};
  n.run(3.0, "parameters: {algorithm: eteb, max_iterations: 77}");
  EXPECT_NEAR(static_cast<double>(n.cycles.size()), 30.0, 1.0);
  for (const PlannerCycle& cycle : n.cycles) {
    const double t = seconds_since_start(from_stamp(cycle.header().stamp()));
    const bool follows = t > 1.05 && t < 2.0;
    EXPECT_EQ(cycle.header().frame_id(), "odom");
    EXPECT_EQ(cycle.planner(), "eteb");
    EXPECT_EQ(cycle.iteration_budget(), 77U);
    EXPECT_TRUE(std::isnan(cycle.duration_ms()));
    EXPECT_EQ(cycle.budget_ms(), 50.0);
    EXPECT_EQ(cycle.period_ms(), 100.0);
    EXPECT_FALSE(cycle.class_switched());
    if (follows || t < 0.95 || t > 2.05) {
      EXPECT_EQ(cycle.status(), follows ? PlannerCycle_Constants::OK : PlannerCycle_Constants::IDLE) << t;
      EXPECT_EQ(cycle.number_of_candidates(), follows ? 1U : 0U) << t;
      EXPECT_EQ(std::isnan(cycle.chosen_cost()), !follows) << t;
      EXPECT_EQ(cycle.chosen_label().empty(), !follows) << t;
      EXPECT_EQ(cycle.iterations() > 0, follows) << t;
    }
  }
}

// 3 m from rest with 1 m/s and 1 m/s^2 take 4 s, and no less than 3.
TEST(LocalPlannerComponent, PosesOfTheTrajectoryAreStampedWithWhenTheRobotIsThere) {
  Neighbours n;
  n.requests = {{5, FollowRequest_Constants::FOLLOW}};
  n.run(0.35);
  const auto& poses = n.plan.poses();
  ASSERT_GE(poses.size(), 3U);
  const Time start = from_stamp(n.plan.header().stamp());
  EXPECT_EQ(from_stamp(poses.front().header().stamp()), start);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double dt =
        (from_stamp(poses[i].header().stamp()) - from_stamp(poses[i - 1].header().stamp())).to_seconds();
    const double distance =
        (from_pose(poses[i].pose()).position() - from_pose(poses[i - 1].pose()).position()).norm();
    ASSERT_GT(dt, 0.0) << i;
    EXPECT_LT(distance / dt, 1.1) << i;  // the band's limits are soft
  }
  EXPECT_GT((from_stamp(poses.back().header().stamp()) - start).to_seconds(), 3.0);
}

// On the wall clock the same component has workers and a budget in time. The run ends when its figures came.
TEST(LocalPlannerComponent, OnTheWallClockDiagnosticsTellTimesToo) {
  Neighbours n;
  n.requests = {{0, FollowRequest_Constants::FOLLOW}};
  const auto path = std::filesystem::path(testing::TempDir()) / "local_planner_wall.yaml";
  std::ofstream(path) << "components: {local_planner: {parameters: {algorithm: teb, threads: 3, "
                         "max_cycle_time: 0.000001, max_iterations: 50}}}";
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>([&n](bw::Setup& setup) {
                     n.configure(setup);
                     setup.every(Duration::milliseconds(50), "until_seen",
                                 [&n, finish = setup.finish_run()](const Tick&) {
                                   if (n.diagnostics.contains("overruns") &&
                                       n.diagnostics["iteration_budget"] == "10")
                                     finish(true, "seen");
                                 });
                   })});
  Host host(load_graph(path, {}), {.clock = ClockMode::wall}, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(60));
  EXPECT_EQ(end.reason, "seen");
  EXPECT_GT(std::stod(n.diagnostics["cycle_p95_ms"]), 0.0);
  ASSERT_FALSE(n.cycles.empty());
  EXPECT_GT(n.cycles.back().duration_ms(), 0.0);
  EXPECT_EQ(n.cycles.back().budget_ms(), 0.001);
  // A microsecond has room for no iteration: the floor of the budget.
  EXPECT_EQ(n.diagnostics["iteration_budget"], "10");
}

}  // namespace
}  // namespace bw
