// EKF localization (spec 3): wheels predict; positions, headings, courses and poses correct, each at its own
// stamp. Late measurements are put where they belong and what followed is computed again.
//
//   Ekf ekf(options);
//   const Outcome outcome = ekf.add(measurement, now);   // in any order within options.window
//   const Estimate estimate = ekf.estimate_at(now);
//
// Not thread-safe. After construction and the first pose, add() takes no memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"
#include "components/localization/ekf/event_ring.hpp"
#include "components/localization/ekf/fusion.hpp"
#include "components/localization/ekf/health.hpp"
#include "components/localization/ekf/initial_pose.hpp"
#include "components/localization/ekf/stamp_watch.hpp"
#include "components/localization/measurements.hpp"
#include "components/localization/verdict.hpp"

namespace bw::localization {

struct Outcome {
  Verdict verdict = Verdict::accepted;
  double nis = 0.0;  ///< 0 for motion
  int dof = 0;       ///< 0 for motion
  int replayed = 0;  ///< measurements computed again because this one was late
  bool clock_jumped = false;
};

struct Estimate {
  Time time;
  Pose2 X_MB;
  Twist2 twist;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta)
  double gyro_bias = 0.0;                                ///< [rad/s]
  double heading_offset = 0.0;                           ///< what the compass reads too much [rad]
};

class Ekf {
 public:
  explicit Ekf(const EkfOptions& options);
  Ekf(const Ekf&) = delete;
  Ekf& operator=(const Ekf&) = delete;

  /// A pose given from outside (known start, a person's click). What was learnt about biases is kept.
  /// False, and nothing happens, unless finite and positive definite.
  bool start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time);

  /// `now` is the time of arrival on the component's clock.
  Outcome add(const Measurement& measurement, Time now);

  bool initialised() const { return initialised_; }
  /// After all measurements, at the last wheel step. Meaningless before initialised().
  Estimate estimate() const { return estimate_at(ring_.newest().time); }
  /// Extrapolated with the last twist, as far as options.motion.extrapolation.
  Estimate estimate_at(Time time) const;

  Health health(Time now) const;
  const EkfState& state() const { return ring_.newest(); }
  /// Measurements by verdict on arrival; a replay may have changed its mind since (SourceHealth has that).
  std::uint64_t count(Verdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t clock_jumps() const { return clock_jumps_; }

 private:
  Outcome sort_in(const Measurement& measurement, Time now);
  void begin(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time);
  void jump_to(Time time, Duration lost);
  bool kind_changed(const Measurement& measurement);

  Fusion fusion_;
  EventRing ring_;
  InitialPose initial_;
  StampWatch stamps_;
  std::array<std::optional<std::size_t>, kMaxSources> kinds_;
  std::array<std::uint64_t, 16> counts_{};
  bool initialised_ = false;
  Time last_clock_jump_ = kNever;
  std::uint64_t clock_jumps_ = 0;
};

}  // namespace bw::localization
