// Detections of one sweep at one time: a scanner that rotates sees who is to the left of the robot some 70 ms
// before or after who is to the right, in which they walk 8 cm.
#pragma once

#include <span>

#include "components/model/tracked_person.hpp"
#include "components/people/detection.hpp"

namespace bw::people {

/// Moves each detection from when it was seen (Detection::after) to detections.time, by the velocity of whom
/// it may be a part of: the nearest of `people` within half a metre; what that velocity is not sure of goes
/// into its covariance. What stands (on_static), and what nobody is near, stays. `people`: at `people_time`,
/// in the frame of the detections.
void move_to_one_time(DetectionSet& detections, std::span<const TrackedPerson> people, Time people_time);

}  // namespace bw::people
