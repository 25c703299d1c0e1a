// Who walks where, from one sweep to the next: people as pairs of legs that swing against each other, among
// everything else that stands in the room, which is tracked as well so that furniture does not become people.
// All in the frame O of the detections (odom). Book 7.2, 7.3, with joint legs after Leigh et al., ICRA 2015.
//
// One sweep: predict everything; assign detections to legs of people and to other clusters at once (global
// nearest neighbour); correct; pair legs anew that went to the wrong person; make people of clusters that
// walk or stand like legs, or find in them who was lost; let go of who has not been seen where they could
// have been seen.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "components/people/detection.hpp"
#include "components/people/tracker/tracker_options.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

/// A person who is believed to be there, at the stamp of the last sweep.
struct TrackedPerson {
  std::uint32_t id = 0;                                      ///< from 1; for one only, also lost and back
  Vector2 position{0.0, 0.0};                                ///< between the legs, in O [m]
  Vector2 velocity{0.0, 0.0};                                ///< in O [m/s]
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();  ///< of (x, y, vx, vy) [m, m/s]
  double radius = 0.3;                                       ///< of the body, from options [m]
  double confidence = 0.0;  ///< 0 to 1: how much it looks like a person, less while unseen
  Time born;                ///< first sweep that showed a part of them
  Time confirmed;           ///< first sweep after which they were reported
  Time last_seen;           ///< last sweep that showed a part of them
};

class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options);
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;
  ~Tracker();

  /// Confirmed people after this sweep, by rising id; valid until the next call. A sweep not later than the
  /// one before is ignored, except that a jump back of more than `longest_gap` or a longer silence forgets
  /// everybody. Detections that are not finite, whose covariance is not positive definite or
  /// has a trace above 2 m^2, whose scores are not within 0 and 1, or that are too wide, are ignored.
  const std::vector<TrackedPerson>& update(const DetectionSet& sweep);

  const std::vector<TrackedPerson>& people() const;

  /// Where confirmed people stand: not to be taken for furniture by the detector's background.
  std::vector<Vector2> keep_out() const;

  /// Everything tracked that is not a confirmed person.
  std::size_t cluster_count() const;

  void reset();  ///< forgets everybody; ids go on

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bw::people
