#include "components/localization/ekf/ekf.hpp"

#include <algorithm>
#include <cmath>

#include "components/localization/ekf/covariance_bounds.hpp"
#include "components/localization/ekf/heading_doubt.hpp"
#include "components/localization/ekf/motion.hpp"

namespace bw::localization {

Ekf::Ekf(const EkfOptions& options, int sources)
    : fusion_(options),
      ring_(fusion_, Duration::seconds(EkfOptions::kWindow), options.capacity, sources),
      initial_(options.initial, options.gate.probability),
      stamps_(Duration::seconds(options.kFutureTolerance)),
      kinds_(static_cast<std::size_t>(sources)) {}

bool Ekf::start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) {
  PoseReading pose;
  pose.X_MB = X_MB;
  pose.covariance = covariance;
  if (check(pose, fusion_.options().limits) != Verdict::accepted) return false;
  begin(X_MB, covariance, time);
  return true;
}

void Ekf::begin(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time, bool by_compass) {
  const BiasOptions& bias = fusion_.options().bias;
  EkfState state;
  state.sources.resize(kinds_.size());
  if (initialised_) {
    state = ring_.newest();
    const Eigen::Matrix2d biases = state.P.block<2, 2>(3, 3);
    state.P.setZero();
    state.P.block<2, 2>(3, 3) = biases;
    state.x(kRounding) = 0.0;
    state.rounded_at = kNever;
    state.gyro = {};
    state.slip = {};
    state.doubt = {};
    for (SourceState& source : state.sources) source.run = {};
  } else {
    state.P(3, 3) = bias.gyro_bias ? bias.gyro_bias_sigma * bias.gyro_bias_sigma : 0.0;
    state.P(4, 4) = bias.heading_offset ? bias.heading_offset_sigma * bias.heading_offset_sigma : 0.0;
  }
  state.x.head<3>() << X_MB.x, X_MB.y, wrap_angle(X_MB.theta);
  state.P.topLeftCorner<3, 3>() = 0.5 * (covariance + covariance.transpose());
  if (by_compass) {  // theta = reading - offset: as unsure as the offset, and against it
    state.P(2, 2) += state.P(4, 4);
    state.P(2, 4) = state.P(4, 2) = -state.P(4, 4);
  }
  hold_definite(state.P, state.P.diagonal());
  state.time = time;
  state.last_wheel = time;
  ring_.restart(state);
  initialised_ = true;
}

Outcome Ekf::add(const Measurement& measurement, Time now) {
  bool jumped = false;
  if (stamps_.clock_went_back(now)) {
    stamps_.forget_shift();
    initial_.restart();
    jump_to(now, Duration{});
    jumped = true;
  }
  Outcome outcome = sort_in(measurement, now);
  const auto* step = std::get_if<WheelStep>(&measurement);
  const bool wrong_stamp = outcome.verdict == Verdict::future || outcome.verdict == Verdict::too_old;
  if (step != nullptr && stamps_.was_set(*step, wrong_stamp, now)) {
    jump_to(step->time, stamps_.lost());
    jumped = true;
  }
  outcome.clock_jumped = jumped;
  ++counts_[static_cast<std::size_t>(outcome.verdict)];
  return outcome;
}

Outcome Ekf::sort_in(const Measurement& measurement, Time now) {
  const Verdict sound = check(measurement, fusion_.options().limits, static_cast<int>(kinds_.size()));
  if (sound != Verdict::accepted) return {sound};
  if (kind_changed(measurement)) return {Verdict::bad_source};
  if (stamps_.in_future(stamp(measurement), now)) return {Verdict::future};
  if (!initialised_) {
    const std::optional<StartPose> start = initial_.add(measurement);
    if (start) begin(start->X_MB, start->covariance, start->time, start->by_compass);
    return {Verdict::collected};
  }
  const EventRing::Insertion insertion = ring_.insert(measurement);
  return {insertion.result.verdict, insertion.result.nis, insertion.result.dof, insertion.replayed};
}

bool Ekf::kind_changed(const Measurement& measurement) {
  std::optional<std::size_t>& kind = kinds_[static_cast<std::size_t>(source(measurement))];
  if (!kind) kind = measurement.index();
  return *kind != measurement.index();
}

void Ekf::jump_to(Time time, Duration lost) {
  last_clock_jump_ = time;
  ++clock_jumps_;
  if (!initialised_) return;
  if (fusion_.options().on_clock_jump == OnClockJump::reset) {
    initialised_ = false;
    initial_.restart();
    return;
  }
  EkfState state = ring_.newest();
  predict_without_wheels(state, state.time + lost, fusion_.options());
  state.time = time;
  state.last_wheel = time;
  state.gyro = {};
  state.slip = {};
  state.doubt = {};
  state.last_reset = kNever;
  for (SourceState& source : state.sources) {
    source.run = {};
    if (source.last_seen != kNever) source.last_seen = time;
    if (source.last_used != kNever) source.last_used = time;
    if (source.last_trusted != kNever) source.last_trusted = time;
  }
  ring_.restart(state);
}

Estimate Ekf::estimate_at(Time time) const {
  const EkfState& state = ring_.newest();
  const MotionOptions& motion = fusion_.options().motion;
  const Time reached = std::clamp(time, state.time, state.time + Duration::seconds(motion.extrapolation));
  const Extrapolated at = extrapolate(state, reached, motion);
  Estimate estimate;
  estimate.time = reached;
  estimate.X_MB = at.X_MB;
  estimate.twist = state.twist;
  const Eigen::Matrix3d C = at.by_pose * mixture_covariance(state) * at.by_pose.transpose();
  estimate.covariance = 0.5 * (C + C.transpose());
  estimate.covariance.diagonal() +=
      Eigen::Vector3d(at.position_variance, at.position_variance, at.heading_variance);
  estimate.gyro_bias = state.x(3);
  estimate.heading_offset = state.x(4);
  return estimate;
}

Health Ekf::health(Time now) const {
  if (initialised_)
    return assess(ring_.newest(), stamps_.on_stamps(now), last_clock_jump_, fusion_.options());
  Health health;
  if (!initial_.has_fixes()) health.reasons.push_back({HealthCause::no_position});
  if (!initial_.has_headings()) health.reasons.push_back({HealthCause::no_heading});
  return health;
}

}  // namespace bw::localization
