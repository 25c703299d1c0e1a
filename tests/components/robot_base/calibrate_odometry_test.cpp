// The sizes of a base from motions with known ends, against their closed forms.
#include "components/robot_base/calibration/calibrate_odometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kPi = std::numbers::pi;
const WheelGeometry kBelieved{.radius = 0.05, .ratio = 1.0, .separation = 0.3};
const WheelGeometry kTrue{.radius = 0.051, .ratio = 1.01, .separation = 0.309};

/// Wheel rotations by which a base of that geometry travels so far and rotates so much.
void roll(std::vector<WheelRotations>& rotations, const WheelGeometry& geometry, double distance,
          double rotation) {
  constexpr int kSteps = 100;
  const double left_radius = geometry.radius * 2.0 / (1.0 + geometry.ratio);
  const double across = rotation * geometry.separation / 2.0;
  const WheelRotations one{(distance - across) / left_radius / kSteps,
                           (distance + across) / (left_radius * geometry.ratio) / kSteps};
  rotations.insert(rotations.end(), kSteps, one);
}

/// What the base believes to be a square; direction +1 to the left.
std::vector<WheelRotations> square(const WheelGeometry& believed, int direction, double side) {
  std::vector<WheelRotations> rotations;
  for (int leg = 0; leg < 4; ++leg) {
    roll(rotations, believed, side, 0.0);
    roll(rotations, believed, 0.0, direction * kPi / 2.0);
  }
  return rotations;
}

std::vector<MeasuredMotion> both_squares(const WheelGeometry& truth, MeasuredMotion::Known known) {
  std::vector<MeasuredMotion> motions;
  for (const int direction : {+1, -1}) {
    const auto rotations = square(kBelieved, direction, 4.0);
    motions.push_back({rotations, rolled(rotations, truth), known});
  }
  return motions;
}

void add_straight(std::vector<MeasuredMotion>& motions) {
  std::vector<WheelRotations> rotations;
  roll(rotations, kBelieved, 5.0, 0.0);
  motions.push_back(
      {rotations, {rolled(rotations, kTrue).position().norm(), 0.0, 0.0}, MeasuredMotion::Known::distance});
}

TEST(CalibrateOdometry, ARollOfACircleEndsWhereItsClosedFormSays) {
  // Arc of radius 1 m to the left by a quarter: ends at (1, 1, 90 degrees).
  std::vector<WheelRotations> rotations;
  roll(rotations, kBelieved, kPi / 2.0, kPi / 2.0);
  const Pose2 end = rolled(rotations, kBelieved);
  EXPECT_NEAR(end.x, 1.0, 1e-9);
  EXPECT_NEAR(end.y, 1.0, 1e-9);
  EXPECT_NEAR(end.theta, kPi / 2.0, 1e-9);
}

TEST(CalibrateOdometry, ExactMotionsGiveExactSizes) {
  for (const auto known : {MeasuredMotion::Known::position, MeasuredMotion::Known::pose}) {
    std::vector<MeasuredMotion> motions = both_squares(kTrue, known);
    add_straight(motions);
    const auto found = calibrate_odometry(motions, kBelieved, {});
    ASSERT_TRUE(found);
    // The prior, which is 20 and 10 % wide, draws by less than 1e-4 of what is looked for.
    EXPECT_NEAR(found->geometry.radius, kTrue.radius, 1e-4 * kTrue.radius);
    EXPECT_NEAR(found->geometry.ratio, kTrue.ratio, 2e-5);
    EXPECT_NEAR(found->geometry.separation, kTrue.separation, 1e-4 * kTrue.separation);
    EXPECT_LT(found->disagreement, 0.1);
  }
}

// Borenstein and Feng (1996): from the ends of squares of side L in both directions the errors a of each
// rotation and c of each leg; then E_b = 90 / (90 + a), a positive where rotations go too far, R = L/2 /
// sin(c/2) and E_d = (R + b/2) / (R - b/2). Linear in both errors, so small ones are compared.
TEST(CalibrateOdometry, SmallErrorsAreThoseOfTheFormulasOfUmbmark) {
  constexpr double kSide = 4.0;
  const WheelGeometry truth{.radius = 0.05, .ratio = 1.0005, .separation = 0.3 * 1.001};
  std::vector<MeasuredMotion> motions = both_squares(truth, MeasuredMotion::Known::position);
  const Pose2 ccw = motions[0].moved;
  const Pose2 cw = motions[1].moved;
  // Rotations go too far by a and legs bend to the left by c each: the second leg of a left square heads for
  // 90 degrees + a + 3c/2, the fourth for 270 + 3a + 7c/2, so that x ends at L (2a + 2c); of a right square
  // at L (2a - 2c).
  const double rotation_error = (ccw.x + cw.x) / (4.0 * kSide);
  const double leg_error = (ccw.x - cw.x) / (4.0 * kSide);
  const double separation_ratio = (kPi / 2.0) / (kPi / 2.0 + rotation_error);
  const double arc = kSide / 2.0 / std::sin(leg_error / 2.0);
  const double ratio = (arc + truth.separation / 2.0) / (arc - truth.separation / 2.0);

  std::vector<WheelRotations> rotations;
  roll(rotations, kBelieved, 5.0, 0.0);
  motions.push_back(
      {rotations, {rolled(rotations, truth).position().norm(), 0.0, 0.0}, MeasuredMotion::Known::distance});
  const auto found = calibrate_odometry(motions, kBelieved, {});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->geometry.ratio, ratio, 0.1 * 0.0005);
  EXPECT_NEAR(found->geometry.separation / kBelieved.separation, separation_ratio, 0.1 * 0.001);
}

TEST(CalibrateOdometry, ASquareAloneTellsNoScaleAndALineNoSeparation) {
  const auto squares =
      calibrate_odometry(both_squares(kTrue, MeasuredMotion::Known::position), kBelieved, {});
  ASSERT_TRUE(squares);
  EXPECT_GT(squares->share_of_error.radius, 10.0 * squares->share_of_error.ratio);
  std::vector<MeasuredMotion> straight;
  add_straight(straight);
  EXPECT_FALSE(calibrate_odometry({}, kBelieved, {}));
  const auto line = calibrate_odometry(straight, kBelieved, {});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->geometry.separation, kBelieved.separation) << "as it was";
}

}  // namespace
}  // namespace bw
