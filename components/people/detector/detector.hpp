// Sweep of a laser in, detections out: what is background, what belongs together, whether it looks like a
// leg, and where its centre is. theory.md 7.1, after Arras et al., ICRA 2007.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/people/detection.hpp"
#include "components/people/detector/beams.hpp"
#include "components/people/detector/clusters.hpp"
#include "components/people/detector/detector_options.hpp"
#include "components/people/detector/local_background.hpp"
#include "components/people/detector/neighbours.hpp"
#include "components/people/detector/outline.hpp"

namespace bw::people {

/// What is known beside the sweep.
struct Surroundings {
  const OccupancyGrid* map = nullptr;
  std::optional<Pose2> X_MO;        ///< odom in the map; none: the map is not used for this sweep
  std::span<const Vector2> people;  ///< tracked people in O, whom the background must not absorb
};

class Detector {
 public:
  explicit Detector(const DetectorOptions& options);

  /// For the next sweep. The background keeps what it was constructed with.
  void set_options(const DetectorOptions& options) { options_ = options; }

  /// `sweep` with its scanner in O. Of an unusable one (fault_for_people) nothing is detected, no direction
  /// was seen, and nothing is learnt. Valid until the next call; takes no memory once it has seen the largest
  /// sweep.
  const DetectionSet& detect(const LaserSweep& sweep, const Surroundings& surroundings);

  void reset();  ///< forgets the local background, as after a jump of odom

  /// The parts of the last sweep, for those who train and test.
  const Beams& beams() const { return beams_; }
  const Clusters& clusters() const { return clusters_; }  ///< one for each detection, in the same order
  const std::vector<Neighbours>& neighbours() const { return neighbours_.last(); }  ///< and so these

 private:
  void find_background(const Surroundings& surroundings);
  Detection describe(const Cluster& cluster, const Neighbours& neighbours);

  DetectorOptions options_;
  LocalBackground local_;
  Beams beams_;
  std::vector<std::uint8_t> is_background_;
  Clusters clusters_;
  NeighbourSearch neighbours_;
  Outline outline_;
  DetectionSet result_;
};

}  // namespace bw::people
