#include "components/ideal_people/ideal_tracks.hpp"

#include <cmath>

namespace bw {

std::vector<TrackedPerson> ideal_tracks(const std::vector<Mover>& people, const Vector2& robot,
                                        const IdealPeopleOptions& options, Random& random) {
  const double p2 = options.position_noise * options.position_noise;
  const double v2 = options.velocity_noise * options.velocity_noise;
  std::vector<TrackedPerson> tracks;
  for (const Mover& person : people) {
    // Drawn for everybody, so that one person's range does not change another's noise.
    const Vector2 position_error(random.normal(), random.normal());
    const Vector2 velocity_error(random.normal(), random.normal());
    if (!person.position.allFinite() || !person.velocity.allFinite()) continue;
    if ((person.position - robot).norm() > options.range) continue;
    TrackedPerson track{person, Eigen::Vector4d(p2, p2, v2, v2).asDiagonal()};
    track.position += options.position_noise * position_error;
    track.velocity += options.velocity_noise * velocity_error;
    track.predictions.clear();
    const int steps =
        static_cast<int>(std::floor(options.prediction_horizon / options.prediction_step + 1e-9));
    for (int i = 1; i <= steps; ++i) {
      const double t = i * options.prediction_step;
      const double deviation = options.kWalkerAcceleration * t * t / 2.0;
      const double variance = p2 + v2 * t * t + deviation * deviation;
      track.predictions.push_back(
          {t, track.position + track.velocity * t, variance * Eigen::Matrix2d::Identity()});
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace bw
