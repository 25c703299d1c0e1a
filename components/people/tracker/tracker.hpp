// Who walks where, from one sweep to the next: people as pairs of legs that swing against each other, among
// everything else that stands in the room, which is tracked as well so that furniture does not become people.
// All in the frame O of the detections (odom). theory.md 7.2, 7.3, with joint legs after Leigh et al., ICRA
// 2015.
//
// One sweep: predict everything; assign detections to legs of people and to other clusters at once (global
// nearest neighbour); correct; pair legs anew that went to the wrong person; make people of clusters that
// walk or stand like legs, or find in them who was lost; let go of who has not been seen where they could
// have been seen. Sweeps may come from several sensors, each with its own position and view; whole persons
// told by another detector (a camera) are matched with the same tracks.
#pragma once

#include <memory>
#include <vector>

#include "components/model/tracked_person.hpp"
#include "components/people/detection.hpp"
#include "components/people/heard_person.hpp"
#include "components/people/tracker/tracker_options.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

class Tracker {
 public:
  explicit Tracker(const TrackerOptions& options);
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;
  ~Tracker();

  /// For the next sweep. The alignment keeps what it was constructed with.
  void set_options(const TrackerOptions& options);

  /// Confirmed people after this sweep, by rising id; valid until the next call. Sweeps of several
  /// sensors (`source`) come one by one. A sweep not later than the one before is ignored, unless it is
  /// another sensor's of the same time, except that a jump back of more than `longest_gap` or a longer
  /// silence forgets everybody. Detections that are not finite, whose covariance is not positive definite or
  /// has a trace above 2 m^2, whose scores are not within 0 and 1, or that are too wide, are ignored.
  const std::vector<TrackedPerson>& update(const DetectionSet& sweep);

  /// What another detector tells, in O. Of an earlier time than the last sweep it is brought forward; of a
  /// later one the tracks go to that time, so that lasers whose sweeps are under way come first. Who was seen
  /// by a laser lately keeps the laser's place and is surer to be a person; others are where they are told to
  /// be. Somebody new is a possible person at first, and confirmed by reliability and repetition (`hearing`).
  const std::vector<TrackedPerson>& hear(const HeardSet& heard);

  const std::vector<TrackedPerson>& people() const;

  /// Where people stand, and pairs that look like legs: not to be taken for furniture by the detector's
  /// background.
  std::vector<Vector2> keep_out() const;

  /// Everything tracked that is not a confirmed person.
  std::size_t cluster_count() const;

  void reset();  ///< forgets everybody; ids go on

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bw::people
