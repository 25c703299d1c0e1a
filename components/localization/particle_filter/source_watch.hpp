// What is remembered of one source: its figures for the health report, its stamps, and its run of rejections.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "components/model/rigid_fit.hpp"
#include "components/localization/health.hpp"
#include "components/localization/measurements.hpp"
#include "components/localization/particle_filter/comparison.hpp"

namespace bw::localization {

/// Rejections of a source in a row that agree with each other: positions as far apart as the odometry says,
/// headings that rotated as it did.
struct RejectionRun {
  int count = 0;
  int misfits = 0;  ///< rejections in a row that do not agree with the run
  Time since{};
  Vector2 position{0.0, 0.0};  ///< the last one that agreed, in M
  Vector2 point{0.0, 0.0};     ///< the same by odometry, in O
  double heading = 0.0;
  double heading_O = 0.0;
  double odometer = 0.0;  ///< at the start of the run [m]
  RigidFit fit;           ///< map from odometry, of the run's positions
};

class SourceWatch {
 public:
  /// False when the source has given another kind before.
  bool is_kind(std::size_t kind);
  /// True the second time within the last 256 stamps.
  bool is_duplicate(Time time) const;

  void note_seen(Time time);
  /// A measurement compared; motion has no degrees of freedom.
  void note_compared(Time time, bool used, double nis, int dof);
  /// Adds to the run; X_OB by odometry at the stamp.
  const RejectionRun& note_rejection(const Comparison& c, const Pose2& X_OB, double odometer, Time time,
                                     double gate);
  void end_run() { run_ = {}; }
  /// After a jump of the clock: as if last heard at `time`.
  void move_stamps(Time time);

  bool heard() const { return seen_count_ > 0; }
  Time last_seen() const { return last_seen_; }
  bool ever_used() const { return health_.used > 0; }
  Time last_used() const { return last_used_; }
  bool gives_position() const { return gives_position_; }
  bool gives_heading() const { return gives_heading_; }
  void gives(bool position, bool heading);
  /// All but `source` and `age`.
  const SourceHealth& health() const { return health_; }

 private:
  std::optional<std::size_t> kind_;
  std::array<Time, 256> stamps_{};  ///< circular
  std::size_t seen_count_ = 0;
  Time last_seen_{};
  Time newest_{};
  Time last_used_{};
  bool gives_position_ = false;
  bool gives_heading_ = false;
  SourceHealth health_;
  RejectionRun run_;
};

}  // namespace bw::localization
