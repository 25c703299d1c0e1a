#include "components/localization/particle_filter/odometry_track.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/arc.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kMaxPoses = 2048;  // 2 s at 1 kHz
constexpr double kCoverage = 0.9;        // of a step that the gyro must have seen
constexpr double kBiasMemory = 10.0;     // [s] of standing that the bias is averaged over
constexpr double kMaxVariance = 1e6;     // beyond, it says no more
constexpr double kShortDistance = 0.01;  // [m]: the direction of a shorter motion is not known

double seconds(Duration d) { return d.to_seconds(); }

Eigen::Matrix3d rotation_by(double theta) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() << std::cos(theta), -std::sin(theta), std::sin(theta), std::cos(theta);
  return R;
}

// AMCL's model (Thrun, Burgard and Fox, Probabilistic Robotics, 5.4): rotate to its direction, go, rotate
// to the end's heading, each with a noise of its own. A rotation by half a circle is driving backward, not
// noise.
Eigen::Matrix3d amcl_covariance(const Pose2& moved, const ParticleMotionOptions& o) {
  const double distance = moved.position().norm();
  const double first = distance < kShortDistance ? 0.0 : std::atan2(moved.y, moved.x);
  const double second = wrap_angle(moved.theta - first);
  const auto size = [](double rotation) {
    const double forward = std::abs(wrap_angle(rotation));
    return std::min(forward, std::numbers::pi - forward);
  };
  const double a = size(first) * size(first);
  const double b = size(second) * size(second);
  const Eigen::Vector3d along(std::cos(first), std::sin(first), 0.0);
  const Eigen::Vector3d aside(-distance * std::sin(first), distance * std::cos(first), 1.0);
  Eigen::Matrix3d C = (o.alpha3 * distance * distance + o.alpha4 * (a + b)) * along * along.transpose();
  C += (o.alpha1 * a + o.alpha2 * distance * distance) * aside * aside.transpose();
  C(2, 2) += o.alpha1 * b + o.alpha2 * distance * distance;
  return C;
}

}  // namespace

OdometryTrack::OdometryTrack(const ParticleMotionOptions& options, Duration window)
    : options_(options), window_(window), poses_(kMaxPoses) {
  restart({});
}

void OdometryTrack::restart(Time time) {
  first_ = size_ = 0;
  push(time, newest_.X_OB);
  last_wheel_ = time;
  twist_ = {};
  gyro_ = {};
  behind_ = {};
}

void OdometryTrack::push(Time time, const Pose2& X_OB) {
  newest_ = {time, X_OB};
  if (size_ == poses_.size()) {
    first_ = (first_ + 1) % poses_.size();
    --size_;
  }
  poses_[(first_ + size_) % poses_.size()] = newest_;
  ++size_;
  // One pose before the window stays, to start the interpolation from.
  while (size_ > 2 && pose(1).time < time - window_) {
    first_ = (first_ + 1) % poses_.size();
    --size_;
  }
}

Time OdometryTrack::oldest() const { return std::max(pose(0).time, newest_.time - window_); }

Pose2 OdometryTrack::at(Time time) const {
  if (time >= newest_.time) {
    const double tau = std::min(seconds(time - newest_.time), options_.kExtrapolation);
    return advance_arc(newest_.X_OB, twist_.v * tau, twist_.omega * tau);
  }
  std::size_t low = 0;  // pose(low).time <= time < pose(high).time
  std::size_t high = size_ - 1;
  if (time <= pose(0).time) return pose(0).X_OB;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (pose(middle).time <= time ? low : high) = middle;
  }
  const TimedPose& a = pose(low);
  const TimedPose& b = pose(high);
  const double part = seconds(time - a.time) / seconds(b.time - a.time);
  const Pose2 moved = inverse(a.X_OB) * b.X_OB;
  return a.X_OB * Pose2{part * moved.x, part * moved.y, part * moved.theta};
}

void OdometryTrack::add(const GyroReading& reading) {
  const double since_last = seconds(reading.time - gyro_.last);
  if (gyro_.seen && since_last <= 0.0) return;
  const double dt = std::min(since_last, seconds(reading.time - newest_.time));
  if (gyro_.seen && since_last <= options_.kGyroGap && dt > 0.0) {
    gyro_.angle += 0.5 * (gyro_.rate + reading.rate) * dt;
    gyro_.angle_variance += reading.variance * dt * dt;
    gyro_.covered += dt;
  }
  gyro_.seen = true;
  gyro_.last = reading.time;
  gyro_.rate = reading.rate;
  gyro_.variance = reading.variance;
}

