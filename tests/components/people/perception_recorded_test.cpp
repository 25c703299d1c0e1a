// Detector and tracker on recorded scans of a standing robot (people_laser_stationary, Leigh et al. 2015):
// how many tracks, how long, at what cost; and CLEAR MOT on three stretches that were labelled by hand.
//
// Labels: three people every 0.5 s, each put between the legs that the points in front of the static
// background (80 % quantile of each beam) show; where one leg or none is seen, between neighbours in time.
// Good to 0.2 m. visible = 0: hidden by somebody else, place guessed, not counted. Rows of a person begin
// with their first point.
//
//   people_laser_stationary_labels_97.csv  97.5 to 105 s. Labelled before any track was looked at, then in
//       view while parameters were chosen: no figure of unseen data.
//   people_laser_stationary_labels_33.csv  33 to 53 s: the 20 s from a whole second on, apart from the
//       stretch above, with most points 0.15 m or more in front of the background. All 123 places count,
//       also three without a single point (33.49 s person 3; 49.54 s and 50.04 s person 2).
//   people_laser_stationary_labels_0.csv   0 to 20 s: the 20 s with fewest such points, apart from both. One
//       stands with one leg of three or four points in view until 6.5 s, one comes in at 6.7 s, one is
//       hidden at 10.47 s; 108 places count, two of them without a point (6.98 s and 18.04 s person 3).
//
// The last two were labelled and committed before any track on them was looked at, when the parameters
// stood; only the number and length of the tracks in the whole log were known. The sparse one was added when
// the dense one had shown no error.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "components/files/csv_file.hpp"
#include "components/recordings/files/imported_drive.hpp"
#include "runtime/base/quantile.hpp"
#include "tests/components/people/perception_trial.hpp"
#include "tests/components/people/recorded_picture.hpp"

namespace bw::people::test {
namespace {

struct LabelledSweep {
  double time;
  std::vector<TruePerson> people;
};

std::vector<LabelledSweep> read_labels(const std::string& name) {
  std::vector<LabelledSweep> sweeps;
  const std::string file = std::string(BANDWAGON_SOURCE_DIR) + "/tests/components/people/" + name;
  for (const CsvRow& row : read_csv(file, "t_s,person,visible,x_m,y_m")) {
    if (sweeps.empty() || sweeps.back().time != row.values[0]) sweeps.push_back({row.values[0], {}});
    const bool visible = row.values[2] != 0.0;
    sweeps.back().people.push_back({static_cast<std::uint32_t>(row.values[1]),
                                    {row.values[3], row.values[4]},
                                    {0.0, 0.0},
                                    visible,
                                    visible});
  }
  return sweeps;
}

/// Scores the labelled sweeps of one stretch as they pass, and prints every error.
class Stretch {
 public:
  Stretch(const std::string& name, const std::string& file) : name_(name), labels_(read_labels(file)) {}

  void add(double time, const std::vector<TrackedPerson>& tracks) {
    if (all_scored() || time < labels_[next_].time - 0.03) return;
    const LabelledSweep& sweep = labels_[next_++];
    const Score before = keeper_.score();
    keeper_.add(sweep.time, sweep.people, tracks, [](const Vector2&) { return true; });
    std::set<std::uint32_t> matched;
    for (const TruePerson& person : sweep.people) {
      const std::uint32_t track = keeper_.track_of(person.id);
      matched.insert(track);
      if (person.counted) picture_.labels.push_back({sweep.time, person.position});
      if (track == 0 && person.counted) {
        report(sweep.time, "miss of person", person.id, person.position);
        picture_.misses.push_back({sweep.time, person.position});
      }
      if (track != 0 && person.counted) followers_[person.id].insert(track);
    }
    for (const TrackedPerson& track : tracks)
      if (!matched.contains(track.id)) report(sweep.time, "false track", track.id, track.position);
    if (keeper_.score().switches != before.switches) std::printf("  %.2f s: switch\n", sweep.time);
  }

  bool all_scored() const { return next_ == labels_.size(); }
  const Score& score() const { return keeper_.score(); }
  const std::vector<LabelledSweep>& labels() const { return labels_; }
  const std::string& name() const { return name_; }

  /// Tracks per labelled person.
  double fragmentation() const {
    std::size_t tracks = 0;
    for (const auto& [person, ids] : followers_) tracks += ids.size();
    return static_cast<double>(tracks) / static_cast<double>(followers_.size());
  }

  PicturedStretch picture() const {
    const Score& s = score();
    PicturedStretch picture = picture_;
    picture.title = name_;
    picture.score = "MOTA " + fixed(s.mota(), 3) + ", MOTP " + fixed(s.motp(), 3) + " m, misses " +
                    std::to_string(s.people - s.matched) + " of " + std::to_string(s.people) + ", false " +
                    std::to_string(s.false_positives) + ", switches " + std::to_string(s.switches);
    return picture;
  }

