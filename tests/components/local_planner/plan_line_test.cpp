#include "components/local_planner/plan_line.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

// 4 m along x, then 3 m along y.
const std::vector<Pose2> kCorner = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}};

TEST(PlanLine, TellsHowFarAlongAndHowFarBeside) {
  const PlanLine line(kCorner, {0, 0}, 0.5);
  EXPECT_DOUBLE_EQ(line.length(), 7.0);
  const PlanLine::Projection before = line.nearest({1.0, -0.5}, 0.0, 7.0);
  EXPECT_DOUBLE_EQ(before.along, 1.0);
  EXPECT_DOUBLE_EQ(before.beside, 0.5);
  const PlanLine::Projection after = line.nearest({4.2, 2.0}, 0.0, 7.0);
  EXPECT_DOUBLE_EQ(after.along, 6.0);
  EXPECT_NEAR(after.beside, 0.2, 1e-12);
}

TEST(PlanLine, LooksAtTheStretchThatIsAskedForAlone) {
  const PlanLine line(kCorner, {0, 0}, 0.5);
  // (3.8, 3) is 0.2 m beside the end and 3 m beside the first leg.
  const PlanLine::Projection projection = line.nearest({3.8, 3.0}, 0.0, 4.0);
  EXPECT_DOUBLE_EQ(projection.along, 3.8);
  EXPECT_DOUBLE_EQ(projection.beside, 3.0);
  EXPECT_DOUBLE_EQ(line.nearest({1.0, 0.0}, 2.5, 7.0).beside, 1.5);
  EXPECT_DOUBLE_EQ(line.nearest({1.0, 0.0}, -9.0, -8.0).beside, 1.0) << "nothing but its beginning";
}

TEST(PlanLine, GoesStraightOnAfterItsEnd) {
  const PlanLine line(kCorner, {0, 0}, 0.5);
  EXPECT_DOUBLE_EQ(line.nearest({4.1, 3.4}, 0.0, 7.5).along, 7.4);
  EXPECT_NEAR(line.nearest({4.1, 3.4}, 0.0, 7.5).beside, 0.1, 1e-12);
  EXPECT_NEAR(line.nearest({4.0, 3.4}, 0.0, 7.0).beside, 0.4, 1e-12) << "but not for who asks for the plan";
  EXPECT_TRUE(line.at(7.4).isApprox(Vector2(4.0, 3.4)));
  EXPECT_TRUE(line.at(99.0).isApprox(Vector2(4.0, 3.5)));
  EXPECT_TRUE(line.at(5.0).isApprox(Vector2(4.0, 1.0)));
}

TEST(PlanLine, OfOnePlaceIsTheWayThere) {
  const PlanLine line({{3, 4, 0}, {3, 4, 0}}, {0, 0}, 0.5);
  EXPECT_DOUBLE_EQ(line.length(), 5.0);
  EXPECT_TRUE(line.at(2.5).isApprox(Vector2(1.5, 2.0)));
  const PlanLine here({{1, 1, 0.5}}, {1, 1}, 0.5);
  EXPECT_DOUBLE_EQ(here.length(), 0.0);
  EXPECT_DOUBLE_EQ(here.nearest({1, 2}, 0.0, 0.0).beside, 1.0);
}

TEST(PlanLine, AgreesWithFineSampling) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    std::vector<Pose2> plan;
    for (int k = 0; k < 6; ++k) {
      const double x = random.uniform(-3, 3);
      plan.push_back({x, random.uniform(-3, 3), 0.0});
    }
    const PlanLine line(plan, {0, 0}, 0.3);
    const double px = random.uniform(-4, 4);
    const Vector2 point(px, random.uniform(-4, 4));
    const double from = random.uniform(0.0, line.length());
    const double to = random.uniform(from, line.length() + 0.3);
    double least = INFINITY;
    for (double along = from; along <= to; along += 0.002)
      least = std::min(least, (line.at(along) - point).norm());
    EXPECT_NEAR(line.nearest(point, from, to).beside, least, 0.003) << i;
  }
}

}  // namespace
}  // namespace bw
