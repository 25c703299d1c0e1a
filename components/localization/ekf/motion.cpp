#include "components/localization/ekf/motion.hpp"

#include <algorithm>
#include <cmath>

#include "components/localization/ekf/correction.hpp"
#include "components/localization/ekf/covariance_bounds.hpp"
#include "components/localization/ekf/slip.hpp"
#include "components/model/arc.hpp"

namespace bw::localization {
namespace {

constexpr int kJoint = kStates + 2;  // the state and (distance, rotation)
using JointVector = Eigen::Matrix<double, kJoint, 1>;
using JointMatrix = Eigen::Matrix<double, kJoint, kJoint>;

constexpr double kCoverage = 0.9;         // of a step that the gyro must have seen
constexpr double kRotationFloor = 1e-9;   // [rad^2/s] that a rotation is never known better than
constexpr double kDistanceFloor = 1e-10;  // [m^2/s] the same

double seconds(Duration d) { return d.to_seconds(); }

// Extends the integral at the last reading's rate up to `time`, if the reading is recent enough.
void hold_gyro(GyroSum& gyro, Time from, Time time, double gap) {
  const double dt = seconds(time - std::max(gyro.last, from));
  if (gyro.last == kNever || dt <= 0.0 || seconds(time - gyro.last) > gap) return;
  gyro.angle += gyro.rate * dt;
  gyro.angle_variance += gyro.variance * dt * dt;
  gyro.covered += dt;
}

void restart(GyroSum& gyro) { gyro.angle = gyro.angle_variance = gyro.covered = 0.0; }

// Symmetric, and what rounding put beyond a correlation of one taken back.
Eigen::Matrix2d sound_covariance(const WheelStep& step) {
  Eigen::Matrix2d C = step.covariance;
  const double most = std::sqrt(C(0, 0)) * std::sqrt(C(1, 1));
  C(0, 1) = C(1, 0) = std::clamp(0.5 * (C(0, 1) + C(1, 0)), -most, most);
  return C;
}

void bound(StateMatrix& P) {
  limit_variances(P);
  hold_definite(P, P.diagonal());
}

void add_process_noise(StateMatrix& P, double dt, const BiasOptions& bias) {
  if (bias.gyro_bias) P(3, 3) += bias.gyro_bias_walk * bias.gyro_bias_walk * dt;
  if (bias.heading_offset) P(4, 4) += bias.heading_offset_walk * bias.heading_offset_walk * dt;
}

// The state and the step (distance, rotation), estimated together.
struct Joint {
  JointVector mean;
  JointMatrix covariance = JointMatrix::Zero();
  double carried = 0.0;           // of the rotation: the rounding that the step began with
  double carried_variance = 0.0;  // of it

