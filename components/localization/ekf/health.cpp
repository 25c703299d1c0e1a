#include "components/localization/ekf/health.hpp"

#include <algorithm>
#include <cmath>

#include "components/localization/ekf/heading_doubt.hpp"
#include "components/localization/ekf/slip.hpp"
#include "components/model/principal_deviations.hpp"

namespace bw::localization {
namespace {

constexpr double kPeriods = 2.5;  // of its own that a source may be silent

class Assessment {
 public:
  Assessment(const EkfState& state, Time now, const EkfOptions& options)
      : state_(state), now_(now), options_(options) {
    health_.state = HealthState::ok;
  }

  void uncertainty() {
    const Eigen::Matrix3d P = mixture_covariance(state_);
    health_.two_sigma = 2.0 * principal_deviations(P.topLeftCorner<2, 2>()).x();
    health_.heading_sigma = std::sqrt(std::max(0.0, P(2, 2)));
    const HealthOptions& limits = options_.health;
    if (health_.two_sigma > limits.kDegradedShare * limits.lost_two_sigma) {
      worsen(health_.two_sigma > limits.lost_two_sigma ? HealthState::lost : HealthState::degraded,
             {HealthCause::uncertain_position, -1, health_.two_sigma});
    }
    if (health_.heading_sigma > limits.kLostHeadingSigma)
      worsen(HealthState::lost, {HealthCause::uncertain_heading, -1, health_.heading_sigma});
  }

  void motion() {
    const double silent = age(state_.last_wheel);
    if (silent > options_.motion.extrapolation)
      worsen(HealthState::degraded, {HealthCause::wheels_silent, -1, silent});
    if (gyro_in_doubt(state_.slip, state_.time, options_.slip)) {
      worsen(HealthState::degraded, {HealthCause::gyro_in_doubt, -1, state_.slip.lately});
    } else if (slipping(state_.slip)) {
      worsen(HealthState::degraded, {HealthCause::slipping, -1, age(state_.slip.since)});
    }
  }

  void sources() {
    bool positions_come = false;
    Time position_used = kNever;
    const int count = static_cast<int>(state_.sources.size());
    for (int i = 0; i < count; ++i) {
      const SourceState& s = state_.sources[static_cast<std::size_t>(i)];
      if (s.last_seen == kNever) continue;
      const double unseen = age(s.last_seen);
      health_.sources.push_back(
          {i, unseen, s.period, s.used, s.rejected, s.acceptance, s.nis, s.nis_all, s.dof});
      const double patience = std::max(options_.health.kSourceTimeout, kPeriods * s.period);
      if (unseen > patience) {
        worsen(HealthState::degraded, {HealthCause::source_silent, i, unseen});
        continue;
      }
      const bool absolute = s.gives_position || s.gives_heading;
      if (absolute && age(s.last_used) > patience)
        worsen(HealthState::degraded, {HealthCause::source_rejected, i, age(s.last_used)});
      if (!s.gives_position) continue;
      positions_come = true;
      position_used = std::max(position_used, s.last_trusted);
    }
    if (positions_come && age(position_used) > options_.health.kLostRejection)
      worsen(HealthState::lost, {HealthCause::contradicted, -1, age(position_used)});
  }

  void jumps(Time last_clock_jump) {
    const double recent = options_.health.kReportJump;
    if (state_.last_reset != kNever && age(state_.last_reset) <= recent) {
      worsen(HealthState::degraded,
             {HealthCause::estimate_reset, state_.reset_source, age(state_.last_reset)});
    }
    if (last_clock_jump != kNever && age(last_clock_jump) <= recent)
      worsen(HealthState::degraded, {HealthCause::clock_jump, -1, age(last_clock_jump)});
  }

  const Health& health() const { return health_; }

 private:
  double age(Time time) const { return std::max(0.0, (now_ - time).to_seconds()); }

  void worsen(HealthState to, const HealthReason& reason) {
    health_.state = std::max(health_.state, to);
    health_.reasons.push_back(reason);
  }

  const EkfState& state_;
  Time now_;
  const EkfOptions& options_;
  Health health_;
};

}  // namespace

Health assess(const EkfState& state, Time now, Time last_clock_jump, const EkfOptions& options) {
  Assessment assessment(state, now, options);
  assessment.uncertainty();
  assessment.motion();
  assessment.sources();
  assessment.jumps(last_clock_jump);
  return assessment.health();
}

}  // namespace bw::localization
