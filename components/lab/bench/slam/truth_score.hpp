// A replayed drive beside the exact truth: trajectory, loops, places that were come back to, and how sure the
// poses said they were.
#pragma once

#include <cstddef>
#include <vector>

#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/slam/drive_replay.hpp"

namespace bw::slam {

/// Where the robot was at each scan that is replayed, in the world W.
class TruthOfScans {
 public:
  /// `drive`, which outlives this, has truth with headings.
  explicit TruthOfScans(const RecordedDrive& drive) : drive_(drive) {}
  /// Throws std::runtime_error where the truth does not cover the time.
  Pose2 at(Time time) const;

 private:
  const RecordedDrive& drive_;
};

/// Absolute trajectory error: positions after the last optimisation, laid over the true ones by the rotation
/// and the shift that fit best (Umeyama 1991).
struct TrajectoryError {
  double rms = 0.0;      ///< [m]
  double largest = 0.0;  ///< [m]
};
TrajectoryError trajectory_error(const std::vector<Pose2>& estimated, const std::vector<Pose2>& truth);

/// Loops of the graph at the end, each beside the true pose of its submaps to each other.
struct LoopFaults {
  std::size_t loops = 0;
  std::size_t wrong = 0;       ///< by more than 0.20 m or 1 degree
  std::size_t gross = 0;       ///< by more than 1 m or 10 degrees
  std::size_t gross_kept = 0;  ///< of these, that still have a tenth of their weight
};
LoopFaults loop_faults(const Slam& slam, const TruthOfScans& truth);

/// Places that the robot comes back to: within 3 m and 45 degrees of where it was, no wall between, after 20
/// m of way. Looked at once a second, and judged 10 s later by what is known then.
class Revisits {
 public:
  /// Both outlive this.
  Revisits(const TruthOfScans& truth, const buildings::WallIndex& walls) : truth_(truth), walls_(walls) {}

  /// After each scan of the replay.
  void look(const SlamReplay& so_far);

  std::size_t count() const { return count_; }
  /// Of these, that are still more than 0.3 m off relative to the first visit.
  std::size_t missed() const { return missed_; }

 private:
  struct Visit {
    std::size_t scan = 0;
    Pose2 X_WB;
    double way = 0.0;  ///< driven until then [m]
  };
  const Visit* earlier(const Visit& visit) const;

  const TruthOfScans& truth_;
  const buildings::WallIndex& walls_;
  std::vector<Visit> visits_;
  std::size_t next_ = 0;  ///< visit that is judged next
  double way_ = 0.0;
  Pose2 X_before_;
  std::size_t count_ = 0;
  std::size_t missed_ = 0;
};

/// How sure the poses said they were, as they were told, relative to the first: squared Mahalanobis distances
/// of (x, y, theta) from the truth.
struct Consistency {
  double anees =
      0.0;  ///< their mean, over three: 1 where the covariance is right, below where it is too large
  double share_in_95 = 0.0;  ///< of those within the quantile 95 % of chi-square, 7.81
};
Consistency consistency(const SlamReplay& replayed, const std::vector<Pose2>& truth);

}  // namespace bw::slam
