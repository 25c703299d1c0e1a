// The suites of the dense square keep the rule by which their times were fixed.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "components/lab/evaluate/suite.hpp"
#include "components/world/files/track_file.hpp"

namespace bw {
namespace {

constexpr std::size_t kStarts = 40;
constexpr double kFree = 1.2;        // [m] around the start
constexpr double kFreeFor = 2.0;     // [s]
constexpr double kBeforeEnd = 45.0;  // [s]

const ConfigNode& at(const ConfigNode& node, const std::vector<std::string>& keys) {
  const ConfigNode* found = &node;
  for (const std::string& key : keys) {
    const ConfigNode* next = found->find(key);
    if (next == nullptr) throw std::runtime_error("no " + key);
    found = next;
  }
  return *found;
}

TEST(RecordedSquare, NobodyStandsAtAStartAndNoDriveOutlastsTheRecording) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded people are not at hand";
  const std::vector<Track> tracks =
      read_tracks(std::string(shared) + "/data/eth_ucy_pedestrians/students001.csv");
  double end = 0.0;
  for (const Track& track : tracks) end = std::max(end, track.samples.back().time);
  for (const char* name : {"students001_there", "students001_back"}) {
    const Suite suite = load_suite(std::string(BANDWAGON_SOURCE_DIR) + "/config/suites/" + name + ".yaml");
    EXPECT_LT(suite.options.time_limit, kBeforeEnd);
    EXPECT_EQ(suite.options.episodes.size(), kStarts);
    double last = -1.0;
    for (std::size_t i = 0; i < suite.options.episodes.size(); ++i) {
      const std::string& episode = suite.options.episodes[i].name;
      const Graph graph = suite.graph_of(i);
      const ConfigNode& world = graph.find("world")->parameters;
      const Vector2 start(std::stod(at(world, {"start", "x"}).scalar),
                          std::stod(at(world, {"start", "y"}).scalar));
      const double time = std::stod(at(world, {"people", "replay", "start_time"}).scalar);
      EXPECT_GT(time, last) << episode;
      EXPECT_LE(time, end - kBeforeEnd) << episode;
      last = time;
      for (const Track& track : tracks) {
        for (const TrackSample& sample : track.samples) {
          if (sample.time < time - 1e-6 || sample.time > time + kFreeFor + 1e-6) continue;
          EXPECT_GT((sample.position - start).norm(), kFree) << episode << ", person " << track.id;
        }
      }
    }
  }
}

}  // namespace
}  // namespace bw
