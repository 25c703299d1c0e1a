// EKF localization (theory.md): wheels predict; positions, headings, courses and poses correct, each at its
// own stamp. Late measurements are put where they belong and what followed is computed again.
//
//   Ekf ekf(options);
//   const Outcome outcome = ekf.add(measurement, now);   // in any order within EkfOptions::kWindow
//   const Estimate estimate = ekf.estimate_at(now);
//
// Not thread-safe. After construction and the first pose, add() takes no memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"
#include "components/localization/ekf/event_ring.hpp"
#include "components/localization/ekf/fusion.hpp"
#include "components/localization/ekf/health.hpp"
#include "components/localization/ekf/initial_pose.hpp"
#include "components/localization/ekf/stamp_watch.hpp"
#include "components/localization/estimate.hpp"
#include "components/localization/localizer.hpp"

namespace bw::localization {

class Ekf final : public Localizer {
 public:
  /// With room for so many sources.
  explicit Ekf(const EkfOptions& options, int sources = kUsualSources);
  Ekf(const Ekf&) = delete;
  Ekf& operator=(const Ekf&) = delete;

  using Localizer::add;

  /// What was learnt about biases is kept.
  bool start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) override;
  Outcome add(const Measurement& measurement, Time now) override;

  bool initialised() const override { return initialised_; }
  /// After all measurements, at the last wheel step. Meaningless before initialised().
  Estimate estimate() const { return estimate_at(ring_.newest().time); }
  /// Extrapolated with the last twist, as far as options.motion.extrapolation.
  Estimate estimate_at(Time time) const override;

  Health health(Time now) const override;
  const EkfState& state() const { return ring_.newest(); }
  /// Measurements by verdict on arrival; a replay may have changed its mind since (SourceHealth has that).
  std::uint64_t count(Verdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t clock_jumps() const { return clock_jumps_; }

 private:
  Outcome sort_in(const Measurement& measurement, Time now);
  void begin(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time, bool by_compass = false);
  void jump_to(Time time, Duration lost);
  bool kind_changed(const Measurement& measurement);

  Fusion fusion_;
  EventRing ring_;
  InitialPose initial_;
  StampWatch stamps_;
  std::vector<std::optional<std::size_t>> kinds_;  ///< by source
  std::array<std::uint64_t, 16> counts_{};
  bool initialised_ = false;
  Time last_clock_jump_ = kNever;
  std::uint64_t clock_jumps_ = 0;
};

}  // namespace bw::localization
