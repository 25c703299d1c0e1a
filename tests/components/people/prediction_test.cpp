// Predictions against closed forms, ellipses against what they promise, and both on recorded people.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/files/shape_file.hpp"
#include "components/lab/people_training/prediction_judge.hpp"
#include "components/model/random.hpp"
#include "components/people/prediction/predictor.hpp"
#include "components/world/files/track_file.hpp"

namespace bw::people {
namespace {

const Time kNow = Time::seconds(10.0);

TrackedPerson walker(std::uint32_t id, const Vector2& position, const Vector2& velocity) {
  TrackedPerson person{{.id = id, .position = position, .velocity = velocity}};
  person.covariance.diagonal() << 0.01, 0.01, 0.04, 0.04;
  return person;
}

std::vector<std::vector<PredictedPosition>> predictions_of(Predictor& predictor,
                                                           std::vector<TrackedPerson> people,
                                                           const StaticObstacles& walls, Time now) {
  predictor.predict(people, walls, now);
  std::vector<std::vector<PredictedPosition>> predictions;
  for (TrackedPerson& person : people) predictions.push_back(std::move(person.predictions));
  return predictions;
}

// p + v t; (0.01 + 0.04 t^2) I, and q t^3 / 3 more along and across the path, by hand at t = 2 s.
TEST(Prediction, KeepsTheVelocity) {
  PredictionOptions options;
  options.horizon = 2.0;
  options.spread_along = 0.3;
  options.spread_across = 0.15;
  Predictor predictor(options);
  const auto predictions = predictions_of(predictor, {walker(1, {1.0, 2.0}, {0.0, 1.0})}, {}, kNow);
  ASSERT_EQ(predictions.size(), 1U);
  ASSERT_EQ(predictions[0].size(), 4U);
  const PredictedPosition& last = predictions[0].back();
  EXPECT_DOUBLE_EQ(last.time, 2.0);
  EXPECT_NEAR((last.position - Vector2(1.0, 4.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(last.covariance(0, 0), 0.01 + 0.16 + 0.15 * 8.0 / 3.0, 1e-12);  // across
  EXPECT_NEAR(last.covariance(1, 1), 0.01 + 0.16 + 0.30 * 8.0 / 3.0, 1e-12);  // along
  EXPECT_NEAR(last.covariance(0, 1), 0.0, 1e-12);
}

// On a circle of 1 rad/s the turn rate is known after a few windows; it dies out: in the end the heading has
// rotated by omega tau = 0.6 rad, and the last chord points there.
TEST(Prediction, LetsATurnGoOnAndDieOut) {
  PredictionOptions options;
  options.model = PredictionModel::constant_turn_rate;
  options.horizon = 10.0;
  options.step = 0.1;
  options.calibration_rate = 0.0;
  Predictor predictor(options);
  std::vector<std::vector<PredictedPosition>> predictions;
  double heading = 0.0;
  for (int i = 0; i < 80; ++i) {
    heading = wrap_angle(0.1 * i);
    const Vector2 velocity(std::cos(heading), std::sin(heading));
    predictions =
        predictions_of(predictor, {walker(1, {0.0, 0.0}, velocity)}, {}, kNow + Duration::seconds(0.1 * i));
  }
  const auto& path = predictions[0];
  const auto direction = [&](std::size_t k) {
    const Vector2 chord = path[k].position - path[k - 1].position;
    return std::atan2(chord.y(), chord.x());
  };
  EXPECT_NEAR(wrap_angle(direction(99) - heading), 0.6, 1e-3);
  EXPECT_NEAR(wrap_angle(direction(10) - heading), 0.6 * (1.0 - std::exp(-1.05 / 0.6)), 2e-3);
  double distance = path[0].position.norm();
  for (std::size_t k = 1; k < path.size(); ++k) distance += (path[k].position - path[k - 1].position).norm();
  EXPECT_NEAR(distance, 10.0, 0.01);  // at 1 m/s
}

// Two who would collide pass each other, by the same amount to either side; one who walks along a wall keeps
// off it; who stands stays.
TEST(Prediction, SocialForcesLeadPeopleRoundOneAnotherAndAlongWalls) {
  PredictionOptions options;
  options.model = PredictionModel::social_force;
  Predictor predictor(options);
  const auto apart = predictions_of(
      predictor, {walker(1, {0.0, 0.0}, {1.0, 0.0}), walker(2, {6.0, 0.0}, {-1.0, 0.0})}, {}, kNow);
  double closest = 1e9;
  for (std::size_t k = 0; k < apart[0].size(); ++k) {
    closest = std::min(closest, (apart[0][k].position - apart[1][k].position).norm());
    EXPECT_NEAR((apart[0][k].position + apart[1][k].position - Vector2(6.0, 0.0)).norm(), 0.0, 1e-9);
  }
  EXPECT_GT(closest, 0.3);

  StaticObstacles wall;
  wall.segments = {{{-5.0, 0.0}, {20.0, 0.0}}};
  const auto along = predictions_of(predictor, {walker(1, {0.0, 1.5}, {1.0, -0.3})}, wall, kNow);
  for (const PredictedPosition& p : along[0])
    EXPECT_GT(p.position.y(), 0.3);  // straight on ends at 0.3 below: at 4 s

  const auto standing = predictions_of(predictor, {walker(1, {0.0, 0.4}, {0.0, 0.0})}, wall, kNow);
  EXPECT_EQ(standing[0].back().position, Vector2(0.0, 0.4));
}

TEST(Prediction, LeavesOutWhoIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [model, name] : choice_table(PredictionModel{})) {
    PredictionOptions options;
    options.model = model;
    Predictor predictor(options);
    const auto predictions = predictions_of(
        predictor, {walker(1, {nan, 0.0}, {1.0, 0.0}), walker(2, {0.0, 0.0}, {1.0, 0.0})}, {}, kNow);
    ASSERT_EQ(predictions.size(), 2U);
    EXPECT_TRUE(predictions[0].empty());
    EXPECT_EQ(predictions[1].size(), 8U);
    EXPECT_NEAR((predictions[1].back().position - Vector2(4.0, 0.0)).norm(), 0.0, 1e-9) << name;
  }
}

// Errors of twice and of half the deviation that the predictions claim: after a few hundred of them 95 % are
// inside again, within three standard deviations of a share of 2000.
TEST(Prediction, EllipsesGrowAndShrinkToHoldTheirShare) {
  for (const double truth_over_claim : {2.0, 0.5}) {
    Calibration calibration(0.1);
    Random random(7);
    int inside = 0;
    int counted = 0;
    for (int i = 0; i < 3000; ++i) {
      const Time now = kNow + Duration::seconds(0.5 * i);
      const Vector2 truth(truth_over_claim * random.normal(), truth_over_claim * random.normal());
      // Everybody lives for one prediction only: made at the origin, judged half a second later.
      const auto id = static_cast<std::uint32_t>(i);
      calibration.observe(id, now, {0.0, 0.0}, Eigen::Matrix2d::Zero());
      calibration.expect(id, now, {{0.5, {0.0, 0.0}, Eigen::Matrix2d::Identity()}});
      if (i >= 1000) {
        ++counted;
        if (truth.squaredNorm() / calibration.size(0) < 5.991) ++inside;
      }
      calibration.observe(id, now + Duration::seconds(0.5), truth, Eigen::Matrix2d::Zero());
    }
    const double share = static_cast<double>(inside) / counted;
    EXPECT_NEAR(share, 0.95, 3.0 * std::sqrt(0.95 * 0.05 / counted)) << truth_over_claim;
    EXPECT_NEAR(std::sqrt(calibration.size(0)), truth_over_claim, 0.25 * truth_over_claim);
  }
}

// Who comes long after the clock began is compared as well: 1 s ahead an error of 5 m, where 0.35 m are
// claimed (0.01 + 0.04 + 0 at 1 s, 95 %: 0.55 m), enlarges the ellipse by exp(0.3 * 0.95) at once.
TEST(Prediction, ComparesWhoComesLate) {
  Predictor predictor({});
  const Time late = kNow + Duration::seconds(100.0);
  predictions_of(predictor, {walker(1, {0.0, 0.0}, {1.0, 0.0})}, {}, late);
  predictions_of(predictor, {walker(1, {5.0, 0.0}, {1.0, 0.0})}, {}, late + Duration::seconds(0.5));
  const auto then =
      predictions_of(predictor, {walker(1, {5.5, 0.0}, {1.0, 0.0})}, {}, late + Duration::seconds(0.6));
  EXPECT_NEAR(then[0][0].covariance(0, 0), (0.01 + 0.25 * 0.04) * std::exp(0.3 * 0.95), 1e-12);
}

// Reference: the constant-velocity Kalman figures of experiments/protocols.md 8.7, printed with two digits.
TEST(Prediction, IsAsGoodAsTheReferenceOnRecordedPeopleAndCalibrated) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set: no recorded people";
  const std::string folder = std::string(shared) + "/data/eth_ucy_pedestrians/";
  const std::map<std::string, std::array<double, 3>> reference{
      {"eth", {0.19, 0.37, 1.28}}, {"hotel", {0.13, 0.24, 0.62}}, {"zara01", {0.08, 0.22, 1.01}}};
  PredictionOptions options;
  options.horizon = 4.8;
  options.step = 0.8;
  for (const auto& [name, errors] : reference) {
    Judging how{.times = {0.8, 1.6, 4.8}};
    if (name != "eth") how.walls.segments = read_walls(folder + name + "_walls.csv");
    if (name == "hotel") how.walls.discs = read_circles(folder + name + "_circles.csv");
    const auto verdicts = judge_prediction(read_tracks(folder + name + ".csv"), Predictor(options), how);
    for (std::size_t h = 0; h < how.times.size(); ++h) {
      EXPECT_LE(verdicts[h].error, errors[h] + 0.005) << name << " at " << how.times[h];
      EXPECT_GE(verdicts[h].inside, 0.90) << name << " at " << how.times[h];
      EXPECT_LE(verdicts[h].inside, 0.98) << name << " at " << how.times[h];
      EXPECT_GT(verdicts[h].count, 1000) << name;
    }
  }
}

}  // namespace
}  // namespace bw::people
