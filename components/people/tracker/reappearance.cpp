#include "components/people/tracker/reappearance.hpp"

#include <algorithm>
#include <limits>

namespace bw::people {

std::optional<double> doubt_of_return(const PastState& lost, const Vector2& place, double time,
                                      const ReturnOptions& options) {
  const double away = std::max(0.0, time - lost.time);
  if (away > options.remembered) return std::nullopt;
  const Vector2 moved = place - lost.position;
  if (moved.norm() > options.slack + options.speed * away) return std::nullopt;
  const Vector2 way = away * lost.velocity;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(moved.dot(way) / square, -1.0, 1.0) : 0.0;
  return (moved - share * way).norm() / (options.slack + options.deviation * away);
}

std::optional<PersonTrack> take_returned(std::vector<PersonTrack>& people, std::vector<PersonTrack>& lost,
                                         const Sighting& appeared, double now, const ReturnOptions& options) {
  std::vector<PersonTrack>* from = nullptr;
  std::size_t likeliest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::vector<PersonTrack>* among : {&people, &lost}) {
    for (std::size_t i = 0; i < among->size(); ++i) {
      const PastState& sure = (*among)[i].sure;
      if (among == &people && now - sure.time < options.absent) continue;
      const auto doubt = doubt_of_return(sure, appeared.position, appeared.time, options);
      if (!doubt || *doubt >= least) continue;
      least = *doubt;
      from = among;
      likeliest = i;
    }
  }
  if (from == nullptr) return std::nullopt;
  const auto place = from->begin() + static_cast<std::ptrdiff_t>(likeliest);
  const PersonTrack person = *place;
  from->erase(place);
  return person;
}

}  // namespace bw::people