  void print() const {
    std::printf("%s, %zu sweeps: %s, tracks per person %.2f\n", name_.c_str(), labels_.size(),
                picture().score.c_str(), fragmentation());
  }

 private:
  static void report(double time, const char* what, std::uint32_t id, const Vector2& p) {
    std::printf("  %.2f s: %s %u at (%.2f, %.2f)\n", time, what, id, p.x(), p.y());
  }

  std::string name_;
  std::vector<LabelledSweep> labels_;
  std::size_t next_ = 0;
  ScoreKeeper keeper_;
  std::map<std::uint32_t, std::set<std::uint32_t>> followers_;
  PicturedStretch picture_;
};

TEST(RecordedPeople, AreFollowed) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "recorded data are not at hand (BANDWAGON_SHARED)";
  const RecordedDrive drive =
      import_drive(std::string(BANDWAGON_SOURCE_DIR) + "/config/imports/laser.yaml",
                   {std::filesystem::path(shared) / "data" / "people_laser_stationary"})
          .drive;
  const ScanGeometry& geometry = drive.scans.front().geometry;
  Stretch sparse("0 to 20 s, not seen when parameters were chosen", "people_laser_stationary_labels_0.csv");
  Stretch dense("33 to 53 s, not seen when parameters were chosen", "people_laser_stationary_labels_33.csv");
  Stretch seen("97.5 to 105 s, seen when parameters were chosen", "people_laser_stationary_labels_97.csv");
  const std::array stretches{&sparse, &dense, &seen};
  ASSERT_EQ(sparse.labels().size(), 41U);
  ASSERT_EQ(dense.labels().size(), 41U);
  ASSERT_EQ(seen.labels().size(), 16U);

  Detector detector({});
  Tracker tracker({});
  RecordedTracks tracks;
  std::vector<double> milliseconds;
  for (const ScanSample& scan : drive.scans) {
    const LaserSweep sweep{
        scan.time,          {},         geometry.angle_min, geometry.angle_increment, geometry.range_min,
        geometry.range_max, scan.ranges};
    const double before = thread_milliseconds();
    const std::vector<Vector2> keep = tracker.keep_out();
    std::vector<TrackedPerson> people = tracker.update(detector.detect(sweep, {std::nullopt, keep}));
    milliseconds.push_back(thread_milliseconds() - before);
    std::erase_if(people, [](const TrackedPerson& person) { return person.confidence < kConfirmed; });
    const double time = scan.time.to_seconds();
    for (const TrackedPerson& person : people) {
      ASSERT_TRUE(person.position.allFinite() && person.velocity.allFinite());
      tracks[person.id].push_back({time, person.position});
    }
    for (Stretch* stretch : stretches) stretch->add(time, people);
  }

  std::size_t sightings = 0;
  std::size_t brief = 0;
  for (const auto& [id, track] : tracks) {
    sightings += track.size();
    brief += track.size() < 20 ? 1 : 0;
  }
  RecordProperty("tracks", static_cast<int>(tracks.size()));
  std::printf(
      "%zu sweeps, %zu tracks, mean length %.1f s, %zu shorter than 2 s; CPU median %.2f ms, worst %.2f ms\n",
      drive.scans.size(), tracks.size(),
      0.1 * static_cast<double>(sightings) / static_cast<double>(tracks.size()), brief,
      quantile(milliseconds, 0.5), quantile(milliseconds, 1.0));
  for (const Stretch* stretch : stretches) stretch->print();

  Score unseen = sparse.score();
  unseen.add(dense.score());
  std::printf("both that were not seen: MOTA %.3f, MOTP %.3f m, %ld places of people\n", unseen.mota(),
              unseen.motp(), unseen.people);
  if (const char* folder = std::getenv("BANDWAGON_PICTURES"))
    std::ofstream(std::filesystem::path(folder) / "people_tracks.svg") << recorded_picture(
        tracks, drive.scans.back().time.to_seconds(), {sparse.picture(), dense.picture(), seen.picture()});

  for (const Stretch* stretch : stretches) {
    ASSERT_TRUE(stretch->all_scored());
    // The best tracker of Leigh et al. (Table III) has 0.332 over the whole of the log this is a part of.
    EXPECT_GT(stretch->score().mota(), 0.332) << stretch->name();
    EXPECT_LE(stretch->score().motp(), 0.10) << stretch->name();  // asked for in simulation
  }
  // A little below what was reached, so that a loss shows: 0.731, 0.984 and 1.000.
  EXPECT_GT(sparse.score().mota(), 0.70);
  EXPECT_GT(dense.score().mota(), 0.95);
  EXPECT_GT(seen.score().mota(), 0.95);
}

}  // namespace
}  // namespace bw::people::test
