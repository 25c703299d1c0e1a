// What other detectors tell of whole people, beside the tracks of the lasers: who is meant, where their legs
// may stand, and how much it is believed.
#pragma once

#include <vector>

#include "components/people/heard_person.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/external_detection_options.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// Who can be meant at all: finite, reliability within 0 and 1. Of two nearer to each other than `apart` [m]
/// only the more reliable.
std::vector<HeardPerson> without_doubles(std::vector<HeardPerson> heard, double apart);

/// Index of the track that each is, -1: somebody new. The positions are of `late` [s] before the tracks'
/// time, known to `deviation` [m]; all at once, for the least sum of squared distances in standard
/// deviations, within association.gate and association.reach.
std::vector<int> match_heard(const std::vector<HeardPerson>& heard, const std::vector<PersonTrack>& people,
                             double late, double deviation, const AssociationOptions& options);

/// Belief after one more message.
double believed(double belief, double reliability, const ExternalDetectionOptions& options);

/// Clusters seen within `seen` before `now` [s], two deviations away at most, that may be the legs of
/// somebody told to be at `position`; -1: none. Two whom one sweep showed come before one.
struct NearLegs {
  int first = -1;
  int second = -1;
};
NearLegs legs_near(const Vector2& position, double now, const std::vector<ClusterTrack>& clusters,
                   const ExternalDetectionOptions& options);

/// Somebody new of whom nothing is known but this, by a laser not seen for as long as anybody is remembered;
/// `deviation` of the position [m].
PersonTrack person_of(const HeardPerson& heard, double deviation, Time now, const TrackerOptions& options);

/// Corrects by a position that was told.
void correct_by(const HeardPerson& heard, double deviation, const TrackerOptions& options,
                PersonTrack& person);

}  // namespace bw::people
