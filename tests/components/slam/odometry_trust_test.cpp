#include "components/slam/odometry_trust.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::slam {
namespace {

// Steps whose errors have these shares of the variance that SlamOptions assumes; scans that err by 2 mm and 1
// mrad.
class LearnedFromDraws {
 public:
  explicit LearnedFromDraws(std::uint64_t seed) : random_(seed) {}

  void step(double travel_share, double turn_share) {
    const SlamOptions options;
    const Pose2 odometry{0.2, 0.0, 0.1};
    const Eigen::Vector3d assumed = step_covariance(odometry, options).diagonal();
    const Eigen::Vector3d shares{travel_share, travel_share, turn_share};
    const Eigen::Vector3d scan_sigma{0.002, 0.002, 0.001};
    const Eigen::Matrix3d information = scan_sigma.cwiseAbs2().cwiseInverse().asDiagonal();
    const Eigen::Matrix3d predicted = trust.covariance(odometry, options);
    Eigen::Vector3d innovation;
    for (int k = 0; k < 3; ++k)
      innovation(k) =
          random_.normal(0.0, std::sqrt(assumed(k) * shares(k))) + random_.normal(0.0, scan_sigma(k));
    // As tracking corrects: by the Kalman gain.
    const Eigen::Vector3d by = (predicted.inverse() + information).inverse() * information * innovation;
    const Pose2 corrected{odometry.x + by.x(), odometry.y + by.y(), odometry.theta + by.z()};
    trust.learn(odometry, corrected, predicted, information, options);
  }
  OdometryTrust trust;

 private:
  Random random_;
};

// 1 m straight on, and 1 rad on the spot: the squares of the options' standard deviations, and 1 mm and 1
// mrad of any step.
TEST(OdometryTrust, StepCovarianceIsThatOfTheOptions) {
  SlamOptions options;
  options.odometry_travel_noise = 0.05;
  options.odometry_heading_noise = 0.1;
  options.odometry_turn_noise = 0.2;
  const Eigen::Matrix3d metre = step_covariance({1.0, 0.0, 0.0}, options);
  EXPECT_NEAR(metre(0, 0), 0.0025 + 1e-6, 1e-12);
  EXPECT_NEAR(metre(1, 1), 0.0025 + 1e-6, 1e-12);
  EXPECT_NEAR(metre(2, 2), 0.01 + 1e-6, 1e-12);
  const Eigen::Matrix3d radian = step_covariance({0.0, 0.0, -1.0}, options);
  EXPECT_NEAR(radian(0, 0), 1e-6, 1e-12);
  EXPECT_NEAR(radian(2, 2), 0.04 + 1e-6, 1e-12);
  // Two steps of half the way are as sure as one, but for what each adds.
  EXPECT_NEAR(2.0 * step_covariance({0.5, 0.0, 0.0}, options)(0, 0), metre(0, 0), 1.1e-6);
}

// Up by 0.2 of a difference and down by 0.03: of squares of a normal it settles where 0.2 E[(s - f)+] = 0.03
// E[(f - s)+], at 2.25 times the variance (the 0.87 expectile of chi^2 with one degree of freedom), 1.5 times the
// standard deviation: within a factor of two of it, on the safe side. Mean of the last 1000 of 2000 steps,
// over 20 seeds.
TEST(OdometryTrust, LearnsWithinAFactorOfTwoOfTheStandardDeviation) {
  for (const double travel_share : {0.03, 0.3, 1.0}) {
    for (const double turn_share : {0.05, 0.5, 1.5}) {
      double travel = 0.0;
      double turn = 0.0;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        LearnedFromDraws learned(seed);
        for (int k = 0; k < 2000; ++k) {
          learned.step(travel_share, turn_share);
          if (k < 1000) continue;
          travel += learned.trust.travel() / 20000.0;
          turn += learned.trust.turn() / 20000.0;
        }
      }
      EXPECT_GT(std::sqrt(travel / travel_share), 1.0);
      EXPECT_LT(std::sqrt(travel / travel_share), 2.0);
      EXPECT_GT(std::sqrt(turn / turn_share), 1.0);
      EXPECT_LT(std::sqrt(turn / turn_share), 2.0);
    }
  }
}

// A wheel that slips after an hour of good odometry: one step of ten standard deviations is 100 times the
// variance, of which 40 are counted and a fifth taken: 8.
TEST(OdometryTrust, GoesUpAtOnceWhenOdometryErrs) {
  LearnedFromDraws learned(5);
  for (int k = 0; k < 1000; ++k) learned.step(0.01, 0.01);
  EXPECT_LT(learned.trust.travel(), 0.1);
  EXPECT_LT(learned.trust.turn(), 0.1);
  const SlamOptions options;
  const Pose2 odometry{0.2, 0.0, 0.1};
  const Eigen::Vector3d sigma = step_covariance(odometry, options).diagonal().cwiseSqrt();
  const Eigen::Matrix3d predicted = learned.trust.covariance(odometry, options);
  const Eigen::Matrix3d information = 1e9 * Eigen::Matrix3d::Identity();
  learned.trust.learn(odometry, {0.2 + 10.0 * sigma(0), 0.0, 0.1 + 10.0 * sigma(2)}, predicted, information,
                      options);
  EXPECT_NEAR(learned.trust.travel(), 8.0, 0.1);
  EXPECT_NEAR(learned.trust.turn(), 8.0, 0.1);
  // A hundred good steps on it is down again: by 3 % a step.
  for (int k = 0; k < 150; ++k) learned.step(0.01, 0.01);
  EXPECT_LT(learned.trust.travel(), 0.3);
}

TEST(OdometryTrust, StaysWithinItsBounds) {
  LearnedFromDraws learned(2);
  for (int k = 0; k < 200; ++k) learned.step(500.0, 500.0);
  EXPECT_EQ(learned.trust.travel(), 10.0);
  EXPECT_EQ(learned.trust.turn(), 10.0);
  for (int k = 0; k < 3000; ++k) learned.step(0.0, 0.0);
  EXPECT_GE(learned.trust.travel(), 0.002);
  EXPECT_LT(learned.trust.travel(), 0.05);
}

// A scan that does not tell where the robot is along its way teaches nothing of travel.
TEST(OdometryTrust, LearnsNothingOfTravelInACorridor) {
  OdometryTrust trust;
  const SlamOptions options;
  const Pose2 odometry{0.2, 0.0, 0.0};
  const Eigen::Matrix3d information = Eigen::Vector3d{0.0, 1e6, 1e6}.asDiagonal();
  const double before = trust.travel();
  trust.learn(odometry, {0.3, 0.0, 0.0}, trust.covariance(odometry, options), information, options);
  EXPECT_EQ(trust.travel(), before);
}

}  // namespace
}  // namespace bw::slam
