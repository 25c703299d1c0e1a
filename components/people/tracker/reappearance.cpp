#include "components/people/tracker/reappearance.hpp"

namespace bw::people {

void follow_hidden(PersonTrack& person, const Surroundings& about, bool known, Random& random,
                   const TrackerOptions& options) {
  const HiddenOptions& hidden = options.hidden;
  const double away = about.now - person.sure.time;
  if (known || away <= hidden.kAbsent) person.there = 1.0;
  if (away <= hidden.kAbsent) {
    person.hidden.reset();
    return;
  }
  const bool is_new = !person.hidden;
  if (is_new) person.hidden.emplace(person.sure.position, person.sure.velocity, random, hidden);
  const bool have_walked = person.hidden->pass(is_new ? away : about.dt, is_new ? 0.0 : about.since_own,
                                               about.sweep, about.walls, random, hidden);
  if (known || !have_walked) return;
  const OcclusionMemory::Moments moments = person.hidden->moments();
  person.there = person.hidden->chance_near(moments.mean.head<2>());
  person.walker.place_middle(moments.mean, moments.covariance);
  person.heading = HeadingFilter(moments.mean, moments.covariance, options.heading);
}

std::optional<PersonTrack> take_who_stood(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                          const Vector2& position) {
  std::vector<PersonTrack>* from = nullptr;
  std::size_t nearest = 0;
  double least = HiddenOptions::kSamePosition;
  for (std::vector<PersonTrack>* among : {&people, &lost}) {
    for (std::size_t i = 0; i < among->size(); ++i) {
      const PersonTrack& person = (*among)[i];
      if (!person.hidden || !person.stood()) continue;
      const double away = (person.sure.position - position).norm();
      if (away >= least) continue;
      least = away;
      from = among;
      nearest = i;
    }
  }
  if (from == nullptr) return std::nullopt;
  const auto at = from->begin() + static_cast<std::ptrdiff_t>(nearest);
  const PersonTrack person = *at;
  from->erase(at);
  return person;
}

std::optional<PersonTrack> take_returned(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                         const Sighting& appeared, std::optional<Vector2> velocity,
                                         double now, const HiddenOptions& options) {
  std::vector<PersonTrack>* from = nullptr;
  std::size_t likeliest = 0;
  double most = options.newcomers;
  for (std::vector<PersonTrack>* among : {&people, &lost}) {
    for (std::size_t i = 0; i < among->size(); ++i) {
      const auto& hidden = (*among)[i].hidden;
      if (!hidden) continue;
      const double density = hidden->density(appeared.position, velocity, now - appeared.time, options);
      if (density <= most) continue;
      most = density;
      from = among;
      likeliest = i;
    }
  }
  if (from == nullptr) return std::nullopt;
  const auto found = from->begin() + static_cast<std::ptrdiff_t>(likeliest);
  const PersonTrack person = *found;
  from->erase(found);
  return person;
}

}  // namespace bw::people
