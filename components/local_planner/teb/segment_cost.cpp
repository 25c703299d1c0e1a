#include "components/local_planner/teb/segment_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bw::teb {
namespace {

constexpr double kShortestInterval = 1e-3;  // [s] guard of the divisions by dt
constexpr double kSignSharpness = 100.0;  // [1/m] of the smoothed sign of the speed, as in the public package

enum Column { kX, kY, kTheta, kDt, kNextX, kNextY, kNextTheta, kSegmentInputs };

// A quantity of one segment with its derivatives.
struct Quantity {
  double value = 0.0;
  std::array<double, kSegmentInputs> gradient{};
};

struct Motion {
  Quantity v;
  Quantity omega;
};

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

// One pose with the direction of its heading: computed once per evaluation, as it is what takes longest.
struct Heading {
  const double* pose;
  Vector2 u;
};

Heading heading_of(const double* pose) { return {pose, direction(pose[2])}; }

// dir(theta_a + turn / 2): the bisector of both headings, unless they are too far apart to have one.
Vector2 mean_direction(const Heading& a, const Heading& b, double turn) {
  constexpr double kLargestTurn = 2.5;  // [rad]
  if (std::abs(turn) > kLargestTurn) return direction(a.pose[2] + turn / 2.0);
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

Motion motion_of(const Heading& a, const Heading& b, bool consistent_motion) {
  const Vector2 d(b.pose[0] - a.pose[0], b.pose[1] - a.pose[1]);
  const double turn = wrap_angle(b.pose[2] - a.pose[2]);
  const double dt = a.pose[3];
  Motion m;
  if (consistent_motion) {
    project_speed(d, mean_direction(a, b, turn), dt, m.v);
  } else {
    signed_length_speed(d, a.u, dt, m.v);
  }
  m.omega.value = turn / dt;
  m.omega.gradient = {0.0, 0.0, -1.0 / dt, -m.omega.value / dt, 0.0, 0.0, 1.0 / dt};
  return m;
}

// Writes weight * hinge of a quantity of the segment whose first column is `offset`.
void add_row(double* row, double scale, const Quantity& q, int offset) {
  for (int i = 0; i < kSegmentInputs; ++i) row[offset + i] += scale * q.gradient[static_cast<std::size_t>(i)];
}

// a = 2 (v_next - v) / (dt + dt_next)
void evaluate_change(const Quantity& q, const Quantity& next, double dt_sum, double limit, double weight,
                     double epsilon, double& residual, double* row) {
  const double acceleration = 2.0 * (next.value - q.value) / dt_sum;
  const Hinge hinge = outside(acceleration, -limit, limit, epsilon);
  residual = weight * hinge.value;
  if (row == nullptr || hinge.slope == 0.0) return;
  const double scale = weight * hinge.slope * 2.0 / dt_sum;
  add_row(row, -scale, q, 0);
  add_row(row, scale, next, 4);
  row[3] -= weight * hinge.slope * acceleration / dt_sum;
  row[7] -= weight * hinge.slope * acceleration / dt_sum;
}

// a = sign (q - reference) / span: from the start velocity (sign 1), or to rest (sign -1, reference 0)
void evaluate_end(const Quantity& q, double reference, double sign, double span, double limit, double weight,
                  double epsilon, double dt, double& residual, double* row) {
  const double acceleration = sign * (q.value - reference) / span;
  const Hinge hinge = outside(acceleration, -limit, limit, epsilon);
  residual = weight * hinge.value;
  if (row == nullptr || hinge.slope == 0.0) return;
  add_row(row, weight * hinge.slope * sign / span, q, 0);
  row[kDt] -= weight * hinge.slope * acceleration / dt;
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

bool evaluate_segment(const SegmentModel& model, const SegmentStates& states, double* residuals,
                      double* jacobian) {
  const double* a = states.a;
  const double* b = states.b;
  const double dt = a[3];
  const bool has_next = states.end == SegmentEnd::next_segment;
  if (!(dt > kShortestInterval) || (has_next && !(b[3] > kShortestInterval))) return false;
  std::fill(residuals, residuals + kSegmentResiduals, 0.0);
  if (jacobian != nullptr) std::fill(jacobian, jacobian + kSegmentResiduals * kSegmentColumns, 0.0);
  const auto row = [&](std::size_t r) {
    return jacobian == nullptr ? nullptr : jacobian + r * kSegmentColumns;
  };

  const Vector2 d(b[0] - a[0], b[1] - a[1]);
  const Heading at_a = heading_of(a);
  const Heading at_b = heading_of(b);
  const Vector2& u_a = at_a.u;
  const Vector2& u_b = at_b.u;
  const Vector2 u_sum = u_a + u_b;
  residuals[0] = model.time * dt;
  residuals[1] = model.kinematics_nh * cross(u_sum, d);
  const double forward = d.dot(u_a);
  residuals[2] = model.forward_drive * std::max(0.0, -forward);
  if (jacobian != nullptr) {
    row(0)[kDt] = model.time;
    const double w = model.kinematics_nh;
    double* h = row(1);
    h[0] = w * u_sum.y();
    h[1] = -w * u_sum.x();
    h[2] = -w * u_a.dot(d);
    h[4] = -h[0];
    h[5] = -h[1];
    h[6] = -w * u_b.dot(d);
    if (forward < 0.0) {
      const double f = model.forward_drive;
      double* backward = row(2);
      backward[0] = f * u_a.x();
      backward[1] = f * u_a.y();
      backward[2] = -f * cross(u_a, d);
      backward[4] = -backward[0];
      backward[5] = -backward[1];
    }
  }

  const Motion motion = motion_of(at_a, at_b, model.consistent_motion);
  const Limits& limits = model.limits;
  const Hinge v = outside(motion.v.value, -limits.v_back_max, limits.v_max, model.epsilon);
  const Hinge omega = outside(motion.omega.value, -limits.omega_max, limits.omega_max, model.epsilon);
  residuals[3] = model.max_vel_x * v.value;
  residuals[4] = model.max_vel_theta * omega.value;
  if (jacobian != nullptr) {
    if (v.slope != 0.0) add_row(row(3), model.max_vel_x * v.slope, motion.v, 0);
    if (omega.slope != 0.0) add_row(row(4), model.max_vel_theta * omega.slope, motion.omega, 0);
  }

  const double span = model.consistent_motion ? dt / 2.0 : dt;
  if (has_next) {
    const Motion next = motion_of(at_b, heading_of(states.c), model.consistent_motion);
    const double dt_sum = dt + b[3];
    evaluate_change(motion.v, next.v, dt_sum, limits.acc_max, model.acc_lim_x, model.epsilon, residuals[5],
                    row(5));
    evaluate_change(motion.omega, next.omega, dt_sum, limits.alpha_max, model.acc_lim_theta, model.epsilon,
                    residuals[6], row(6));
  } else if (states.end == SegmentEnd::rest) {
    evaluate_end(motion.v, 0.0, -1.0, span, limits.acc_max, model.acc_lim_x, model.epsilon, dt, residuals[5],
                 row(5));
    evaluate_end(motion.omega, 0.0, -1.0, span, limits.alpha_max, model.acc_lim_theta, model.epsilon, dt,
                 residuals[6], row(6));
  }
  if (states.start_twist != nullptr) {
    evaluate_end(motion.v, states.start_twist->v, 1.0, span, limits.acc_max, model.acc_lim_x, model.epsilon,
                 dt, residuals[7], row(7));
    evaluate_end(motion.omega, states.start_twist->omega, 1.0, span, limits.alpha_max, model.acc_lim_theta,
                 model.epsilon, dt, residuals[8], row(8));
  }
  return true;
}

}  // namespace bw::teb
