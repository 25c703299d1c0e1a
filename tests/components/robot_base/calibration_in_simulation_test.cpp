// The whole calibration in the simulated world: legs driven by a wrong odometry on wheels that slip and
// encoders that err, ends measured with errors. What is asked: wheels 1 % unequal, separation wrong by 3 %,
// scale by 2 %: residual at most 0.1, 0.3 and 0.2 %, over 20 seeds.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/robot_base/calibration/calibrate_odometry.hpp"
#include "components/robot_base/calibration/leg_driver.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "components/world/drive_model.hpp"

namespace bw {
namespace {

const StaticScene kOpenFloor({}, std::nullopt);

struct Floor {
  double slip = 0.005;
  double noise = 0.0;           ///< k of model/README.md 2.2 [m]
  double position_error = 0.0;  ///< sd of a measured end [m]
  double heading_error = 0.0;   ///< [rad]
};

/// A robot on that floor, and what its own program believes.
class Experiment {
 public:
  Experiment(const Robot& truth, const Floor& floor, const DriveOptions& drive, std::uint64_t seed)
      : floor_(floor), believed_(truth), random_(seed), drive_(drive, truth, {}, Random(1000 + seed)) {
    believed_.wheel_separation *= 1.03;
    odometry_.emplace(believed_, OdometryOptions{});
    advance({});
  }

  Robot believed() const { return believed_; }

  /// Drives it to its end; the rotations of the wheels on the way.
  std::vector<WheelRotations> drive(const Leg& leg) {
    LegDriver driver(leg, {}, odometry_->state().X_OB);
    std::vector<WheelRotations> rotations;
    for (int i = 0; i < 6'000; ++i) {
      const auto wish = driver.step(odometry_->state().X_OB, odometry_->state().twist);
      if (!wish) return rotations;
      // As motor_control does: 1 m/s^2 and 1.5 rad/s^2 at most.
      commanded_.v += std::clamp(wish->v - commanded_.v, -0.02, 0.02);
      commanded_.omega += std::clamp(wish->omega - commanded_.omega, -0.03, 0.03);
      const double left = odometry_->state().left_angle;
      const double right = odometry_->state().right_angle;
      advance(commanded_);
      rotations.push_back({odometry_->state().left_angle - left, odometry_->state().right_angle - right});
    }
    ADD_FAILURE() << "a leg did not end";
    return rotations;
  }

  Pose2 measured() {
    const Pose2& pose = drive_.pose();
    return {random_.normal(pose.x, floor_.position_error), random_.normal(pose.y, floor_.position_error),
            random_.normal(pose.theta, floor_.heading_error)};
  }

 private:
  /// 20 ms, then a reading of the encoders.
  void advance(const Twist2& twist) {
    const WheelSpeeds wheels = to_wheel_speeds(twist, believed_.wheel_separation);
    const WheelRadii radii = believed_.wheel_radii();
    drive_.command({wheels.left / radii.left, wheels.right / radii.right});
    for (int i = 0; i < 2; ++i) drive_.step(0.01, kOpenFloor);
    time_ = time_ + Duration::milliseconds(20);
    odometry_->add(time_, {time_, drive_.ticks().left, drive_.ticks().right});
  }

