// Monte Carlo localization (theory.md, Algorithm 1; names and defaults of AMCL where it has them): particles
// move with the wheels, each with its own noise, and are weighed by whatever a measurement tells.
//
//   ParticleFilter filter(options, seed);
//   filter.set_map(map);                        // for lasers
//   const Outcome outcome = filter.add(measurement, now);
//   const Estimate estimate = filter.estimate_at(now);
//
// The set stays where the last measurement found it; what the wheels did since is kept as one motion with a
// covariance (odometry_track.hpp) and sampled when the next measurement comes, or after 0.25 m. Late
// measurements are compared with the particles carried back by the odometry between stamp and now.
//
// Not thread-safe. The same seed and the same calls give the same bytes on the same type of CPU.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "components/localization/ekf/initial_pose.hpp"
#include "components/localization/ekf/stamp_watch.hpp"
#include "components/localization/laser/beam_ends.hpp"
#include "components/localization/laser/likelihood_field.hpp"
#include "components/localization/localizer.hpp"
#include "components/localization/particle_filter/comparison.hpp"
#include "components/localization/particle_filter/odometry_track.hpp"
#include "components/localization/particle_filter/particle_filter_options.hpp"
#include "components/localization/particle_filter/particle_motion.hpp"
#include "components/localization/particle_filter/particle_set.hpp"
#include "components/localization/particle_filter/pose_histogram.hpp"
#include "components/localization/particle_filter/recovery.hpp"
#include "components/localization/particle_filter/set_estimate.hpp"
#include "components/localization/particle_filter/source_watch.hpp"
#include "components/model/random.hpp"

namespace bw::localization {

class ParticleFilter final : public Localizer {
 public:
  /// With room for so many sources.
  explicit ParticleFilter(const ParticleFilterOptions& options, std::uint64_t seed = 1,
                          int sources = kUsualSources);
  ParticleFilter(const ParticleFilter&) = delete;
  ParticleFilter& operator=(const ParticleFilter&) = delete;

  bool start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) override;
  /// Uniform over the free cells of the map; false without one.
  bool start_anywhere(Time time) override;
  /// Throws as LikelihoodField does.
  void set_map(const OccupancyGrid& map) override;

  Outcome add(const Measurement& measurement, Time now) override;
  Outcome add(const LaserReading& reading, Time now) override;
  void use_next_sweep() override { use_next_sweep_ = true; }

  bool initialised() const override { return initialised_; }
  /// Mean and covariance of the set as weighed by the last measurement, before it was drawn anew; with lasers
  /// those of the heaviest group of particles.
  Estimate estimate_at(Time time) const override;
  Health health(Time now) const override;
  const ParticleSet* particles() const override { return &particles_; }

  /// Of the set as weighed by the last measurement.
  double effective_sample_size() const { return effective_size_; }
  std::uint64_t count(Verdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  /// Measurements after which no particle had a weight; the set was kept.
  std::uint64_t weightless() const { return weightless_; }

 private:
  Outcome noted(Outcome outcome);
  bool look_at_clock(Time now);
  void jump_to(Time time, Duration missed);
  Outcome sort_in(const Measurement& measurement, Time now);
  Outcome use(const WheelStep& step);
  Outcome use(const GyroReading& reading);
  template <class M>
  Outcome use(const M& reading);
  bool take_over(const Comparison& c, int source, Time time);
  bool supported_by_others(const Comparison& c, int source, const RejectionRun& run) const;

  void begin(Time time, bool anywhere);
  void follow();
  void update_weights();
  void refresh_estimate();
  void resample();
  Outcome use(const LaserReading& reading);
  /// `poses` at the sweep's stamp, X_SB from there to now; `ends` as seen from now.
  bool inject(const std::vector<PoseHypothesis>& poses, const Pose2& X_SB, const BeamEnds& ends);
  SourceWatch& source_watch(int source) { return sources_[static_cast<std::size_t>(source)]; }

  ParticleFilterOptions options_;
  std::array<double, 4> gates_{};  ///< by degrees of freedom
  Random random_;
  ParticleMotion motion_;
  OdometryTrack track_;
  InitialPose initial_;
  StampWatch stamps_;
  std::vector<SourceWatch> sources_;  ///< by number
  std::array<std::uint64_t, 16> counts_{};

  bool initialised_ = false;
  ParticleSet particles_;
  Pose2 X_OB_;  ///< by odometry, where the particles are
  SetEstimate estimate_;
  double effective_size_ = 0.0;
  int since_resampling_ = 0;
  std::uint64_t weightless_ = 0;
  std::optional<Time> last_reset_;
  int reset_source_ = -1;
  std::optional<Time> last_clock_jump_;

  std::optional<LikelihoodField> field_;
  OccupancyGrid map_;                      ///< without its cells
  std::vector<std::uint32_t> free_cells_;  ///< their indices
  bool laser_heard_ = false;
  bool use_next_sweep_ = true;
  Pose2 X_OB_last_sweep_;
  Recovery recovery_;

  // Kept between calls for their memory.
  Differences differences_;
  std::vector<double> log_weight_;
  std::vector<std::size_t> which_;
  ParticleSet drawn_;
  PoseHistogram histogram_;
  BeamEnds ends_;
};

}  // namespace bw::localization
