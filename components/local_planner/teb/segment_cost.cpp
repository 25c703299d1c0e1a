#include "components/local_planner/teb/segment_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bw::teb {
namespace {

constexpr double kShortestInterval = 1e-3;  // [s] guard of the divisions by dt
constexpr double kSignSharpness = 100.0;  // [1/m] of the smoothed sign of the speed, as in the public package

enum Residual : std::size_t {
  kTime,
  kKinematics,
  kForward,
  kSpeed,
  kTurnRate,
  kAcceleration,
  kAngularAcceleration,
  kFirstAcceleration,
  kFirstAngularAcceleration,
};
enum Column : std::size_t { kX, kY, kTheta, kDt, kNextX, kNextY, kNextTheta };

using Quantity = SegmentMotion::Quantity;

struct Hinge {
  double value;
  double slope;
};

// How far z leaves [low, high], each side drawn in by epsilon but never past zero: standing still is always
// free.
Hinge outside(double z, double low, double high, double epsilon) {
  const double below = std::min(low + epsilon, 0.0) - z;
  const double above = z - std::max(high - epsilon, 0.0);
  if (below > 0.0) return {below, -1.0};
  if (above > 0.0) return {above, 1.0};
  return {0.0, 0.0};
}

// dir(theta_a + rotation / 2): the bisector of both headings, unless they are too far apart to have one.
Vector2 mean_direction(const Heading& a, const Heading& b, double rotation) {
  constexpr double kLargestRotation = 2.5;  // [rad]
  if (std::abs(rotation) > kLargestRotation) return direction(a.pose[2] + rotation / 2.0);
  return (a.u + b.u).normalized();
}

// v = d . dir(mean heading) / dt
void project_speed(const Vector2& d, const Vector2& u, double dt, Quantity& v) {
  const double half_slope = cross(u, d) / (2.0 * dt);
  v.value = d.dot(u) / dt;
  v.gradient = {-u.x() / dt, -u.y() / dt, half_slope, -v.value / dt, u.x() / dt, u.y() / dt, half_slope};
}

// v = |d| / dt * z / (1 + |z|), z = 100 d . dir(heading of the first pose)
void signed_length_speed(const Vector2& d, const Vector2& u, double dt, Quantity& v) {
  const double z = kSignSharpness * d.dot(u);
  const double sign = z / (1.0 + std::abs(z));
  const double length = std::sqrt(d.squaredNorm() + 1e-18);  // differentiable for coincident poses
  const double sign_slope = length / dt * kSignSharpness / ((1.0 + std::abs(z)) * (1.0 + std::abs(z)));
  const Vector2 slope = d * (sign / (length * dt)) + sign_slope * u;
  v.value = length / dt * sign;
  v.gradient = {-slope.x(), -slope.y(), sign_slope * cross(u, d), -v.value / dt, slope.x(), slope.y(), 0.0};
}

// Where an evaluation goes: residuals, and their derivatives if they are asked for.
struct Output {
  std::array<double, kSegmentResiduals>& residuals;
  SegmentRows* rows;

