// What every localization can do, whatever is inside: the one thing an adaptor needs to know. Frames: B
// base_link, M map.
#pragma once

#include "components/localization/estimate.hpp"
#include "components/localization/health.hpp"
#include "components/localization/laser_reading.hpp"
#include "components/localization/measurements.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::localization {

struct ParticleSet;

/// `now` is the time of arrival on the component's clock; stamps are of the measurement.
class Localizer {
 public:
  virtual ~Localizer() = default;

  /// A pose given from outside (known start, a person's click). False, and nothing happens, unless finite and
  /// positive definite.
  virtual bool start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) = 0;
  /// Anywhere in the map. False, and nothing happens, for a filter that cannot search.
  virtual bool start_anywhere(Time) { return false; }
  /// The map that lasers are compared with, again whenever it changes.
  virtual void set_map(const OccupancyGrid&) {}

  /// Uses the next sweep whether the robot moved or not (AMCL: request_nomotion_update); nothing for a filter
  /// that uses every measurement anyway.
  virtual void use_next_sweep() {}

  virtual Outcome add(const Measurement& measurement, Time now) = 0;
  /// Verdict::unusable from a filter that does not look at lasers.
  virtual Outcome add(const LaserReading&, Time) { return {Verdict::unusable}; }

  virtual bool initialised() const = 0;
  /// Extrapolated with the last twist for a while. Meaningless before initialised().
  virtual Estimate estimate_at(Time time) const = 0;
  virtual Health health(Time now) const = 0;
  /// What a cloud would show; nullptr for a filter without particles.
  virtual const ParticleSet* particles() const { return nullptr; }
};

}  // namespace bw::localization
