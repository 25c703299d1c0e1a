// Random scenes for tests of every planner, the same scene seen otherwise (rotated, shifted, mirrored, listed
// in another order), and results compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/planning.hpp"
#include "components/model/random.hpp"

namespace bw {

inline Vector2 random_point(Random& random, double reach) {
  const double x = random.uniform(-reach, reach);  // arguments of a call have no order
  return {x, random.uniform(-reach, reach)};
}

inline std::size_t random_index(Random& random, std::size_t count) {
  return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(count)), count - 1);
}

inline Mover random_mover(Random& random, double reach) {
  Mover mover;
  mover.position = random_point(random, reach);
  mover.velocity = random_point(random, 1.0);
  mover.radius = random.uniform(0.15, 0.4);
  mover.reciprocal = random.uniform() < 0.3;
  if (random.uniform() < 0.5) return mover;
  Vector2 p = mover.position;
  for (int k = 1; k <= 6; ++k) {
    p += 0.4 * mover.velocity + random_point(random, 0.05);
    mover.predictions.push_back({0.4 * k, p, 0.01 * k * Eigen::Matrix2d::Identity()});
  }
  return mover;
}

/// About 6 m of a winding plan among points, discs, walls and people; the robot at its beginning, moving.
inline PlanningProblem random_scene(Random& random) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.pose = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-1.0, 1.0)};
  problem.twist = {random.uniform(0.0, 1.0), random.uniform(-0.8, 0.8)};
  Pose2 at{0.0, 0.0, random.uniform(-0.5, 0.5)};
  for (int i = 0; i < 7; ++i) {
    problem.plan.push_back(at);
    at = advance_exact(at, {1.0, random.uniform(-0.4, 0.4)}, 1.0);
  }
  problem.goal_is_final = random.uniform() < 0.5;
  const auto somewhere = [&] { return Vector2(Vector2(3.0, 0.0) + random_point(random, 3.5)); };
  const auto several = [&](std::size_t most) { return random_index(random, most + 1); };
  for (std::size_t i = several(8); i > 0; --i) problem.obstacles.points.push_back(somewhere());
  for (std::size_t i = several(4); i > 0; --i) {
    const Vector2 center = somewhere();
    problem.obstacles.discs.push_back({center, random.uniform(0.05, 0.5)});
  }
  for (std::size_t i = several(2); i > 0; --i) {
    const Vector2 a = somewhere();
    problem.obstacles.segments.push_back({a, a + random_point(random, 1.5)});
  }
  for (std::size_t i = several(4); i > 0; --i) {
    Mover mover = random_mover(random, 3.5);
    mover.id = static_cast<std::uint32_t>(i);
    mover.position.x() += 3.0;
    for (PredictedPosition& p : mover.predictions) p.position.x() += 3.0;
    problem.movers.push_back(std::move(mover));
  }
  return problem;
}

/// A control period later: the robot did as `command` says, movers as they were expected to.
inline void advance_scene(PlanningProblem& problem, const Twist2& command) {
  const double period = problem.control_period;
  problem.twist = command;
  problem.pose = advance_exact(problem.pose, command, period);
  problem.now = problem.now + Duration::seconds(period);
  for (Mover& mover : problem.movers) {
    mover.position = mover.position_at(period);
    for (PredictedPosition& p : mover.predictions) p.time -= period;
  }
}

/// Every pose, point (p), free vector (v) and covariance of the scene through the given maps.
template <class MapPose, class MapPoint, class MapVector, class MapCovariance>
PlanningProblem seen_otherwise(PlanningProblem problem, MapPose&& pose, MapPoint&& p, MapVector&& v,
                               MapCovariance&& covariance) {
  problem.pose = pose(problem.pose);
  for (Pose2& x : problem.plan) x = pose(x);
  for (Vector2& x : problem.obstacles.points) x = p(x);
  for (Disc& disc : problem.obstacles.discs) disc.center = p(disc.center);
  for (Segment& segment : problem.obstacles.segments) segment = {p(segment.a), p(segment.b)};
  for (Mover& mover : problem.movers) {
    mover.position = p(mover.position);
    mover.velocity = v(mover.velocity);
    for (PredictedPosition& x : mover.predictions) {
      x.position = p(x.position);
      x.covariance = covariance(x.covariance);
    }
  }
  return problem;
}

