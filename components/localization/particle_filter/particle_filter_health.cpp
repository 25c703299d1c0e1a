// The health of a particle filter.
#include <algorithm>
#include <cmath>

#include "components/localization/particle_filter/particle_filter.hpp"
#include "components/model/principal_deviations.hpp"

namespace bw::localization {
namespace {

constexpr double kPeriods = 2.5;  // of its own that a source may be silent

struct Report {
  Health health;
  Time now;

  double age(Time time) const { return std::max(0.0, (now - time).to_seconds()); }
  void worsen(HealthState to, const HealthReason& reason) {
    health.state = std::max(health.state, to);
    health.reasons.push_back(reason);
  }
};

void judge_spread(Report& report, const Eigen::Matrix3d& C, const HealthOptions& limits) {
  Health& health = report.health;
  health.two_sigma = 2.0 * principal_deviations(C.topLeftCorner<2, 2>()).x();
  health.heading_sigma = std::sqrt(std::max(0.0, C(2, 2)));
  if (health.two_sigma > limits.kDegradedShare * limits.lost_two_sigma) {
    report.worsen(health.two_sigma > limits.lost_two_sigma ? HealthState::lost : HealthState::degraded,
                  {HealthCause::uncertain_position, -1, health.two_sigma});
  }
  if (health.heading_sigma > limits.kLostHeadingSigma)
    report.worsen(HealthState::lost, {HealthCause::uncertain_heading, -1, health.heading_sigma});
}

void judge_sources(Report& report, const std::vector<SourceWatch>& sources, const HealthOptions& limits) {
  bool positions_come = false;
  double since_position = 1e9;
  for (int i = 0; i < static_cast<int>(sources.size()); ++i) {
    const SourceWatch& s = sources[static_cast<std::size_t>(i)];
    if (!s.heard()) continue;
    SourceHealth figures = s.health();
    figures.source = i;
    figures.age = report.age(s.last_seen());
    report.health.sources.push_back(figures);
    const double patience = std::max(limits.kSourceTimeout, kPeriods * figures.period);
    if (figures.age > patience) {
      report.worsen(HealthState::degraded, {HealthCause::source_silent, i, figures.age});
      continue;
    }
    const double unused = report.age(s.last_used());
    if ((s.gives_position() || s.gives_heading()) && unused > patience)
      report.worsen(HealthState::degraded, {HealthCause::source_rejected, i, unused});
    if (!s.gives_position()) continue;
    positions_come = true;
    since_position = std::min(since_position, unused);
  }
  if (positions_come && since_position > limits.kLostRejection)
    report.worsen(HealthState::lost, {HealthCause::contradicted, -1, since_position});
}

}  // namespace

Health ParticleFilter::health(Time now) const {
  Report report{{}, stamps_.on_stamps(now)};
  if (!initialised_) {
    if (!initial_.has_fixes()) report.health.reasons.push_back({HealthCause::no_position});
    if (!initial_.has_headings()) report.health.reasons.push_back({HealthCause::no_heading});
    return report.health;
  }
  const HealthOptions& limits = options_.health;
  report.health.state = HealthState::ok;
  judge_spread(report, estimate_at(report.now).covariance, limits);
  judge_sources(report, sources_, limits);
  const double silent = report.age(track_.last_wheel());
  if (silent > options_.motion.kExtrapolation)
    report.worsen(HealthState::degraded, {HealthCause::wheels_silent, -1, silent});
  const double recent = limits.kReportJump;
  if (last_reset_ && report.age(*last_reset_) <= recent) {
    report.worsen(HealthState::degraded,
                  {HealthCause::estimate_reset, reset_source_, report.age(*last_reset_)});
  }
  if (last_clock_jump_ && report.age(*last_clock_jump_) <= recent)
    report.worsen(HealthState::degraded, {HealthCause::clock_jump, -1, report.age(*last_clock_jump_)});
  if (estimate_.share < options_.particle_health.kSeveralPlaces) {
    report.worsen(estimate_.share < options_.particle_health.kLostSeveralPlaces ? HealthState::lost
                                                                                : HealthState::degraded,
                  {HealthCause::several_places, -1, estimate_.share});
  }
  if (const std::optional<Time> since = recovery_.searching_since())
    report.worsen(HealthState::lost, {HealthCause::searching, -1, report.age(*since)});
  if (const std::optional<Time> since = recovery_.mismatch_since()) {
    const double lasting = report.age(*since);
    const RecoveryOptions& o = options_.recovery;
    if (lasting >=
        std::min(o.kSearchAfter, o.kLostMismatch)) {  // one sweep says little: people stand in the way
      report.worsen(lasting >= o.kLostMismatch ? HealthState::lost : HealthState::degraded,
                    {HealthCause::scan_mismatch, -1, lasting});
    }
  }
  if (laser_heard_ && !field_) report.worsen(HealthState::degraded, {HealthCause::no_map});
  return report.health;
}

}  // namespace bw::localization
