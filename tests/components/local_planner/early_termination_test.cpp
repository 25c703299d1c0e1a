// Bands that cannot win are left early: what is driven comes out as if nobody else were there.
#include "components/local_planner/teb/early_termination.hpp"

#include <gtest/gtest.h>

#include "components/local_planner/teb/band_selection.hpp"
#include "components/local_planner/teb/band_solver.hpp"

namespace bw::teb {
namespace {

constexpr int kPlenty = 1000;  // iterations

// 6 m ahead, a wide disc left of the path: round it is far, past it is not.
struct AroundADisc {
  PlanningProblem problem;
  ObstacleField field;
  BandOptions options;
  DrivingOptions driving;

  AroundADisc() {
    problem.plan = {{0.0, 0.0, 0.0}, {6.0, 0.0, 0.0}};
    problem.obstacles.discs = {{{3.0, 1.6}, 1.2}};
    field = field_of(problem.obstacles, {}, {0.0, 0.0}, problem.footprint);
  }

  BandCandidate on_side(double y) const {
    return {.band = band_along({{0.0, 0.0, 0.0}, {3.0, y, 0.0}, {6.0, 0.0, 0.0}}, problem.pose,
                               problem.limits, options)};
  }
  BandCandidate kept(BandCandidate candidate, bool driven) const {
    improve(candidate, problem, field, options, driving, {.max_iterations = kPlenty});
    candidate.kept = candidate.settled = true;
    candidate.driven = driven;
    candidate.report = {};
    return candidate;
  }
  BandReport alone(BandCandidate candidate) const {
    candidate.report = {};
    improve(candidate, problem, field, options, driving, {.max_iterations = kPlenty});
    return candidate.report;
  }
  int improve_both(std::vector<BandCandidate>& candidates, bool terminates_losers) const {
    return improve_all(candidates, problem, field, options, driving, {terminates_losers, 0.95}, kPlenty);
  }
};

TEST(EarlyTermination, WithoutItEveryBandIsSolvedAsIfAlone) {
  const AroundADisc scene;
  std::vector<BandCandidate> candidates{scene.on_side(3.4), scene.on_side(-0.1)};
  const std::vector<BandReport> alone{scene.alone(candidates[0]), scene.alone(candidates[1])};
  EXPECT_EQ(scene.improve_both(candidates, false), alone[0].iterations + alone[1].iterations);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(candidates[i].report.cost, alone[i].cost);
}

TEST(EarlyTermination, TheBestFirstPlanIsFinishedTheOtherAfterItsFirstSolve) {
  const AroundADisc scene;
  for (const Solver solver : {Solver::ceres, Solver::banded}) {
    AroundADisc by = scene;
    by.options.solver = solver;
    std::vector<BandCandidate> candidates{by.on_side(3.4), by.on_side(-0.1)};
    const BandReport left = by.alone(candidates[0]), right = by.alone(candidates[1]);
    ASSERT_LT(right.cost, left.cost);
    by.improve_both(candidates, true);
    EXPECT_EQ(candidates[1].report.cost, right.cost);
    EXPECT_EQ(candidates[1].report.iterations, right.iterations);
    EXPECT_LE(candidates[0].report.iterations, by.options.no_inner_iterations);
    EXPECT_TRUE(candidates[0].report.usable);
  }
}

TEST(EarlyTermination, AKeptBandThatLosesEndsEarly) {
  const AroundADisc scene;
  for (const Solver solver : {Solver::ceres, Solver::banded}) {
    AroundADisc by = scene;
    by.options.solver = solver;
    by.options.function_tolerance = 0.0;  // nothing else ends a solve
    std::vector<BandCandidate> candidates{by.kept(by.on_side(3.4), false), by.kept(by.on_side(-0.1), true)};
    const BandReport left = by.alone(candidates[0]), right = by.alone(candidates[1]);
    by.improve_both(candidates, true);
    EXPECT_EQ(candidates[1].report.cost, right.cost);
    EXPECT_EQ(candidates[1].report.iterations, right.iterations);
    EXPECT_LT(candidates[0].report.iterations, left.iterations);
    EXPECT_GE(candidates[0].report.iterations, SolveLimits::kFewest);
    EXPECT_GE(candidates[0].report.cost, left.cost);
  }
}

// The driven band leads through the disc now: nobody is compared with it.
TEST(EarlyTermination, WithADrivenBandThatIsNotFreeNobodyLoses) {
  AroundADisc scene;
  std::vector<BandCandidate> candidates{scene.kept(scene.on_side(3.4), false),
                                        scene.kept(scene.on_side(-0.1), true)};
  scene.driving.feasibility_margin = 0.35;  // more than the band keeps
  scene.driving.feasibility_check_time = 100.0;
  const BandReport left = scene.alone(candidates[0]);
  scene.improve_both(candidates, true);
  ASSERT_FALSE(candidates[1].safety.free);
  EXPECT_EQ(candidates[0].report.cost, left.cost);
  EXPECT_EQ(candidates[0].report.iterations, left.iterations);
}

/// The dearer one along the plan comes first: what the other comes to does not decide whether it is finished.
TEST(EarlyTermination, TheBandAlongThePlanIsFinishedInAFirstPlan) {
  const AroundADisc scene;
  std::vector<BandCandidate> candidates{scene.on_side(3.4), scene.on_side(-0.1)};
  candidates[0].along_plan = true;
  const BandReport left = scene.alone(candidates[0]);
  scene.improve_both(candidates, true);
  EXPECT_TRUE(candidates[0].report.finished);
  EXPECT_EQ(candidates[0].report.cost, left.cost);
  EXPECT_TRUE(candidates[1].report.finished);
}

TEST(Select, AnUnfinishedBandIsNotRankedBesideAFinishedOne) {
  std::vector<BandCandidate> candidates(2);
  for (BandCandidate& candidate : candidates) candidate.report.usable = candidate.safety.free = true;
  candidates[0].cost = 1.0;
  candidates[1].cost = 2.0;
  candidates[1].report.finished = true;
  EXPECT_EQ(select(candidates, {}, 1.0), 1U);
  candidates[1].safety.free = false;  // but one that is free comes before one that is not
  EXPECT_EQ(select(candidates, {}, 1.0), 0U);
}

/// 6 s in intervals of 0.25 s cost as many of dt_ref = 0.3 s would: 0.3 * 6, not 24 * 0.25^2 = 1.5.
TEST(BandReport, TimeCountsAtTheReferenceInterval) {
  const AroundADisc scene;
  Band band;
  for (int i = 0; i <= 24; ++i) band.poses.push_back({0.25 * i, 0.0, 0.0, i < 24 ? 0.25 : 0.0});
  BandOptions options;
  options.weights = {.time = 1.0,
                     .kinematics_nh = 0.0,
                     .forward_drive = 0.0,
                     .max_vel_x = 0.0,
                     .max_vel_theta = 0.0,
                     .acc_lim_x = 0.0,
                     .acc_lim_theta = 0.0,
                     .obstacle = 0.0,
                     .inflation = 0.0};
  const BandScene at{scene.problem.limits, {}, true, &scene.field};
  EXPECT_NEAR(optimize(band, at, options, 0).cost, 0.3 * 6.0, 1e-9);
}

TEST(WorthKeeping, OneBandTooManyStaysAsASpare) {
  std::vector<BandCandidate> candidates(5);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].band.poses = {{0, 0, 0, 1.0}, {1, 0, 0, 0.0}};
    candidates[i].cost = 10.0 + static_cast<double>(i);
    candidates[i].report.usable = candidates[i].safety.free = true;
  }
  const std::vector<BandCandidate> kept = worth_keeping(candidates, 2, {.max_kept = 3, .max_spare = 1});
  ASSERT_EQ(kept.size(), 4U);
  EXPECT_EQ(kept[0].cost, 12.0);  // the driven one, then by cost
  EXPECT_EQ(kept[3].cost, 13.0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(kept[i].spare, i == 3);
  candidates[3].safety.free = candidates[4].safety.free = false;
  EXPECT_EQ(worth_keeping(candidates, 2, {.max_kept = 3, .max_spare = 1}).size(),
            3U);                                           // the spare is not free
  EXPECT_EQ(worth_keeping(candidates, 2, {}).size(), 1U);  // of a planner of one band
}

}  // namespace
}  // namespace bw::teb