// The last reading holds up to the end of the step.
void OdometryTrack::hold_gyro(Time time) {
  const double dt = seconds(time - std::max(gyro_.last, newest_.time));
  if (!gyro_.seen || dt <= 0.0 || seconds(time - gyro_.last) > options_.kGyroGap) return;
  gyro_.angle += gyro_.rate * dt;
  gyro_.angle_variance += gyro_.variance * dt * dt;
  gyro_.covered += dt;
}

void OdometryTrack::use_gyro(double dt, double& rotation, Eigen::Matrix2d& covariance, bool standing) {
  const double scale = dt / gyro_.covered;
  const double angle = gyro_.angle * scale;
  if (standing) {  // the wheels know that it does not rotate
    stood_ = std::min(stood_ + dt, kBiasMemory);
    gyro_bias_ += (angle / dt - gyro_bias_) * std::min(1.0, dt / stood_);
    return;
  }
  rotation = angle - gyro_bias_ * dt;
  const double bias = options_.gyro_bias_sigma * dt;
  covariance(1, 1) = gyro_.angle_variance * scale * scale + bias * bias;
  covariance(0, 1) = covariance(1, 0) = 0.0;
}

bool OdometryTrack::add(const WheelStep& step) {
  const Duration ahead = step.time - newest_.time;
  if (ahead.nanoseconds <= 0) return false;
  if (seconds(ahead - step.over) > options_.kExtrapolation) advance_unknown(step.time - step.over);
  const Duration span = step.time - newest_.time;
  const double dt = seconds(span);
  const double part = span == step.over ? 1.0 : dt / seconds(step.over);
  double distance = step.distance * part;
  double rotation = step.rotation * part;
  Eigen::Matrix2d covariance = step.covariance * std::max(part, part * part);  // what is extended is guessed
  hold_gyro(step.time);
  if (gyro_.covered >= kCoverage * dt) use_gyro(dt, rotation, covariance, distance == 0.0 && rotation == 0.0);
  gyro_.angle = gyro_.angle_variance = gyro_.covered = 0.0;

  const ArcStep arc = arc_step(behind_.X_BB, distance, rotation);
  Eigen::Matrix3d C = arc.by_pose * behind_.covariance * arc.by_pose.transpose();
  if (options_.noise == MotionNoise::declared || options_.noise == MotionNoise::both)
    C += arc.by_step * covariance * arc.by_step.transpose();
  if (options_.noise == MotionNoise::per_step) {
    const Eigen::Vector3d sigma(options_.kStepAlong, options_.kStepAcross, options_.kStepHeading);
    const Eigen::Matrix3d R = rotation_by(arc.pose.theta);
    C += R * sigma.cwiseAbs2().asDiagonal() * R.transpose();
  }
  C.diagonal() += dt * Eigen::Vector3d(options_.walk, options_.walk, options_.heading_walk).cwiseAbs2();
  behind_.covariance = C.cwiseMin(kMaxVariance).cwiseMax(-kMaxVariance);
  behind_.X_BB = arc.pose;
  behind_.distance += std::abs(distance);
  behind_.rotation += std::abs(rotation);

  odometer_ += std::abs(distance);
  twist_ = {distance / dt, rotation / dt};
  push(step.time, advance_arc(newest_.X_OB, distance, rotation));
  last_wheel_ = step.time;
  return true;
}

void OdometryTrack::bridge_silence(Time time) {
  if (seconds(time - last_wheel_) > options_.kExtrapolation) advance_unknown(time);
}

void OdometryTrack::advance_unknown(Time time) {
  const double dt = seconds(time - newest_.time);
  if (dt <= 0.0) return;
  const double before = seconds(newest_.time - std::min(last_wheel_, newest_.time));
  const double squares = (before + dt) * (before + dt) - before * before;  // of a speed that stays unknown
  const double position = options_.kSilentSpeed * options_.kSilentSpeed * squares;
  const double heading = options_.kSilentTurnRate * options_.kSilentTurnRate * squares;
  behind_.covariance.diagonal() += Eigen::Vector3d(position, position, heading);
  behind_.covariance.diagonal() = behind_.covariance.diagonal().cwiseMin(kMaxVariance);
  behind_.covariance(2, 2) = std::min(behind_.covariance(2, 2), 10.0);  // any heading at all
  odometer_ += options_.kSilentSpeed * dt;
  twist_ = {};
  gyro_.angle = gyro_.angle_variance = gyro_.covered = 0.0;
  push(time, newest_.X_OB);
}

UncertainMotion OdometryTrack::behind() const {
  UncertainMotion motion = behind_;
  if (options_.noise == MotionNoise::amcl || options_.noise == MotionNoise::both)
    motion.covariance += amcl_covariance(behind_.X_BB, options_);
  return motion;
}

void OdometryTrack::follow() { behind_ = {}; }

}  // namespace bw::localization
