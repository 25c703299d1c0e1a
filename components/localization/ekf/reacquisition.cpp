#include "components/localization/ekf/reacquisition.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/arc.hpp"
#include "components/model/chi_square.hpp"

namespace bw::localization {
namespace {

constexpr double kDistanceSlack = 1.1;    // wheels may measure a distance this much short
constexpr double kRotationSlack = 0.1;    // and a rotation
constexpr int kMisfits = 3;               // in a row end a run
constexpr double kKnownHeading = 0.0625;  // (0.25 rad)^2: a heading from a path is worth taking

struct Odometry {
  Pose2 X_OB;
  double odometer;
  double rotated;
};

Odometry odometry_at(const EkfState& state, Time time) {
  const double tau = std::max(0.0, (time - state.time).to_seconds());
  const double distance = state.twist.v * tau;
  const double rotation = state.twist.omega * tau;
  return {advance_arc(state.X_OB, distance, rotation), state.odometer + std::abs(distance),
          state.rotated + rotation};
}

bool agrees(const RejectedRun& run, const Rejection& r, const Odometry& now, double probability) {
  if (r.position) {
    const double noise = std::sqrt(2.0 * chi_square_quantile(probability, 2) * r.position_variance);
    const double distance = kDistanceSlack * (now.odometer - run.odometer);
    if ((*r.position - run.position).norm() > distance + noise) return false;
  }
  if (r.heading) {
    const double noise = std::sqrt(2.0 * chi_square_quantile(probability, 1) * r.heading_variance);
    const double rotation = now.rotated - run.rotated;
    if (std::abs(wrap_angle(*r.heading - run.heading - rotation)) >
        noise + kRotationSlack * std::abs(rotation))
      return false;
  }
  return true;
}

void append(RejectedRun& run, const Rejection& r, const Odometry& now) {
  ++run.count;
  run.misfits = 0;
  run.odometer = now.odometer;
  run.rotated = now.rotated;
  if (r.position) {
    run.position = *r.position;
    run.fit.add(*r.position, now.X_OB * r.antenna);
  }
  if (r.heading) run.heading = *r.heading;
}

bool supported_by_others(const EkfState& state, const Rejection& r, const RejectedRun& run,
                         const GateOptions& options) {
  for (std::size_t i = 0; i < state.sources.size(); ++i) {
    const SourceState& other = state.sources[i];
    if (static_cast<int>(i) == r.source || other.last_trusted < run.since) continue;
    if (r.position && other.gives_position) return true;
    if (!r.position && r.heading && other.gives_heading) return true;
    const double driven = state.odometer - run.start_odometer;
    if (!r.position && other.gives_position && driven >= options.kHeadingSupport) return true;
  }
  return false;
}

bool heading_supported(const EkfState& state, int source, Time since) {
  for (std::size_t i = 0; i < state.sources.size(); ++i) {
    const SourceState& other = state.sources[i];
    if (static_cast<int>(i) != source && other.gives_heading && other.last_used >= since) return true;
  }
  return false;
}

void replace(EkfState& state, int first, int count, const Eigen::Matrix3d& covariance) {
  state.P.middleRows(first, count).setZero();
  state.P.middleCols(first, count).setZero();
  state.P.block(first, first, count, count) = covariance.block(first, first, count, count);
}

}  // namespace

bool note_rejection(EkfState& state, const Rejection& r, const GateOptions& options) {
  RejectedRun& run = state.sources[static_cast<std::size_t>(r.source)].run;
  const Odometry now = odometry_at(state, r.time);
  const bool fits = run.count > 0 && agrees(run, r, now, options.probability);
  if (!fits && run.count > 0 && ++run.misfits < kMisfits) return false;
  if (!fits) {
    run = {};
    run.since = r.time;
    run.start_odometer = now.odometer;
  }
  append(run, r, now);
  return run.count >= options.kReacquireCount &&
         r.time - run.since >= Duration::seconds(options.reacquire_after) &&
         !supported_by_others(state, r, run, options);
}

void take_over(EkfState& state, const Rejection& r, const Eigen::Matrix3d& covariance,
               const GateOptions& options) {
  RejectedRun& run = state.sources[static_cast<std::size_t>(r.source)].run;
  const Odometry now = odometry_at(state, r.time);
  const Pose2 X_now_then = inverse(now.X_OB) * state.X_OB;  // back from the stamp to the state's time
  const double theta_now = wrap_angle(state.x(2) - X_now_then.theta);
  Eigen::Matrix3d C = covariance;
  Pose2 X_MB{state.x(0), state.x(1), theta_now};
  if (r.position && r.heading) {
    X_MB = {r.position->x(), r.position->y(), *r.heading};
    replace(state, 0, 3, C);
  } else if (r.position) {
    const double spread = run.fit.spread();
    const double heading_variance = spread > 0.0 ? r.position_variance / spread : 1e9;
    const double fitted = wrap_angle(run.fit.angle() + now.X_OB.theta);
    const double away = wrap_angle(fitted - theta_now);
    const bool disagrees =
        away * away > chi_square_quantile(options.probability, 1) * (state.P(2, 2) + heading_variance);
    const bool replaces_heading =
        heading_variance < kKnownHeading && (disagrees || !heading_supported(state, r.source, run.since));
    if (replaces_heading) {
      X_MB.theta = fitted;
      C(2, 2) = 2.0 * heading_variance + state.P(2, 2);  // P has what the wheels added during the run
    }
    const Vector2 base = *r.position - rotate({0.0, 0.0, X_MB.theta}, r.antenna);
    X_MB.x = base.x();
    X_MB.y = base.y();
    replace(state, 0, replaces_heading ? 3 : 2, C);
  } else {
    X_MB.theta = wrap_angle(*r.heading - state.x(4));
    C(2, 2) += state.P(4, 4);
    replace(state, 2, 1, C);
  }
  if (r.position) {
    const Pose2 then = X_MB * X_now_then;
    state.x.head<3>() << then.x, then.y, then.theta;
  } else {
    state.x(2) = wrap_angle(X_MB.theta + X_now_then.theta);
  }
  run = {};
  state.doubt = {};
  state.last_reset = r.time;
  state.reset_source = r.source;
}

}  // namespace bw::localization
