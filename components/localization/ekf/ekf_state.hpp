// All that the filter knows at one stamp. It is a value: a late measurement starts again from an older one.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "components/localization/measurements.hpp"
#include "components/model/rigid_fit.hpp"

namespace bw::localization {

/// x, y, theta, gyro bias, heading offset, rounding of the rotation that the wheels have counted; an unused
/// one has variance zero.
constexpr int kStates = 6;
constexpr int kRounding = 5;
using StateVector = Eigen::Matrix<double, kStates, 1>;
using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

constexpr Time kNever{std::numeric_limits<std::int64_t>::min() / 4};

/// Gyro readings since the last wheel step.
struct GyroSum {
  Time last = kNever;     ///< stamp of the last reading
  double rate = 0.0;      ///< [rad/s]
  double variance = 0.0;  ///< of it
  double angle = 0.0;     ///< integral [rad]
  double angle_variance = 0.0;
  double covered = 0.0;  ///< time integrated over [s]
};

/// What the wheels measured too much since a slip began.
struct SlipExcess {
  double peak = 0.0;                ///< largest disagreement [rad]
  std::array<double, 3> weights{};  ///< of right wheel, left wheel, both alike; sum < 1: none fits
  double disagreement = 0.0;        ///< sum, signed [rad]
  double rotated = 0.0;             ///< sum of its steps' magnitudes [rad]
  double travel = 0.0;              ///< of the wheels [m]
  double rotation = 0.0;            ///< of the wheels [rad]
  double taken = 0.0;               ///< of the distance taken back so far [m]
  double variance = 0.0;            ///< of the distance, given so far [m^2]
};

/// Wheels against gyro (slip.hpp). The first five are sums forgotten exponentially, over one window or so.
struct SlipWatch {
  double disagreement = 0.0;    ///< rotation of the wheels less the gyro's [rad]
  double variance = 0.0;        ///< of its white part [rad^2]
  double time = 0.0;            ///< [s] that it spans; times the bias' variance, its common part
  double travel = 0.0;          ///< of the wheels [m]
  double rotation = 0.0;        ///< of the wheels [rad]
  double block_travel = 0.0;    ///< of the span of one window that is not full yet [m]
  double block_time = 0.0;      ///< [s]
  double last_speed = 0.0;      ///< mean over the last full one [m/s]
  double speed = 0.0;           ///< over that before it, which no slip that was just seen has reached [m/s]
  Time since = kNever;          ///< slip goes on since then; kNever: none
  Time seen = kNever;           ///< last sign of it
  double lately = 0.0;          ///< [s] of slip, forgotten within half a minute
  double apart = 0.0;           ///< as disagreement, over a window that a failing gyro takes to show [rad]
  double apart_variance = 0.0;  ///< of its white part [rad^2]
  Time distrusted_until = kNever;  ///< the gyro was found to have failed (heading_doubt.hpp)
  SlipExcess excess;               ///< of the slip that goes on
};

/// A compass and the estimate contradict each other (heading_doubt.hpp).
struct HeadingDoubt {
  int source = -1;                          ///< the compass that is watched
  int readings = 0;                         ///< of it
  Time since = kNever;                      ///< the doubt goes on since then; kNever: none
  StateVector error = StateVector::Zero();  ///< of the estimate, if the compass is right: truth less estimate
  double by_wheels = 0.0;                   ///< log of the likelihood ratio that it is, as wheels tell
  double by_others = 0.0;                   ///< and as fixes do

  bool is_open() const { return since != kNever; }
  double evidence() const { return by_wheels + by_others; }
  /// That the compass is right.
  double probability() const { return is_open() ? 1.0 / (1.0 + std::exp(-evidence())) : 0.0; }
};

/// Rejections of one source in a row that agree with each other.
struct RejectedRun {
  int count = 0;
  int misfits = 0;  ///< rejections in a row that do not agree with the run
  Time since = kNever;
  Vector2 position{0.0, 0.0};  ///< the last one that agreed
  double heading = 0.0;
  double odometer = 0.0;  ///< of the robot then [m]
  double rotated = 0.0;   ///< the same of its rotation [rad]
  double start_odometer = 0.0;
  RigidFit fit;  ///< map from odometry, of the run's positions
};

/// Noise of a source as its innovations show it (adaptive_noise.hpp).
struct NoiseWatch {
  double factor = 1.0;                             ///< on the declared covariance
  Eigen::Vector3d last = Eigen::Vector3d::Zero();  ///< innovation, whitened by the declared covariance
  int dof = 0;                                     ///< of it; 0: none yet
};

struct SourceState {
  Time last_seen = kNever;
  Time last_used = kNever;
  Time last_trusted = kNever;  ///< used, and for a range: while most of them were
  bool gives_position = false;
  bool gives_range = false;  ///< a position by several only: one may fit by chance
  bool gives_heading = false;
  double period = 0.0;  ///< between stamps, smoothed [s]; 0: unknown
  std::uint32_t used = 0;
  std::uint32_t rejected = 0;
  double acceptance = 1.0;  ///< share used, smoothed over about 50
  double nis = 0.0;         ///< normalised innovation squared of those used, smoothed alike
  double nis_all = 0.0;     ///< the same with those rejected, each counted at most 100
  int dof = 0;              ///< expected value of an honest nis
  NoiseWatch noise;
  RejectedRun run;
};

struct EkfState {
  Time time;  ///< of x and P: the last wheel step's, or later when wheels are silent
  StateVector x = StateVector::Zero();
  StateMatrix P = StateMatrix::Zero();
  Twist2 twist;              ///< over the last step
  Time last_wheel = kNever;  ///< end of the last wheel step
  Time rounded_at = kNever;  ///< end of the wheel step to which the rounding belongs
  Pose2 X_OB;                ///< wheels and gyro alone, from where the filter started
  double odometer = 0.0;     ///< [m], forward and backward both counted
  double rotated = 0.0;      ///< [rad], signed, not wrapped
  GyroSum gyro;
  SlipWatch slip;
  HeadingDoubt doubt;
  Time last_reset = kNever;  ///< last time a source took the estimate over
  int reset_source = -1;
  std::vector<SourceState> sources{kUsualSources};  ///< by number

  Pose2 pose() const { return {x(0), x(1), x(2)}; }
};

}  // namespace bw::localization
