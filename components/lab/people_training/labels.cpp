#include "components/lab/people_training/labels.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "components/world/ray.hpp"

namespace bw::people {
namespace {

constexpr double kMajority = 0.8;

/// What most likely returned the beams: the furniture nearest to the middle of where they truly ended.
Piece piece_at(const TrainingRoom& room, const RoomSweep& sweep, std::span<const int> beams) {
  Vector2 sum{0.0, 0.0};
  int count = 0;
  for (const int beam : beams) {
    const double range = sweep.exact.ranges[static_cast<std::size_t>(beam)];
    if (!std::isfinite(range)) continue;
    const double bearing = sweep.exact.angle_min + beam * sweep.exact.angle_increment;
    sum += sweep.X_ML * (range * direction(bearing));
    ++count;
  }
  return count > 0 ? room.furniture().nearest(sum / count) : Piece::wall;
}

}  // namespace

std::vector<Label> label_clusters(const TrainingRoom& room, const RoomSweep& sweep,
                                  const Detector& detector) {
  std::vector<Label> labels;
  std::vector<int> on_leg(sweep.legs.size());
  for (const Cluster& cluster : detector.clusters().all) {
    std::fill(on_leg.begin(), on_leg.end(), 0);
    int human = 0;
    for (const int beam : detector.clusters().beams_of(cluster)) {
      const int leg = sweep.leg_of[static_cast<std::size_t>(beam)];
      if (leg < 0) continue;
      ++on_leg[static_cast<std::size_t>(leg)];
      ++human;
    }
    Label label;
    if (human > 0) {
      const auto most = std::max_element(on_leg.begin(), on_leg.end());
      label.leg = static_cast<int>(most - on_leg.begin());
      const int other_leg = on_leg[static_cast<std::size_t>(label.leg ^ 1)];
      const double enough = kMajority * cluster.count;
      label.kind = *most >= enough ? Kind::leg : *most + other_leg >= enough ? Kind::body : Kind::mixed;
    } else {
      label.piece = piece_at(room, sweep, detector.clusters().beams_of(cluster));
    }
    labels.push_back(label);
  }
  return labels;
}

std::vector<Visibility> visibility(const RoomSweep& sweep, const Detector& detector) {
  const Pose2 X_MO = sweep.X_MO();
  std::vector<Visibility> people(sweep.people.size());
  const Beams& beams = detector.beams();
  for (int i = 0; i < beams.size(); ++i) {
    const auto beam = static_cast<std::size_t>(i);
    const Vector2 ray = direction(beams.angle_min + i * beams.angle_increment + X_MO.theta);
    for (std::size_t person = 0; person < people.size(); ++person) {
      const bool crosses = ray_hit(sweep.X_ML.position(), ray, sweep.legs[2 * person]) != kNoHit ||
                           ray_hit(sweep.X_ML.position(), ray, sweep.legs[2 * person + 1]) != kNoHit;
      if (crosses) ++people[person].expected;
    }
    if (beams.kinds[beam] != BeamKind::hit) continue;
    const int leg = sweep.leg_of[beam];
    if (leg >= 0) ++people[static_cast<std::size_t>(leg / 2)].seen;
  }
  return people;
}

}  // namespace bw::people
