#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "components/people/tracker/external_detections.hpp"
#include "components/people/tracker/reappearance.hpp"
#include "components/people/tracker/tracker_impl.hpp"

namespace bw::people {

/// A message that is late is compared with where the tracks were then; what it corrects, with where they are.
const std::vector<TrackedPerson>& Tracker::Impl::hear(const HeardSet& heard) {
  if (now_ && heard.time < *now_ - Duration::seconds(options_.kLongestGap)) return reported_;
  begin_at(heard.time);
  if (!now_ || heard.time > *now_) predict_to(heard.time);
  const double late = (*now_ - heard.time).to_seconds();
  std::vector<HeardPerson> told = without_doubles(heard.people, options_.kPersonRadius);
  for (HeardPerson& person : told) {
    person.position = X_SO_ * person.position;
    person.velocity = rotate(X_SO_, person.velocity);
  }
  const std::vector<int> whose =
      match_heard(told, people_, late, options_.hearing.kPositionDeviation, options_.association);
  for (std::size_t i = 0; i < told.size(); ++i)
    if (whose[i] >= 0) believe(told[i], late, people_[static_cast<std::size_t>(whose[i])]);
  for (std::size_t i = 0; i < told.size(); ++i)
    if (whose[i] < 0) begin_with(told[i], late);
  delete_tracks();
  report();
  return reported_;
}

void Tracker::Impl::believe(const HeardPerson& told, double late, PersonTrack& person) {
  const ExternalDetectionOptions& hearing = options_.hearing;
  person.last_heard = *now_;
  person.heard = believed(person.heard, told.reliability, hearing);
  if (person.empty_seconds >= options_.death.unseen)
    person.heard = std::min(person.heard, hearing.kUnseenLimit);
  if (person.last_seen + Duration::seconds(hearing.kSeen) >= *now_) return;
  HeardPerson there = told;
  there.position += late * person.walker.velocity();
  correct_by(there, hearing.kPositionDeviation, options_, person);
  if (follow_legs_near(person)) return;
  // Legs that appear here are theirs: as of somebody who was out of sight just long enough.
  person.sure = {seconds() - options_.hidden.kAbsent,
                 person.walker.position() - options_.hidden.kAbsent * person.walker.velocity(),
                 person.walker.velocity()};
}

void Tracker::Impl::begin_with(const HeardPerson& told, double late) {
  const double unsure = late * ExternalDetectionOptions::kUntoldSpeed;
  const double deviation = std::hypot(options_.hearing.kPositionDeviation, unsure);
  HeardPerson there = told;
  there.position += late * told.velocity;
  PersonTrack person = person_of(there, deviation, *now_, options_);
  std::vector<PersonTrack> nobody;
  const Sighting sighting{.time = seconds(), .position = there.position};
  const auto velocity = told.velocity.squaredNorm() > 0.0 ? std::optional(told.velocity) : std::nullopt;
  if (auto lost = take_returned(nobody, lost_, sighting, velocity, seconds(), options_.hidden)) {
    lost->walker = person.walker;
    lost->heading = person.heading;
    lost->legs = {};
    lost->empty_seconds = 0.0;
    lost->hidden.reset();
    person = *lost;
  } else {
    const NearLegs legs = legs_near(person.walker.position(), seconds(), clusters_, options_.hearing);
    const ClusterTrack* second =
        legs.second < 0 ? nullptr : &clusters_[static_cast<std::size_t>(legs.second)];
    person.id = legs.first < 0 ? ++last_id_ : id_of(clusters_[static_cast<std::size_t>(legs.first)], second);
  }
  person.settled = state_of(person);
  people_.insert(std::ranges::upper_bound(people_, person.id, {}, &PersonTrack::id), person);
  believe(told, late, *std::ranges::find(people_, person.id, &PersonTrack::id));
}

/// What stands where they are told to be are their legs, also if it does not walk or look like a person's
/// yet.
bool Tracker::Impl::follow_legs_near(PersonTrack& person) {
  const NearLegs legs = legs_near(person.walker.position(), seconds(), clusters_, options_.hearing);
  if (legs.first < 0) return false;
  const ClusterTrack first = clusters_[static_cast<std::size_t>(legs.first)];
  std::optional<ClusterTrack> second;
  if (legs.second >= 0) second = clusters_[static_cast<std::size_t>(legs.second)];
  follow_legs(person, first, second ? &*second : nullptr);
  const Birth birth{.kind = second ? BirthKind::standing_pair : BirthKind::standing_single};
  person.existence = existence_of(birth, first, second ? &*second : nullptr);
  person.score = first.last().human_score();
  std::vector<int> used{legs.first};
  if (second) used.push_back(legs.second);
  forget_clusters(used);
  return true;
}

}  // namespace bw::people
