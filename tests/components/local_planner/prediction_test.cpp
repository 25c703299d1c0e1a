// How the band sees movers: where and how large (teb/theory.md 6.5, D10). Expected numbers are closed forms.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/teb/association.hpp"
#include "components/local_planner/teb/band_optimizer.hpp"

namespace bw::teb {
namespace {

const Footprint kRobot{.radius = 0.2};

Mover walker() {
  Mover m;
  m.position = {2.0, 0.0};
  m.velocity = {0.0, 1.0};
  m.radius = 0.3;
  return m;
}

Eigen::Matrix2d covariance(double xx, double xy, double yy) {
  Eigen::Matrix2d c;
  c << xx, xy, xy, yy;
  return c;
}

TEST(Prediction, TimeIndexedKeepsMovers) {
  const ObstacleField field = field_of({}, {walker()}, {0, 0}, kRobot);
  ASSERT_EQ(field.movers.size(), 1U);
  EXPECT_TRUE(field.statics.capsules().empty());
  EXPECT_DOUBLE_EQ(field.movers[0].radius, 0.3);
}

TEST(Prediction, PresentIsADiscWhereTheMoverStands) {
  const ObstacleField field = field_of({}, {walker()}, {0, 0}, kRobot, {.prediction = Prediction::present});
  EXPECT_TRUE(field.movers.empty());
  ASSERT_EQ(field.statics.size(), 1U);
  EXPECT_EQ(field.statics.capsules()[0].a, Vector2(2.0, 0.0));
  EXPECT_DOUBLE_EQ(field.statics.capsules()[0].radius, 0.3);
}

TEST(Prediction, DoubledAddsTheFuturePlaceGrownByItsUncertainty) {
  // 1.6 s at 1 m/s is 1.6 m away; 1 sigma at 0.1 m/s is 0.16 m.
  const ObstacleField field = field_of({}, {walker()}, {0, 0}, kRobot,
                                       {.prediction = Prediction::doubled,
                                        .uncertainty_factor = 1.0,
                                        .prediction_time = 1.6,
                                        .uncertainty_growth = 0.1});
  ASSERT_EQ(field.statics.size(), 2U);
  EXPECT_EQ(field.statics.capsules()[0].a, Vector2(2.0, 0.0));
  EXPECT_NEAR(field.statics.capsules()[1].a.y(), 1.6, 1e-12);
  EXPECT_NEAR(field.statics.capsules()[1].radius, 0.3 + 0.16, 1e-12);
}

TEST(Prediction, GrowthIsCapped) {
  const Uncertainty uncertainty{1.0, 0.1, 0.3};
  EXPECT_NEAR(uncertainty.at(walker(), 2.0), 0.2, 1e-12);
  EXPECT_NEAR(uncertainty.at(walker(), 10.0), 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(Uncertainty{}.at(walker(), 10.0), 0.0);
}

TEST(Prediction, CovariancesTakeThePlaceOfTheGrowth) {
  Mover m = walker();
  m.predictions = {{1.0, {2.0, 1.0}, covariance(0.01, 0.0, 0.04)}};
  EXPECT_NEAR((Uncertainty{2.0, 5.0, 1.0}.at(m, 1.0)), 0.4, 1e-12);
}

TEST(Prediction, SigmaIsTheRootOfTheLargerEigenvalueAndGrowsLinearly) {
  Mover m = walker();
  // Eigenvalues 0.05 +- 0.03: 0.08 and 0.02.
  m.predictions = {{0.0, {2.0, 0.0}, covariance(0.0, 0.0, 0.0)},
                   {2.0, {2.0, 2.0}, covariance(0.05, 0.03, 0.05)}};
  EXPECT_NEAR(m.sigma_at(2.0), std::sqrt(0.08), 1e-12);
  EXPECT_NEAR(m.sigma_at(1.0), std::sqrt(0.08) / 2.0, 1e-12);
  EXPECT_NEAR(m.sigma_at(4.0), 2.0 * std::sqrt(0.08), 1e-12);  // on at the last rate
  EXPECT_DOUBLE_EQ(walker().sigma_at(3.0), 0.0);
}

TEST(Prediction, InflationGrowsAlongTheBand) {
  // A band straight past a walker that stands 1 m aside: clearance terms see the grown disc at each pose's
  // time.
  Band band;
  for (int k = 0; k <= 10; ++k) band.poses.push_back({0.3 * k, 0.0, 0.0, k < 10 ? 0.3 : 0.0});
  Mover m = walker();
  m.position = {1.5, 1.0};
  m.velocity = {0.0, 0.0};
  BandOptions options;
  const auto unsure_at_pose_5 = [&](const PredictionOptions& prediction) {
    const ObstacleField field = field_of({}, {m}, {0, 0}, kRobot, prediction);
    return associate(band, field, options)[5].at_pose.at(0).unsure;
  };
  EXPECT_DOUBLE_EQ(unsure_at_pose_5({}), 0.0);
  EXPECT_NEAR(unsure_at_pose_5({.uncertainty_factor = 1.0, .uncertainty_growth = 0.1}), 0.1 * 1.5, 1e-12);
}

// A band straight past a walker 1 m aside, walking along with it: what it costs, not optimised.
BandReport report_of(const PredictionOptions& prediction) {
  Band band;
  for (int k = 0; k <= 10; ++k) band.poses.push_back({0.29 * k, 0.0, 0.0, k < 10 ? 0.29 : 0.0});
  Mover m = walker();
  m.position = {0.0, 1.0};
  m.velocity = {1.0, 0.0};
  const ObstacleField field = field_of({}, {m}, {0, 0}, kRobot, prediction);
  const Limits limits{.v_max = 1.5};
  return optimize(band, {limits, {1.0, 0.0}, true, &field}, BandOptions{}, 0);
}

TEST(Prediction, TheChoiceCountsItsShareOfTheGrowth) {
  // The gap is 0.5 m at every pose, 0.1 m less than the inflation distance; growth adds 0.1 m/s times the
  // pose's time, at most 0.3 m. So pose k, from 1 to 9, costs 2 (0.1 + share 0.029 k)^2.
  const auto expected = [](double share) {
    double cost = 0.0;
    for (int k = 1; k < 10; ++k) cost += 2.0 * std::pow(0.1 + share * std::min(0.3, 0.029 * k), 2);
    return cost;
  };
  for (const double share : {0.0, 0.5, 1.0}) {
    const BandReport report =
        report_of({.uncertainty_factor = 1.0, .uncertainty_in_choice = share, .uncertainty_growth = 0.1});
    EXPECT_NEAR(report.obstacle_cost, expected(share), 1e-9) << share;
  }
  EXPECT_DOUBLE_EQ(default_eteb_prediction().uncertainty_in_choice, 0.0);
  EXPECT_DOUBLE_EQ(report_of(default_eteb_prediction()).cost, report_of({}).cost);
}

TEST(Prediction, ASlowRobotKeepsWhatPeopleGainOnIt) {
  // 1.5 s (1 m/s - v_max): what one who walks at 1 m/s comes nearer by while the robot gets out of the way.
  const PredictionOptions eteb = default_eteb_prediction();
  EXPECT_DOUBLE_EQ(pedestrian_lead(eteb, 0.6), 0.6);
  EXPECT_DOUBLE_EQ(pedestrian_lead(eteb, 0.65), 0.525);
  EXPECT_DOUBLE_EQ(pedestrian_lead(eteb, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(pedestrian_lead(eteb, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(pedestrian_lead({}, 0.3), 0.0);  // of other planners than eteb
}

}  // namespace
}  // namespace bw::teb
