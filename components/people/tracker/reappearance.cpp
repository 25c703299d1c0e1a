#include "components/people/tracker/reappearance.hpp"

#include <algorithm>

namespace bw::people {

std::optional<double> doubt_of_return(const PersonTrack& lost, const Vector2& place, double time,
                                      const ReturnOptions& options) {
  const double away = std::max(0.0, time - lost.sure.time);
  if (away > options.remembered) return std::nullopt;
  const Vector2 moved = place - lost.sure.position;
  if (moved.norm() > options.slack + options.speed * away) return std::nullopt;
  const Vector2 way = away * lost.sure.velocity;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(moved.dot(way) / square, -1.0, 1.0) : 0.0;
  return (moved - share * way).norm() / (options.slack + options.deviation * away);
}

}  // namespace bw::people
