// What a possible person is to planners (local_planner/theory.md 7.10): at confidence 0 nothing, below 0.5
// never in the way, and with more confidence never nearer.
#include "components/model/mover_weight.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/homotopy/obstacle_bodies.hpp"
#include "components/local_planner/hrvo/neighbours.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/association.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw {
namespace {

constexpr std::uint64_t kSeed = 2817;
constexpr double kJustPossible = 0.499;
constexpr double kFarEnough = 1.2;  // [m] between centres

std::string scene_text(int scene) {
  return "seed " + std::to_string(kSeed) + " scene " + std::to_string(scene);
}

PlanningProblem with_confidence(PlanningProblem problem, double confidence) {
  for (Mover& mover : problem.movers) mover.confidence = confidence;
  return problem;
}

PlanningProblem without_movers(PlanningProblem problem) {
  problem.movers.clear();
  return problem;
}

// s(c) = min(1, max(0, c - 0.3) / 0.2), at its corners and half way.
TEST(MoverWeight, RisesToAPersonAtHalf) {
  EXPECT_EQ(presence(0.0), 0.0);
  EXPECT_EQ(presence(0.3), 0.0);
  EXPECT_NEAR(presence(0.4), 0.5, 1e-12);
  EXPECT_EQ(presence(0.5), 1.0);
  EXPECT_EQ(presence(1.0), 1.0);
  EXPECT_FALSE(is_confirmed(kJustPossible));
  EXPECT_TRUE(is_confirmed(0.5));
}

TEST(MoverWeight, WhatSaysNothingIsAPerson) {
  for (const double confidence : {std::nan(""), -0.01, 1.01, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(is_confirmed(confidence)) << confidence;
    EXPECT_EQ(presence(confidence), 1.0) << confidence;
  }
}

class AnyPlanner : public testing::TestWithParam<std::string_view> {
 protected:
  PlanningResult first_plan(const PlanningProblem& scene) const {
    return make_planner(GetParam(), {})->plan(scene);
  }
};
INSTANTIATE_TEST_SUITE_P(PossiblePeople, AnyPlanner, testing::ValuesIn(planner_names()),
                         [](const auto& planner) { return std::string(planner.param); });

// To the last bit.
TEST_P(AnyPlanner, ForgetsWhomNobodyBelievesIn) {
  Random random(kSeed);
  for (int i = 0; i < 8; ++i) {
    const PlanningProblem scene = random_scene(random);
    const PlanningResult without = first_plan(without_movers(scene));
    for (const double confidence : {0.0, kFurniture}) {
      EXPECT_EQ(difference(first_plan(with_confidence(scene, confidence)), without), "")
          << scene_text(i) << " confidence " << confidence;
    }
  }
}

// Those that know of no costs but distances to what they may not touch do not even see possible people.
TEST_P(AnyPlanner, FindsAWayWhereverThereIsOneWithoutPossiblePeople) {
  const bool is_band = GetParam().find("teb") != std::string_view::npos;
  Random random(kSeed);
  int paths = 0;
  for (int i = 0; i < 16; ++i) {
    const PlanningProblem scene = random_scene(random);
    const PlanningResult without = first_plan(without_movers(scene));
    const PlanningResult with = first_plan(with_confidence(scene, kJustPossible));
    if (!is_band) {
      EXPECT_EQ(difference(with, without), "") << scene_text(i);
    }
    if (without.status != PlanningStatus::ok || !without.reason.empty()) continue;
    ++paths;
    EXPECT_EQ(with.status, PlanningStatus::ok) << scene_text(i);
    EXPECT_EQ(with.reason, "") << scene_text(i);
  }
  EXPECT_GT(paths, 4) << "hardly a scene has a way at all";
}

TEST_P(AnyPlanner, CommutesWithMirroringAmongPossiblePeople) {
  Random random(kSeed);
  for (int i = 0; i < 6; ++i) {
    PlanningProblem scene = random_scene(random);
    for (Mover& mover : scene.movers) mover.confidence = random.uniform();
    const Twist2 command = first_plan(scene).command;
    const Twist2 mirror = first_plan(mirrored(scene)).command;
    EXPECT_NEAR(command.v, mirror.v, 1e-6) << scene_text(i);
    EXPECT_NEAR(command.omega, -mirror.omega, 1e-6) << scene_text(i);
  }
}

double smallest_distance(const PlanningResult& result, const Mover& mover) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < result.trajectory.size(); ++k) {
    const TrajectoryPoint& a = result.trajectory[k];
    const TrajectoryPoint& b = result.trajectory[k + 1];
    for (const double s : {0.0, 0.5, 1.0}) {
      const Vector2 robot = (1.0 - s) * a.pose.position() + s * b.pose.position();
      const double time = (1.0 - s) * a.time + s * b.time;
      smallest = std::min(smallest, (mover.position_at(time) - robot).norm());
    }
  }
  return smallest;
}

