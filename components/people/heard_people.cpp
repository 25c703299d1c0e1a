#include "components/people/heard_people.hpp"

#include <cmath>

namespace bw::people {
namespace {

double reliability_of(const HeardPerson& person, const HeardPeopleOptions& options) {
  return person.reliability == 0.0 ? options.kUntoldReliability : person.reliability;
}

bool is_usable(const HeardPerson& person, const HeardPeopleOptions& options) {
  return person.position.allFinite() && person.velocity.allFinite() &&
         reliability_of(person, options) >= options.min_reliability;
}

}  // namespace

std::vector<TrackedPerson> HeardPeople::take(const std::vector<HeardPerson>& people, Time stamp,
                                             const HeardPeopleOptions& options) {
  const double p2 = options.position_deviation * options.position_deviation;
  const double v2 = options.velocity_deviation * options.velocity_deviation;
  std::map<std::string, std::size_t> counts;
  decltype(ids_) ids;
  std::vector<TrackedPerson> tracked;
  for (const HeardPerson& person : people) {
    if (!is_usable(person, options)) continue;
    const std::pair key(person.name, counts[person.name]++);
    const auto known = ids_.find(key);
    const std::uint32_t id = ids[key] = known != ids_.end() ? known->second : ++last_id_;
    TrackedPerson track;
    track.id = id;
    track.position = person.position;
    track.velocity = person.velocity;
    track.radius = options.radius;
    track.covariance = Eigen::Vector4d(p2, p2, v2, v2).asDiagonal();
    track.confidence = reliability_of(person, options);
    track.born = track.confirmed = track.last_seen = stamp;
    tracked.push_back(std::move(track));
  }
  ids_ = std::move(ids);
  return tracked;
}

}  // namespace bw::people
