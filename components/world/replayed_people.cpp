#include "components/world/replayed_people.hpp"

#include <algorithm>
#include <utility>

namespace bw {

ReplayedPeople::ReplayedPeople(const ReplayOptions& options, std::vector<Track> tracks,
                               std::uint32_t id_offset)
    : options_(options), tracks_(std::move(tracks)), id_offset_(id_offset) {}

void ReplayedPeople::step(double dt, const Surroundings&, std::vector<Person>& people) {
  time_ += dt;
  if (time_ > options_.duration) return;
  const double recorded = options_.start_time + time_;
  const Pose2 X_map_recording{options_.x, options_.y, options_.theta};
  for (const Track& track : tracks_) {
    const auto later = [](double t, const TrackSample& sample) { return t < sample.time; };
    const auto next = std::upper_bound(track.samples.begin(), track.samples.end(), recorded, later);
    if (next == track.samples.begin() || next == track.samples.end()) continue;
    const auto last = next - 1;
    const Vector2 velocity = (next->position - last->position) / (next->time - last->time);
    const Vector2 position = last->position + velocity * (recorded - last->time);
    people.push_back({track.id + id_offset_, X_map_recording * position, rotate(X_map_recording, velocity),
                      options_.radius});
  }
}

}  // namespace bw
