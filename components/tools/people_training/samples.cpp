#include "components/tools/people_training/samples.hpp"

#include "components/people/detector/classifier.hpp"

namespace bw::people {

std::vector<Sample> collect(const Collection& collection) {
  std::vector<Sample> samples;
  Outline outline;
  for (int r = 0; r < collection.rooms; ++r) {
    TrainingRoom room({}, collection.first_seed + static_cast<std::uint64_t>(r));
    const DetectorOptions options;
    Detector detector(options);
    std::vector<Vector2> people;
    for (int s = 0; s < collection.sweeps; ++s) {
      const RoomSweep& sweep = room.next();
      people.clear();
      const Pose2 X_OM = inverse(sweep.X_MO());
      for (const Person& person : sweep.people) people.push_back(X_OM * person.position);
      detector.detect(room.view(), {std::nullopt, people});
      if (s % collection.every != 0) continue;
      const std::vector<Label> labels = label_clusters(room, sweep, detector);
      for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i].kind == Kind::mixed) continue;
        read_outline(detector.beams(), detector.clusters(), detector.clusters().all[i], outline);
        if (outline.width() > kWidestPerson) continue;
        samples.push_back({features_of(outline, fit_disc(outline, options.legs)), labels[i].kind});
      }
    }
  }
  return samples;
}

}  // namespace bw::people