// Somebody stands or walks slowly beside a straight path. One solve of a band ends within its tolerance: 3
// cm. Both radii and the comfortable distance are 1.2 m: who is further away is far enough.
TEST_P(AnyPlanner, ComesNoNearerWithMoreConfidence) {
  Random random(kSeed);
  for (int i = 0; i < 12; ++i) {
    PlanningProblem scene;
    scene.now = Time::seconds(1.0);
    scene.twist = {0.6, 0.0};
    for (int k = 0; k <= 6; ++k) scene.plan.push_back({1.0 * k, 0.0, 0.0});
    Mover mover{.id = 1};
    mover.position = {random.uniform(1.5, 4.0), random.uniform(0.1, 1.2)};
    mover.velocity = {random.uniform(-0.2, 0.2), 0.0};
    double before = 0.0;
    std::string text;
    for (const double confidence : {0.0, 0.35, 0.4, 0.45, kJustPossible, 0.5, 0.75, 1.0}) {
      mover.confidence = confidence;
      scene.movers = {mover};
      const double distance = std::min(kFarEnough, smallest_distance(first_plan(scene), mover));
      text += " " + std::to_string(distance);
      EXPECT_GE(distance, before - 0.03) << scene_text(i) << " confidence " << confidence << text;
      before = std::max(before, distance);
    }
  }
}

constexpr std::array kRising{0.0, 0.2, 0.301, 0.35, 0.4, 0.45, kJustPossible, 0.5, 0.8, 1.0};

double clearance_cost(const PlanningProblem& scene, const teb::Band& band,
                      const teb::PredictionOptions& prediction) {
  const teb::BandOptions options;
  const teb::ObstacleField field =
      teb::field_of(scene.obstacles, scene.movers, scene.pose.position(), scene.footprint, prediction);
  const teb::ClearanceModel model(options, field.footprint, 1.0);
  double cost = 0.0;
  const std::vector<teb::PoseTerms> terms = associate(band, field, options);
  for (std::size_t k = 0; k + 1 < band.size(); ++k) {
    for (const auto* list : {&terms[k].at_pose, &terms[k].along_segment}) {
      for (const teb::ClearanceTerm& term : *list)
        cost += std::pow(
            evaluate_clearance(model, term,
                               teb::between(&band.poses[k].x, &band.poses[k + 1].x, term.fraction), nullptr),
            2);
    }
  }
  return cost;
}

TEST(PossiblePeople, CostABandNoLessWithMoreConfidence) {
  Random random(kSeed);
  int risen = 0;
  for (int i = 0; i < 60; ++i) {
    const PlanningProblem scene = random_scene(random);
    teb::Band band;
    for (int k = 0; k <= 18; ++k) band.poses.push_back({0.35 * k, random.uniform(-0.3, 0.3), 0.0, 0.35});
    for (const teb::Prediction prediction :
         {teb::Prediction::time_indexed, teb::Prediction::doubled, teb::Prediction::present}) {
      teb::PredictionOptions options = teb::default_eteb_prediction();
      options.prediction = prediction;
      double before = clearance_cost(without_movers(scene), band, options);
      for (const double confidence : kRising) {
        // Static discs cost a little differently from movers (D10): there the person is another thing.
        if (prediction != teb::Prediction::time_indexed && confidence >= kConfirmed) break;
        const double cost = clearance_cost(with_confidence(scene, confidence), band, options);
        EXPECT_GE(cost, before * (1.0 - 1e-12)) << scene_text(i) << " confidence " << confidence;
        if (confidence == 0.0) {
          EXPECT_EQ(cost, before) << scene_text(i);
        }
        risen += cost > before ? 1 : 0;
        before = cost;
      }
    }
  }
  EXPECT_GT(risen, 100);
}

