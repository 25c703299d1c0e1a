#include "components/localization/ekf/fusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/localization/ekf/adaptive_noise.hpp"
#include "components/localization/ekf/covariance_bounds.hpp"
#include "components/localization/ekf/heading_doubt.hpp"
#include "components/localization/ekf/motion.hpp"
#include "components/localization/ekf/observation.hpp"
#include "components/localization/ekf/reacquisition.hpp"
#include "components/model/chi_square.hpp"

namespace bw::localization {
namespace {

constexpr double kMemory = 50.0;  // measurements that the smoothed figures look back on
constexpr double kMaxNis = 100.0;

void note_seen(SourceState& source, Time time) {
  if (source.last_seen != kNever && time > source.last_seen) {
    const double dt = (time - source.last_seen).to_seconds();
    source.period = source.period == 0.0 ? dt : source.period + 0.1 * (dt - source.period);
  }
  source.last_seen = time;
}

void note_used(SourceState& source, Time time, bool used, double nis, int dof) {
  const double seen = 1.0 + source.used + source.rejected;
  source.acceptance += ((used ? 1.0 : 0.0) - source.acceptance) / std::min(seen, kMemory);
  source.nis_all += (std::min(nis, kMaxNis) - source.nis_all) / std::min(seen, kMemory);
  source.dof = dof;
  if (!used) {
    ++source.rejected;
    return;
  }
  ++source.used;
  source.nis += (nis - source.nis) / std::min(static_cast<double>(source.used), kMemory);
  source.last_used = time;
  if (!source.gives_range || source.acceptance >= 0.5) source.last_trusted = time;
  source.run = {};
}

Rejection as_rejection(const PositionFix& m) {
  return {m.time, m.source, m.position, m.covariance.diagonal().maxCoeff(), m.antenna, {}, 0.0};
}
Rejection as_rejection(const PoseReading& m) {
  const double largest = std::max(m.covariance(0, 0), m.covariance(1, 1));
  return {m.time, m.source, m.X_MB.position(), largest, {0.0, 0.0}, m.X_MB.theta, m.covariance(2, 2)};
}
Rejection as_rejection(const HeadingReading& m) {
  return {m.time, m.source, {}, 0.0, {0.0, 0.0}, m.heading, m.variance};
}

Eigen::Matrix3d pose_covariance(const PositionFix& m) {
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  C.topLeftCorner<2, 2>() = m.covariance;
  return C;
}
Eigen::Matrix3d pose_covariance(const PoseReading& m) { return m.covariance; }
Eigen::Matrix3d pose_covariance(const HeadingReading& m) {
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  C(2, 2) = m.variance;
  return C;
}

struct Applier {
  EkfState& state;
  const EkfOptions& options;
  const std::array<double, 4>& thresholds;

  SourceState& source(int i) const { return state.sources[static_cast<std::size_t>(i)]; }

  FusionResult operator()(const GyroReading& m) const {
    note_seen(source(m.source), m.time);
    add_gyro(state, m, options);
    note_used(source(m.source), m.time, true, 0.0, 0);
    return {};
  }

  FusionResult operator()(const WheelStep& m) const {
    note_seen(source(m.source), m.time);
    if (!predict(state, m, options)) return {Verdict::unusable};
    note_used(source(m.source), m.time, true, 0.0, 0);
    return {};
  }

  FusionResult operator()(const PositionFix& m) const {
    source(m.source).gives_position = true;
    return compare(m, observe(m, reach(m.time)), true);
  }
  FusionResult operator()(const RangeReading& m) const {
    source(m.source).gives_position = source(m.source).gives_range = true;
    return compare(m, observe(m, reach(m.time)), false);
  }
  FusionResult operator()(const PoseReading& m) const {
    source(m.source).gives_position = source(m.source).gives_heading = true;
    return compare(m, observe(m, reach(m.time)), true);
  }
  FusionResult operator()(const HeadingReading& m) const {
    source(m.source).gives_heading = true;
    return compare(m, observe(m, reach(m.time), state.x(4)), true);
  }
  FusionResult operator()(const CourseReading& m) const {
    const Extrapolated at = reach(m.time);
    if (std::abs(state.twist.v) < options.kCourseSpeed) {
      note_seen(source(m.source), m.time);
      return {Verdict::unusable};
    }
    return compare(m, observe(m, at, state.twist.v < 0.0), false);
  }

  // The pose at the stamp; without wheels for long the state itself goes there.
  Extrapolated reach(Time time) const {
    if (time - state.last_wheel > Duration::seconds(options.motion.extrapolation))
      predict_without_wheels(state, time, options);
    return extrapolate(state, time, options.motion);
  }

  template <int N>
  void correct_state(const Innovation<kStates, N>& z) const {
    const StateVector before = state.P.diagonal();
    update(state.x, state.P, z);
    hold_definite(state.P, before);
    state.x(2) = wrap_angle(state.x(2));
    state.x(4) = wrap_angle(state.x(4));
  }

  template <class M, int N>
  FusionResult compare(const M& m, Innovation<kStates, N> z, bool may_take_over) const {
    note_seen(source(m.source), m.time);
    if (options.adaptive.enabled) z.R *= adapt_noise(source(m.source).noise, z, state.P, options.adaptive);
    const double nis = z.nis(state.P);
    FusionResult result{Verdict::accepted, nis, N};
    const bool passes = nis >= 0.0 && nis <= thresholds[N];
    if constexpr (std::is_same_v<M, HeadingReading>) {
      if (doubt_heading(state, m.source, m.time, z, thresholds[N], options)) {
        correct_heading(state, m.source, m.time);
        hold_definite(state.P, state.P.diagonal());
        note_used(source(m.source), m.time, true, nis, N);
        result.verdict = Verdict::reacquired;
        return result;
      }
    } else if (state.doubt.is_open()) {
      weigh_doubt(state.doubt, z, state.P, thresholds[N], passes);
    }
    if (passes)
      correct_state(z);
    else
      result.verdict = Verdict::gated;
    note_used(source(m.source), m.time, passes, nis, N);
    if constexpr (!std::is_same_v<M, CourseReading> && !std::is_same_v<M, RangeReading>) {
      if (!passes && may_take_over && note_rejection(state, as_rejection(m), options.gate)) {
        take_over(state, as_rejection(m), pose_covariance(m), options.gate);
        hold_definite(state.P, state.P.diagonal());
        source(m.source).last_used = source(m.source).last_trusted = m.time;
        result.verdict = Verdict::reacquired;
      }
    }
    return result;
  }
};

}  // namespace

Fusion::Fusion(const EkfOptions& options) : options_(options) {
  for (int dof = 1; dof <= 3; ++dof) {
    thresholds_[static_cast<std::size_t>(dof)] = options.gate.enabled
                                                     ? chi_square_quantile(options.gate.probability, dof)
                                                     : std::numeric_limits<double>::infinity();
  }
}

FusionResult Fusion::apply(EkfState& state, const Measurement& measurement) const {
  return std::visit(Applier{state, options_, thresholds_}, measurement);
}

}  // namespace bw::localization
