#include "components/lab/people_training/samples.hpp"

#include <algorithm>

#include "components/people/detector/classifier.hpp"

namespace bw::people {
namespace {

/// Of the outlines of walls, which are many and easily told, every third is taken.
constexpr int kOneWallOf = 3;

}  // namespace

std::vector<Sample> collect(const Collection& collection) {
  std::vector<Sample> samples;
  Outline outline;
  int walls = 0;
  for (int r = 0; r < collection.rooms; ++r) {
    TrainingRoom room({}, collection.first_seed + static_cast<std::uint64_t>(r));
    const DetectorOptions options;
    Detector detector(options);
    std::vector<Vector2> people;
    const int sweeps = static_cast<int>(collection.seconds / room.period());
    const int every = std::max(1, static_cast<int>(collection.every / room.period()));
    for (int s = 0; s < sweeps; ++s) {
      const RoomSweep& sweep = room.next();
      people.clear();
      const Pose2 X_OM = inverse(sweep.X_MO());
      for (const Person& person : sweep.people) people.push_back(X_OM * person.position);
      detector.detect(room.view(), {nullptr, std::nullopt, people});
      if (s % every != 0) continue;
      const std::vector<Label> labels = label_clusters(room, sweep, detector);
      for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i].kind == Kind::mixed) continue;
        const bool wall = labels[i].kind == Kind::other && labels[i].piece == Piece::wall;
        if (wall && walls++ % kOneWallOf != 0) continue;
        read_outline(detector.beams(), detector.clusters(), detector.clusters().all[i], outline);
        if (outline.width() > kWidestPerson) continue;
        samples.push_back({features_of(outline, fit_disc(outline, options.legs), detector.neighbours()[i]),
                           labels[i].kind, labels[i].piece});
      }
    }
  }
  return samples;
}

}  // namespace bw::people
