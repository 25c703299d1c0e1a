// People whose real walks were recorded, walked again. They do not react to anything.
#pragma once

#include <cstdint>
#include <vector>

#include "components/world/person.hpp"
#include "runtime/base/field.hpp"

namespace bw {

/// Where one recorded person was at `time` [s], in the frame of the recording [m].
struct TrackSample {
  double time = 0.0;
  Vector2 position{0.0, 0.0};
};

/// One person's samples, rising in time.
struct Track {
  std::uint32_t id = 0;
  std::vector<TrackSample> samples;
};

struct ReplayOptions {
  double start_time = 0.0;
  /// [s] after this time of replay nobody is left (set by code alone)
  double duration = 1e6;
  /// [m] origin of the recording in map (set by code alone)
  double x = 0.0;
  /// [m] likewise (set by code alone)
  double y = 0.0;
  /// [rad] angle of the recording in map (set by code alone)
  double theta = 0.0;
  /// [m] radius of the disc that counts as contact (set by code alone)
  double radius = 0.3;

  template <class Visitor>
  void fields(Visitor& v) {
    v("start_time", start_time,
      {.unit = "s", .min = 0, .max = 1e6, .doc = "recorded time at which the world starts"});
    v.retired({"radius", "x", "y", "theta"}, "a constant of replayed_people.hpp");
  }
};

class ReplayedPeople final : public PeopleModel {
 public:
  /// A person is present from the first to the last sample and moves linearly between samples; ids are the
  /// recorded ones plus `id_offset`.
  ReplayedPeople(const ReplayOptions& options, std::vector<Track> tracks, std::uint32_t id_offset);
  void step(double dt, const Surroundings& surroundings, std::vector<Person>& people) override;

 private:
  ReplayOptions options_;
  std::vector<Track> tracks_;
  std::uint32_t id_offset_;
  double time_ = 0.0;  ///< since the start of the world [s]
};

}  // namespace bw
