// What is told of somebody tracked.
#pragma once

#include "components/model/tracked_person.hpp"
#include "components/people/tracker/person_track.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::people {

/// `person` lives in S, what is told in O (odom): X_OS. `radius` is everybody's [m].
TrackedPerson report_of(const PersonTrack& person, const Pose2& X_OS, double radius);

/// Something that stands and may be somebody: at rest. `origin`: when times of clusters begin.
TrackedPerson report_of(const ClusterTrack& possible, Time origin, const Pose2& X_OS, double radius);

}  // namespace bw::people
