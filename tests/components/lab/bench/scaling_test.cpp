// What stands along the path must not make a plan worse, however much of it there is.
#include "components/lab/bench/scaling.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace bw {
namespace {

// BANDWAGON_FULL_COUNTS asks for the 50 drives that the figures of the README come from.
int drives() { return std::getenv("BANDWAGON_FULL_COUNTS") != nullptr ? 50 : 2; }

class BandPlanners : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scaling, BandPlanners, testing::Values("teb", "teb_homotopy", "eteb"));

TEST_P(BandPlanners, ArriveHoweverManyPointsStandAlongTheCorridor) {
  for (const ScalingDrives& row : drive_corridors({200, 2000}, GetParam(), drives())) {
    EXPECT_EQ(row.arrived, row.drives) << row.count << " points";
    EXPECT_LE(row.slowest, 1.1) << row.count << " points";
  }
}

// The walls are further away than what costs: the plan is the same with 10 and with 10,000 points in them.
TEST(Scaling, CostsAsMuchWithTenThousandPointsAsWithTen) {
  const std::vector<ScalingRow> rows = measure_scaling(Crowding::points, {10, 1000, 10000}, "teb", 1);
  for (const ScalingRow& row : rows) {
    EXPECT_NEAR(row.cost, rows[0].cost, 1e-3) << row.count;
    EXPECT_NEAR(row.cost, row.cost_without_limits, 1e-3) << row.count;
    EXPECT_EQ(row.left_out, 0.0) << row.count;
  }
}

TEST(Scaling, AMoreCrowdedSceneIsTheSameSceneWithMoreInIt) {
  const PlanningProblem few = crowded(Crowding::points, 10, 5);
  const PlanningProblem many = crowded(Crowding::points, 300, 5);
  ASSERT_EQ(many.obstacles.points.size(), 300U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(few.obstacles.points[i], many.obstacles.points[i]);
  EXPECT_EQ(crowded(Crowding::hall, 500, 1).movers.size(), 500U);
  EXPECT_EQ(crowded(Crowding::corridor, 20, 1).obstacles.segments.size(), 2U);
}

}  // namespace
}  // namespace bw