TEST(PossiblePeople, TakeNoPlaceFromObstaclesOfABand) {
  PlanningProblem scene;
  for (int i = 0; i < 8; ++i) scene.obstacles.points.push_back({1.0 + 0.1 * i, 0.45});
  for (int i = 0; i < 12; ++i)
    scene.movers.push_back({.id = static_cast<std::uint32_t>(i), .position = {1.0, 0.2}, .confidence = 0.4});
  teb::Band band;
  for (int k = 0; k <= 8; ++k) band.poses.push_back({0.3 * k, 0.0, 0.0, 0.3});
  const teb::ObstacleField field = teb::field_of(scene.obstacles, scene.movers, {0.0, 0.0}, {.radius = 0.3});
  int statics = 0;
  for (const teb::PoseTerms& terms : associate(band, field, {})) {
    for (const teb::ClearanceTerm& term : terms.at_pose) statics += term.moving ? 0 : 1;
  }
  scene.movers.clear();
  const teb::ObstacleField alone = teb::field_of(scene.obstacles, {}, {0.0, 0.0}, {.radius = 0.3});
  int statics_alone = 0;
  for (const teb::PoseTerms& terms : associate(band, alone, {})) {
    for (const teb::ClearanceTerm& term : terms.at_pose) statics_alone += term.moving ? 0 : 1;
  }
  EXPECT_GT(statics_alone, 8);
  EXPECT_EQ(statics, statics_alone);
}

TEST(PossiblePeople, AreNoBodyNoConeAndNoGap) {
  Random random(kSeed);
  for (int i = 0; i < 60; ++i) {
    const PlanningProblem scene = random_scene(random);
    const PlanningProblem none = without_movers(scene);
    const homotopy::Course course{scene.pose.position(), scene.plan.back().position(), 0.3, 0.2, 1.0};
    const Pose2 somewhere{random.uniform(0.0, 6.0), random.uniform(-1.0, 1.0), 0.0};
    const double alone = gap_at(somewhere, 0.5, scene.footprint, scene.obstacles, {});
    std::size_t bodies = bodies_of(none.obstacles, {}, course, {.max_bodies = 100}).size();
    std::size_t cones = hrvo::neighbours(none, scene.plan.back().position(), {.max_neighbours = 100}).size();
    double gap = alone;
    for (const double confidence : kRising) {
      const PlanningProblem with = with_confidence(scene, confidence);
      const std::size_t bodies_now =
          bodies_of(with.obstacles, with.movers, course, {.max_bodies = 100}).size();
      const std::size_t cones_now =
          hrvo::neighbours(with, scene.plan.back().position(), {.max_neighbours = 100}).size();
      const double gap_now = gap_at(somewhere, 0.5, scene.footprint, with.obstacles, with.movers);
      if (confidence < kConfirmed) {
        EXPECT_EQ(bodies_now, bodies) << scene_text(i);
        EXPECT_EQ(cones_now, cones) << scene_text(i);
        EXPECT_EQ(gap_now, alone) << scene_text(i);
      }
      EXPECT_GE(bodies_now, bodies) << scene_text(i);
      EXPECT_GE(cones_now, cones) << scene_text(i);
      EXPECT_LE(gap_now, gap) << scene_text(i);
      bodies = bodies_now;
      cones = cones_now;
      gap = gap_now;
    }
  }
}

}  // namespace
}  // namespace bw