  double* new_row(Residual r) const {
    rows->of_row[rows->active] = r;
    std::array<double, kSegmentColumns>& row = rows->jacobian[rows->active++];
    row.fill(0.0);
    return row.data();
  }
};

// Adds scale times the gradient of a quantity of the segment whose first column is `offset`.
void add(double* row, double scale, const Quantity& q, std::size_t offset) {
  for (std::size_t i = 0; i < SegmentMotion::kInputs; ++i) row[offset + i] += scale * q.gradient[i];
}

// What accelerations are held to.
struct AccelerationLimit {
  double limit;
  double weight;
  double epsilon;
};

// a = 2 (v_next - v) / (dt + dt_next)
void evaluate_change(const Quantity& q, const Quantity& next, double dt_sum, const AccelerationLimit& allowed,
                     Residual r, const Output& out) {
  const double acceleration = 2.0 * (next.value - q.value) / dt_sum;
  const Hinge hinge = outside(acceleration, -allowed.limit, allowed.limit, allowed.epsilon);
  out.residuals[r] = allowed.weight * hinge.value;
  if (out.rows == nullptr || hinge.slope == 0.0) return;
  const double scale = allowed.weight * hinge.slope * 2.0 / dt_sum;
  double* row = out.new_row(r);
  add(row, -scale, q, 0);
  add(row, scale, next, 4);
  row[3] -= allowed.weight * hinge.slope * acceleration / dt_sum;
  row[7] -= allowed.weight * hinge.slope * acceleration / dt_sum;
}

// What one end of the band asks of the velocity next to it: a = sign (q - reference) / span, from the start
// velocity (sign 1), or to rest (sign -1, reference 0).
struct BandEnd {
  double sign;
  double span;  // [s]
  double dt;    // [s] of the segment
};

void evaluate_end(const Quantity& q, double reference, const BandEnd& end, const AccelerationLimit& allowed,
                  Residual r, const Output& out) {
  const double acceleration = end.sign * (q.value - reference) / end.span;
  const Hinge hinge = outside(acceleration, -allowed.limit, allowed.limit, allowed.epsilon);
  out.residuals[r] = allowed.weight * hinge.value;
  if (out.rows == nullptr || hinge.slope == 0.0) return;
  double* row = out.new_row(r);
  add(row, allowed.weight * hinge.slope * end.sign / end.span, q, 0);
  row[kDt] -= allowed.weight * hinge.slope * acceleration / end.dt;
}

// Time, and the shape of the segment: both poses on one arc, driven forward.
void evaluate_shape(const SegmentModel& model, const Heading& a, const Heading& b, const Output& out) {
  const Vector2 d(b.pose[0] - a.pose[0], b.pose[1] - a.pose[1]);
  const Vector2 u_sum = a.u + b.u;
  const double forward = d.dot(a.u);
  out.residuals[kTime] = model.time * a.pose[3];
  out.residuals[kKinematics] = model.kinematics_nh * cross(u_sum, d);
  out.residuals[kForward] = model.forward_drive * std::max(0.0, -forward);
  if (out.rows == nullptr) return;
  out.new_row(kTime)[kDt] = model.time;
  const double w = model.kinematics_nh;
  double* h = out.new_row(kKinematics);
  h[kX] = w * u_sum.y();
  h[kY] = -w * u_sum.x();
  h[kTheta] = -w * a.u.dot(d);
  h[kNextX] = -h[kX];
  h[kNextY] = -h[kY];
  h[kNextTheta] = -w * b.u.dot(d);
  if (!(forward < 0.0)) return;
  const double f = model.forward_drive;
  double* backward = out.new_row(kForward);
  backward[kX] = f * a.u.x();
  backward[kY] = f * a.u.y();
  backward[kTheta] = -f * cross(a.u, d);
  backward[kNextX] = -backward[kX];
  backward[kNextY] = -backward[kY];
}

void evaluate_speeds(const SegmentModel& model, const SegmentMotion& motion, const Output& out) {
  const Limits& limits = model.limits;
  const Hinge v = outside(motion.v.value, -limits.v_back_max, limits.v_max, model.epsilon);
  const Hinge omega = outside(motion.omega.value, -limits.omega_max, limits.omega_max, model.epsilon);
  out.residuals[kSpeed] = model.max_vel_x * v.value;
  out.residuals[kTurnRate] = model.max_vel_theta * omega.value;
  if (out.rows == nullptr) return;
  if (v.slope != 0.0) add(out.new_row(kSpeed), model.max_vel_x * v.slope, motion.v, 0);
  if (omega.slope != 0.0) add(out.new_row(kTurnRate), model.max_vel_theta * omega.slope, motion.omega, 0);
}

// To the next segment or to rest, and from the start velocity.
void evaluate_accelerations(const SegmentModel& model, const SegmentStates& states, const Output& out) {
  const AccelerationLimit linear{model.limits.acc_max, model.acc_lim_x, model.epsilon};
  const AccelerationLimit angular{model.limits.alpha_max, model.acc_lim_theta, model.epsilon};
  const SegmentMotion& motion = states.motion;
  const double span = model.consistent_motion ? motion.dt / 2.0 : motion.dt;
  if (states.end == SegmentEnd::next_segment) {
    const double dt_sum = motion.dt + states.next->dt;
    evaluate_change(motion.v, states.next->v, dt_sum, linear, kAcceleration, out);
    evaluate_change(motion.omega, states.next->omega, dt_sum, angular, kAngularAcceleration, out);
  } else if (states.end == SegmentEnd::rest) {
    evaluate_end(motion.v, 0.0, {-1.0, span, motion.dt}, linear, kAcceleration, out);
    evaluate_end(motion.omega, 0.0, {-1.0, span, motion.dt}, angular, kAngularAcceleration, out);
  }
  if (states.start_twist == nullptr) return;
  const BandEnd start{1.0, span, motion.dt};
  evaluate_end(motion.v, states.start_twist->v, start, linear, kFirstAcceleration, out);
  evaluate_end(motion.omega, states.start_twist->omega, start, angular, kFirstAngularAcceleration, out);
}

void evaluate(const SegmentModel& model, const SegmentStates& states, const Output& out) {
  out.residuals.fill(0.0);
  evaluate_shape(model, states.a, states.b, out);
  evaluate_speeds(model, states.motion, out);
  evaluate_accelerations(model, states, out);
}

}  // namespace

SegmentModel::SegmentModel(const BandOptions& options, const Limits& motion_limits)
    : limits(motion_limits),
      epsilon(options.penalty_epsilon),
      consistent_motion(options.consistent_motion),
      time(std::sqrt(options.weights.time)),
      kinematics_nh(std::sqrt(options.weights.kinematics_nh)),
      forward_drive(std::sqrt(options.weights.forward_drive)),
      max_vel_x(std::sqrt(options.weights.max_vel_x)),
      max_vel_theta(std::sqrt(options.weights.max_vel_theta)),
      acc_lim_x(std::sqrt(options.weights.acc_lim_x)),
      acc_lim_theta(std::sqrt(options.weights.acc_lim_theta)) {}

bool evaluate_motion(const SegmentModel& model, const Heading& a, const Heading& b, SegmentMotion& motion) {
  const double dt = a.pose[3];
  if (!(dt > kShortestInterval)) return false;
  const Vector2 d(b.pose[0] - a.pose[0], b.pose[1] - a.pose[1]);
  const double rotation = wrap_angle(b.pose[2] - a.pose[2]);
  motion.dt = dt;
  if (model.consistent_motion) {
    project_speed(d, mean_direction(a, b, rotation), dt, motion.v);
  } else {
    signed_length_speed(d, a.u, dt, motion.v);
  }
  motion.omega.value = rotation / dt;
  motion.omega.gradient = {0.0, 0.0, -1.0 / dt, -motion.omega.value / dt, 0.0, 0.0, 1.0 / dt};
  return true;
}

void evaluate_segment(const SegmentModel& model, const SegmentStates& states, SegmentRows& rows) {
  rows.active = 0;
  evaluate(model, states, {rows.residuals, &rows});
}

double segment_cost(const SegmentModel& model, const SegmentStates& states) {
  std::array<double, kSegmentResiduals> residuals;
  evaluate(model, states, {residuals, nullptr});
  double sum = 0.0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

}  // namespace bw::teb