  double& distance() { return mean(kStates); }
  double& rotation() { return mean(kStates + 1); }
  double gyro_bias() const { return mean(3); }
  double& distance_variance() { return covariance(kStates, kStates); }
  double& rotation_variance() { return covariance(kStates + 1, kStates + 1); }
};

// The wheels have counted the rotation Theta_k + r_k, r_k rounded anew at the end of each step, so that a
// step measures its rotation as rotation - r_(k-1) + r_k. With r in the state a count that has not come yet
// is no proof that the robot does not rotate, and nothing adds up over many steps.
void add_rounding(Joint& joint, const EkfState& state, const WheelStep& step, bool follows) {
  const auto before = state.P.col(kRounding).head<kRounding>();
  joint.carried = follows ? state.x(kRounding) : 0.0;
  joint.carried_variance = follows ? state.P(kRounding, kRounding) : step.rounding;
  joint.rotation() += joint.carried;
  joint.rotation_variance() += joint.carried_variance + step.rounding;
  if (follows) {
    joint.covariance.col(kJoint - 1).head<kRounding>() += before;
    joint.covariance.row(kJoint - 1).head<kRounding>() += before.transpose();
  }
  joint.mean(kRounding) = 0.0;
  joint.covariance.row(kRounding).setZero();
  joint.covariance.col(kRounding).setZero();
  joint.covariance(kRounding, kRounding) = step.rounding;
  joint.covariance(kRounding, kJoint - 1) = joint.covariance(kJoint - 1, kRounding) = -step.rounding;
}

// `part` of the step belongs to the span of `dt` that the state is advanced by.
Joint joined(const EkfState& state, const WheelStep& step, double part, double dt) {
  Joint joint;
  joint.mean << state.x, step.distance * part, step.rotation * part;
  joint.covariance.topLeftCorner<kStates, kStates>() = state.P;
  const double stretch = std::max(part, part * part);  // what is extended is guessed
  joint.covariance.bottomRightCorner<2, 2>() = stretch * sound_covariance(step);
  joint.distance_variance() += kDistanceFloor * dt;
  joint.rotation_variance() += kRotationFloor * dt;
  add_rounding(joint, state, step, part == 1.0 && state.rounded_at == step.time - step.over);
  return joint;
}

// The gyro measures rotation + bias dt.
Innovation<kJoint, 1> gyro_innovation(const GyroSum& gyro, Joint& joint, double dt) {
  const double scale = dt / gyro.covered;
  Innovation<kJoint, 1> z;
  z.H.setZero();
  z.H(0, 3) = dt;
  z.H(0, kStates + 1) = 1.0;
  z.residual(0) = gyro.angle * scale - joint.rotation() - joint.gyro_bias() * dt;
  z.R(0, 0) = gyro.angle_variance * scale * scale;
  return z;
}

// Corrects the step by the gyro; while wheels slip, what is to be taken off its distance.
SlipCorrection update_by_gyro(EkfState& state, Joint& joint, const WheelStep& step, double dt,
                              const EkfOptions& options) {
  SlipCorrection correction;
  const Innovation<kJoint, 1> z = gyro_innovation(state.gyro, joint, dt);
  if (options.slip.enabled) {
    // As the wheels counted: what they round is there twice in a span, not in each of its steps.
    const double rounded = joint.carried_variance + step.rounding;
    const ComparedStep compared{.disagreement = -z.residual(0) - joint.carried,
                                .variance = joint.rotation_variance() - rounded + z.R(0, 0),
                                .rounding = step.rounding,
                                .seconds = dt,
                                .distance = joint.distance(),
                                .rotation = joint.rotation() - joint.carried,
                                .separation = step.separation};
    const bool slipped = slipping(state.slip);
    watch_slip(state.slip, compared, state.P(3, 3), step.time, options.motion.acceleration, options.slip);
    // That the wheels slipped nobody contradicted: it says nothing of the gyro.
    if (slipped && !slipping(state.slip) && !state.doubt.is_open())
      state.slip.apart = state.slip.apart_variance = 0.0;
    if (slipping(state.slip) && !gyro_in_doubt(state.slip, step.time, options.slip)) {
      correction = take_back(state.slip, compared, step.time, options.slip);
      joint.distance_variance() += correction.variance;
      joint.rotation_variance() += z.residual(0) * z.residual(0);
    }
  }
  if (!gyro_in_doubt(state.slip, step.time, options.slip)) update(joint.mean, joint.covariance, z);
  if (slipping(state.slip)) {
    joint.rotation_variance() +=
        common_error(state.slip.excess.rotated, z.residual(0), options.slip.kRotationShare);
  }
  return correction;
}

// J C: the derivatives of the arc for the pose, the rest of the state as it is.
template <class C>
Eigen::Matrix<double, kStates, C::ColsAtCompileTime> moved(const ArcStep& arc, const C& joint) {
  Eigen::Matrix<double, kStates, C::ColsAtCompileTime> out = joint.template topRows<kStates>();
  out.template topRows<3>() = arc.by_pose.lazyProduct(joint.template topRows<3>());
  out.template topRows<3>() += arc.by_step.lazyProduct(joint.template bottomRows<2>());
  return out;
}

// x+ = f(x, distance, rotation), P+ = J C J^T.
void move(EkfState& state, Joint& joint, double distance, double dt, const EkfOptions& options) {
  const double rotation = joint.rotation();
  const ArcStep arc = arc_step({joint.mean(0), joint.mean(1), joint.mean(2)}, distance, rotation);
  const Eigen::Matrix<double, kJoint, kStates> half = moved(arc, joint.covariance).transpose();
  state.P = moved(arc, half);
  state.x << arc.pose.x, arc.pose.y, arc.pose.theta, joint.mean(3), joint.mean(4), joint.mean(kRounding);
  const double walked = options.motion.position_walk * options.motion.position_walk * std::abs(distance);
  state.P(0, 0) += walked;
  state.P(1, 1) += walked;
  add_process_noise(state.P, dt, options.bias);
  bound(state.P);

  if (state.doubt.is_open()) state.doubt.error.head<3>() = arc.by_pose * state.doubt.error.head<3>();

  state.X_OB = advance_arc(state.X_OB, distance, rotation);
  state.odometer += std::abs(distance);
  state.rotated += rotation;
}

}  // namespace

void add_gyro(EkfState& state, const GyroReading& reading, const EkfOptions& options) {
  GyroSum& gyro = state.gyro;
  const double since_last = seconds(reading.time - gyro.last);
  const double dt = std::min(since_last, seconds(reading.time - state.time));
  if (gyro.last != kNever && since_last <= options.motion.kGyroGap && dt > 0.0) {
    gyro.angle += 0.5 * (gyro.rate + reading.rate) * dt;
    gyro.angle_variance += reading.variance * dt * dt;
    gyro.covered += dt;
  }
  gyro.last = reading.time;
  gyro.rate = reading.rate;
  gyro.variance = reading.variance;
}

bool predict(EkfState& state, const WheelStep& step, const EkfOptions& options) {
  const Duration ahead = step.time - state.time;
  if (ahead.nanoseconds <= 0) return false;
  if (seconds(ahead - step.over) > options.motion.extrapolation)
    predict_without_wheels(state, step.time - step.over, options);
  const Duration span = step.time - state.time;
  const double dt = seconds(span);
  const double part = span == step.over ? 1.0 : dt / seconds(step.over);

  Joint joint = joined(state, step, part, dt);
  hold_gyro(state.gyro, state.time, step.time, options.motion.kGyroGap);
  SlipCorrection slip;
  if (state.gyro.covered >= kCoverage * dt) slip = update_by_gyro(state, joint, step, dt, options);
  restart(state.gyro);

  const double travelled = joint.distance() - slip.of_step;  // during this step
  move(state, joint, travelled - slip.catch_up, dt, options);
  state.twist = {travelled / dt, joint.rotation() / dt};
  state.time = step.time;
  state.last_wheel = state.rounded_at = step.time;
  return true;
}

void predict_without_wheels(EkfState& state, Time time, const EkfOptions& options) {
  const Duration span = time - state.time;
  if (span.nanoseconds <= 0) return;
  const double dt = seconds(span);
  const Time since = state.last_wheel == kNever ? state.time : std::min(state.last_wheel, state.time);
  const double before = seconds(state.time - since);
  const double squares = (before + dt) * (before + dt) - before * before;  // of a speed that stays unknown

  const double moved = options.motion.kSilentSpeed;
  state.P(0, 0) += moved * moved * squares;
  state.P(1, 1) += moved * moved * squares;
  GyroSum& gyro = state.gyro;
  hold_gyro(gyro, state.time, time, options.motion.kGyroGap);
  double rotation = 0.0;
  if (gyro.covered >= kCoverage * dt) {
    rotation = gyro.angle - state.x(3) * dt;
    StateMatrix F = StateMatrix::Identity();
    F(2, 3) = -dt;
    state.P = F * state.P * F.transpose();
    state.P(2, 2) += gyro.angle_variance;
  } else {
    const double rate = options.motion.kSilentTurnRate;
    state.P(2, 2) += rate * rate * squares;
  }
  restart(gyro);
  add_process_noise(state.P, dt, options.bias);
  bound(state.P);

  state.x(2) = wrap_angle(state.x(2) + rotation);
  state.X_OB.theta = wrap_angle(state.X_OB.theta + rotation);
  state.odometer += moved * dt;
  state.rotated += rotation;
  state.twist = {};
  state.time = time;
}

Extrapolated extrapolate(const EkfState& state, Time time, const MotionOptions& options) {
  const double tau = std::max(0.0, seconds(time - state.time));
  const ArcStep arc = arc_step(state.pose(), state.twist.v * tau, state.twist.omega * tau);
  const double moved = options.acceleration * tau * tau / 2.0;
  const double rotated = options.kAngularAcceleration * tau * tau / 2.0;
  return {arc.pose, arc.by_pose, moved * moved, rotated * rotated};
}

}  // namespace bw::localization
