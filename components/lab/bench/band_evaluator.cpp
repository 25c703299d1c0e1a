#include "components/lab/bench/band_evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bw {
namespace {

constexpr double kSignSharpness = 100.0;  // [1/m]
constexpr int kPointsPerSegment = 10;

double out(double z, double low, double high, double epsilon) {
  return std::max(0.0, low + epsilon - z) + std::max(0.0, z - (high - epsilon));
}
double under(double z, double limit, double epsilon) { return std::max(0.0, limit + epsilon - z); }
double square(double z) { return z * z; }

double distance(const Vector2& p, const SceneObstacle& o, double time) {
  return (p - o.position - time * o.velocity).norm() - o.radius;
}

// Excess of the accelerations between successive speeds, and their cost.
struct Changes {
  double excess = 0.0;
  double cost = 0.0;
};

Changes evaluate_changes(const std::vector<double>& speed, const std::vector<EvaluatedPose>& band,
                         double start, double limit, double epsilon) {
  Changes changes;
  const auto add = [&](double acceleration) {
    changes.excess = std::max(changes.excess, std::abs(acceleration) - limit);
    changes.cost += square(out(acceleration, -limit, limit, epsilon));
  };
  add((speed.front() - start) / band.front().dt);
  for (std::size_t i = 0; i + 1 < speed.size(); ++i)
    add(2.0 * (speed[i + 1] - speed[i]) / (band[i].dt + band[i + 1].dt));
  add(-speed.back() / band[speed.size() - 1].dt);
  return changes;
}

// Time, shape and speed of one segment.
void evaluate_segment(const EvaluatedPose& from, const Pose2& b, const Twist2& twist, const SceneFile& rules,
                      BandQuality& q) {
  const Limits& limits = rules.limits;
  const SceneWeights& w = rules.weights;
  const double epsilon = w.penalty_epsilon;
  const Pose2& a = from.pose;
  const Vector2 d = b.position() - a.position();
  const double h =
      (std::cos(a.theta) + std::cos(b.theta)) * d.y() - (std::sin(a.theta) + std::sin(b.theta)) * d.x();
  q.max_nonholonomic = std::max(q.max_nonholonomic, std::abs(h));
  q.excess_v = std::max({q.excess_v, twist.v - limits.v_max, -limits.v_back_max - twist.v});
  q.excess_omega = std::max(q.excess_omega, std::abs(twist.omega) - limits.omega_max);
  q.cost.time += w.time * square(from.dt);
  q.cost.nonholonomic +=
      w.kinematics_nh * square(h) + w.forward_drive * square(under(d.dot(direction(a.theta)), 0.0, 0.0));
  q.cost.velocity += w.max_vel_x * square(out(twist.v, -limits.v_back_max, limits.v_max, epsilon)) +
                     w.max_vel_theta * square(out(twist.omega, -limits.omega_max, limits.omega_max, epsilon));
}

// Distances from the obstacles along the segment that begins at q.time; costs at its first pose, unless that
// is the start of the band, which nothing can move.
void evaluate_clearance(const EvaluatedPose& from, const Pose2& b, bool is_start, const SceneFile& rules,
                        const std::vector<SceneObstacle>& obstacles, BandQuality& q) {
  const SceneWeights& w = rules.weights;
  const Vector2 a = from.pose.position();
  const Vector2 d = b.position() - a;
  for (const SceneObstacle& o : obstacles) {
    const double at_pose = distance(a, o, q.time);
    q.clearance_poses = std::min(q.clearance_poses, at_pose);
    for (int k = 0; k < kPointsPerSegment; ++k) {
      const double s = static_cast<double>(k) / kPointsPerSegment;
      q.clearance_segments = std::min(q.clearance_segments, distance(a + s * d, o, q.time + s * from.dt));
    }
    if (is_start) continue;
    const bool moves = o.moves();
    q.cost.obstacle +=
        (moves ? w.dynamic_obstacle : w.obstacle) *
            square(under(at_pose, rules.min_dist, w.penalty_epsilon)) +
        (moves ? w.dynamic_inflation : w.inflation) *
            square(under(at_pose, moves ? rules.dynamic_inflation_dist : rules.inflation_dist, 0.0));
  }
}

}  // namespace

Twist2 segment_twist(const EvaluatedPose& a, const EvaluatedPose& b) {
  const Vector2 d = b.pose.position() - a.pose.position();
  const double z = kSignSharpness * d.dot(direction(a.pose.theta));
  return {d.norm() / a.dt * z / (1.0 + std::abs(z)), wrap_angle(b.pose.theta - a.pose.theta) / a.dt};
}

BandQuality evaluate_band(const std::vector<EvaluatedPose>& band, const Twist2& start, const SceneFile& rules,
                          const std::vector<SceneObstacle>& obstacles) {
  BandQuality q;
  q.clearance_poses = q.clearance_segments = std::numeric_limits<double>::infinity();
  if (band.size() < 2) return q;
  std::vector<double> v, omega;
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    const Twist2 twist = segment_twist(band[i], band[i + 1]);
    v.push_back(twist.v);
    omega.push_back(twist.omega);
    evaluate_segment(band[i], band[i + 1].pose, twist, rules, q);
    evaluate_clearance(band[i], band[i + 1].pose, i == 0, rules, obstacles, q);
    q.time += band[i].dt;
  }
  for (const SceneObstacle& o : obstacles)
    q.clearance_poses = std::min(q.clearance_poses, distance(band.back().pose.position(), o, q.time));
  const double epsilon = rules.weights.penalty_epsilon;
  const Changes a = evaluate_changes(v, band, start.v, rules.limits.acc_max, epsilon);
  const Changes alpha = evaluate_changes(omega, band, start.omega, rules.limits.alpha_max, epsilon);
  q.excess_a = a.excess;
  q.excess_alpha = alpha.excess;
  q.cost.acceleration = rules.weights.acc_lim_x * a.cost + rules.weights.acc_lim_theta * alpha.cost;
  return q;
}

std::vector<EvaluatedPose> to_band(const std::vector<TrajectoryPoint>& trajectory) {
  std::vector<EvaluatedPose> band;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const bool last = i + 1 == trajectory.size();
    band.push_back({trajectory[i].pose, last ? 0.0 : trajectory[i + 1].time - trajectory[i].time});
  }
  return band;
}

}  // namespace bw