/// In a frame N in which the old one has the pose `X_NO`.
inline PlanningProblem moved(const PlanningProblem& problem, const Pose2& X_NO) {
  Eigen::Matrix2d R;
  R << direction(X_NO.theta), rotate(X_NO, Vector2(0.0, 1.0));
  return seen_otherwise(
      problem, [&](const Pose2& x) { return X_NO * x; }, [&](const Vector2& x) { return X_NO * x; },
      [&](const Vector2& x) { return rotate(X_NO, x); },
      [&](const Eigen::Matrix2d& c) -> Eigen::Matrix2d { return R * c * R.transpose(); });
}

/// In a mirror along the x axis: exact, a sign changes no digit.
inline PlanningProblem mirrored(const PlanningProblem& problem) {
  const auto flip = [](const Vector2& x) { return Vector2(x.x(), -x.y()); };
  PlanningProblem result = seen_otherwise(
      problem,
      [](const Pose2& x) {
        return Pose2{x.x, -x.y, -x.theta};
      },
      flip, flip,
      [](Eigen::Matrix2d c) {
        c(0, 1) = -c(0, 1);
        c(1, 0) = -c(1, 0);
        return c;
      });
  result.twist.omega = -result.twist.omega;
  for (Vector2& corner : result.footprint.polygon) corner.y() = -corner.y();
  std::reverse(result.footprint.polygon.begin(), result.footprint.polygon.end());
  return result;
}

template <class T>
void shuffle(std::vector<T>& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random_index(random, i)]);
}

/// The same obstacles and movers in another order.
inline PlanningProblem shuffled(PlanningProblem problem, Random& random) {
  shuffle(problem.obstacles.points, random);
  shuffle(problem.obstacles.discs, random);
  shuffle(problem.obstacles.segments, random);
  shuffle(problem.movers, random);
  return problem;
}

/// Empty when both are the same to the last bit; else the first thing in which they differ.
inline std::string difference(const PlanningResult& a, const PlanningResult& b) {
  const auto differ = [](const std::vector<TrajectoryPoint>& l, const std::vector<TrajectoryPoint>& r) {
    return !std::equal(l.begin(), l.end(), r.begin(), r.end(),
                       [](const TrajectoryPoint& p, const TrajectoryPoint& q) {
                         return p.time == q.time && p.pose == q.pose && p.twist == q.twist;
                       });
  };
  if (a.status != b.status || a.reason != b.reason) return "status '" + a.reason + "', '" + b.reason + "'";
  if (!(a.command == b.command)) return "command";
  if (a.iterations != b.iterations) return "iterations";
  if (differ(a.trajectory, b.trajectory)) return "trajectory";
  if (a.velocity_wanted != b.velocity_wanted) return "velocity_wanted";
  if (a.velocity_cones.size() != b.velocity_cones.size()) return "number of cones";
  for (std::size_t i = 0; i < a.velocity_cones.size(); ++i) {
    const VelocityCone &c = a.velocity_cones[i], &d = b.velocity_cones[i];
    if (c.apex != d.apex || c.right != d.right || c.left != d.left) return "cone " + std::to_string(i);
  }
  if (a.candidates.size() != b.candidates.size()) return "number of candidates";
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    const Candidate &c = a.candidates[i], &d = b.candidates[i];
    if (c.label != d.label || c.cost != d.cost || c.chosen != d.chosen ||
        differ(c.trajectory, d.trajectory)) {
      return "candidate " + std::to_string(i) + " " + c.label + ", " + d.label;
    }
  }
  return {};
}

}  // namespace bw