  Floor floor_;
  Robot believed_;
  Random random_;
  DriveModel drive_;
  std::optional<EncoderOdometry> odometry_;
  Twist2 commanded_;
  Time time_ = Time::seconds(1.0);
};

/// Residuals in percent, and what the calibration says of them.
struct Residual {
  double ratio, separation, scale;
  WheelGeometry told;
};

enum class Ends { typed, corners };

std::vector<MeasuredMotion> measure(Experiment& experiment, int straights, int laps, Ends ends) {
  using Known = MeasuredMotion::Known;
  std::vector<MeasuredMotion> motions;
  for (int i = 0; i < straights; ++i) {
    const Pose2 from = experiment.measured();
    const auto rotations = experiment.drive({.distance = 5.0});
    const Pose2 to = experiment.measured();
    motions.push_back({rotations, {(to.position() - from.position()).norm(), 0.0, 0.0}, Known::distance});
    experiment.drive({.rotation = std::numbers::pi});
  }
  for (int lap = 0; lap < 2 * laps; ++lap) {
    Pose2 from = experiment.measured();
    MeasuredMotion whole{.known = Known::pose};
    for (int leg = 0; leg < 8; ++leg) {
      const Leg motion = leg % 2 == 0
                             ? Leg{.distance = 4.0}
                             : Leg{.rotation = (lap % 2 == 0 ? std::numbers::pi : -std::numbers::pi) / 2.0};
      const auto rotations = experiment.drive(motion);
      whole.rotations.insert(whole.rotations.end(), rotations.begin(), rotations.end());
      if (ends == Ends::typed && leg < 7) continue;
      const Pose2 to = experiment.measured();
      whole.moved = inverse(from) * to;
      motions.push_back(std::exchange(whole, {.known = Known::pose}));
      from = to;
    }
  }
  return motions;
}

Residual calibrate(const Floor& floor, std::uint64_t seed, int straights, int laps, Ends ends) {
  constexpr double kMismatch = 0.01;
  constexpr double kScale = 0.02;
  const Robot truth;
  DriveOptions drive;
  drive.slip = floor.slip;
  drive.scale = kScale;
  drive.mismatch = kMismatch;
  drive.noise = floor.noise;
  Experiment experiment(truth, floor, drive, seed);
  const auto motions = measure(experiment, straights, laps, ends);
  const auto found = calibrate_odometry(motions, geometry_of(experiment.believed()),
                                        {.position = std::max(floor.position_error, 0.002),
                                         .heading = std::max(floor.heading_error, 0.002),
                                         .variance_per_metre = floor.noise});
  EXPECT_TRUE(found);
  // A wheel rolls `grip` of its rim, and counts 1 + scale -+ mismatch / 2 of it.
  const double left = truth.wheel_radius * (1.0 - floor.slip) / (1.0 + kScale - kMismatch / 2.0);
  const double right = truth.wheel_radius * (1.0 - floor.slip) / (1.0 + kScale + kMismatch / 2.0);
  const auto percent = [](double value, double true_value) { return 100.0 * (value / true_value - 1.0); };
  return {percent(found->geometry.ratio, right / left),
          percent(found->geometry.separation, truth.wheel_separation),
          percent(found->geometry.radius, (left + right) / 2.0), found->share_of_error};
}

void expect_within_what_is_asked(const char* what, const Floor& floor, int straights, int laps, Ends ends) {
  std::printf("%s: k = %g m, slip %g, ends +-%.0f mm +-%.1f degrees, %d straights, %d squares each way\n",
              what, floor.noise, floor.slip, 1e3 * floor.position_error,
              floor.heading_error * 180.0 / std::numbers::pi, straights, laps);
  std::printf("seed  ratio %%  separation %%  scale %%   (said to be +- ratio, separation, scale)\n");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Residual r = calibrate(floor, seed, straights, laps, ends);
    std::printf("%4d  %+7.3f  %+12.3f  %+7.3f   (%.3f %.3f %.3f)\n", static_cast<int>(seed), r.ratio,
                r.separation, r.scale, 100.0 * r.told.ratio, 100.0 * r.told.separation,
                100.0 * r.told.radius);
    EXPECT_LE(std::abs(r.ratio), 0.1) << "seed " << seed;
    EXPECT_LE(std::abs(r.separation), 0.3) << "seed " << seed;
    EXPECT_LE(std::abs(r.scale), 0.2) << "seed " << seed;
  }
}

// A hard floor: 1 mm per root metre. Ends by tape measure and a mark of the heading.
TEST(CalibrationInSimulation, EndsTypedInOnAHardFloor) {
  expect_within_what_is_asked("typed", {.noise = 1e-6, .position_error = 0.003, .heading_error = 0.01}, 4, 5,
                              Ends::typed);
}

// The floor of config/graphs/hallway.yaml: 5.5 mm per root metre. Corners from the laser against the map.
TEST(CalibrationInSimulation, CornersByTheLaserOnTheFloorOfTheHallway) {
  expect_within_what_is_asked("laser", {.noise = 3e-5, .position_error = 0.01, .heading_error = 0.005}, 12,
                              24, Ends::corners);
}

}  // namespace
}  // namespace bw
