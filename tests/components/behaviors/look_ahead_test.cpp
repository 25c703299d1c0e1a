// What counts as a contact of the motion's own making. A disc of 0.3 m drives from x = 0 to 2 in 2 s, or
// stands.
#include "components/behaviors/look_ahead.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

const std::vector<TrajectoryPoint> kDrive{{0.0, {0, 0, 0}, {1, 0}}, {2.0, {2, 0, 0}, {1, 0}}};
const std::vector<TrajectoryPoint> kStand{{0.0, {0, 0, 0}, {}}, {2.0, {0, 0, 0}, {}}};

PlanningProblem nothing() { return {.footprint = {.radius = 0.3}}; }

TEST(BringsContact, OnlyWithWhatIsReachedWithinItsTime) {
  PlanningProblem problem = nothing();
  EXPECT_FALSE(brings_contact(kDrive, kStand, 0.0, problem));
  problem.obstacles.points = {{2.4, 0.0}, {1.0, 0.35}};
  EXPECT_FALSE(brings_contact(kDrive, kStand, 0.0, problem));
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.06, problem)) << "passed at 0.05 m";
  problem.obstacles = {.discs = {{{1.0, 0.5}, 0.25}}};
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.0, problem));
  problem.obstacles = {.segments = {{{1.0, -3.0}, {1.0, 3.0}}}};
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.0, problem));
  EXPECT_FALSE(brings_contact(kStand, kStand, 0.0, problem));
}

TEST(BringsContact, NotWhenStandingBringsItAsSoon) {
  PlanningProblem problem = nothing();
  Mover mover;
  mover.position = {0.0, -2.0};
  mover.velocity = {0.0, 1.0};  // at the robot after 1.4 s, if it stands
  problem.movers = {mover};
  EXPECT_FALSE(brings_contact(kStand, kStand, 0.0, problem));
  EXPECT_FALSE(brings_contact(kDrive, kStand, 0.0, problem)) << "it is away by then";
  problem.movers[0].position = {1.0, -1.0};  // crosses the path at 1 s, where the robot is at 1 s
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.0, problem));
}

TEST(BringsContact, OfWhatIsTooNearAlreadyOnlyWhenItGetsNearer) {
  PlanningProblem problem = nothing();
  problem.obstacles.points = {{-0.2, 0.0}};
  EXPECT_FALSE(brings_contact(kDrive, kStand, 0.0, problem));
  problem.obstacles.points = {{0.2, 0.0}};
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.0, problem));
  problem.obstacles.points = {{-0.2, 0.0}, {1.0, 0.0}};
  EXPECT_TRUE(brings_contact(kDrive, kStand, 0.0, problem)) << "the second one is a contact of its own";
}

}  // namespace
}  // namespace bw
