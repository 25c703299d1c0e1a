// Search of a whole map for the pose of one sweep: how often is the truth among what it finds?
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

#include <gtest/gtest.h>

#include "components/localization/laser/laser_model.hpp"
#include "components/localization/laser/pose_search.hpp"
#include "tests/components/localization/laser_robot.hpp"
#include "tests/components/localization/laser_scene.hpp"

namespace bw::localization {
namespace {

double thread_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

struct Found {
  int first = 0;  ///< times that the truth was the best pose
  int among = 0;  ///< times that it was one of the poses
  double hypotheses = 0.0;
  double nodes = 0.0;
  double milliseconds = 0.0;
  double longest_slice = 0.0;
  double error = 0.0;  ///< mean of those found [m]
};

Found search_alone(const OccupancyGrid& map, const test::SensorNoise& noise, int trials,
                   const PoseSearchOptions& options) {
  const LikelihoodField field(map, {});
  PoseSearch search(field, options);
  const test::Roads roads(map);
  test::SensedRobot robot(map, noise, 11);
  Random random(12);
  Found found;
  for (int trial = 0; trial < trials; ++trial) {
    const Vector2 p = roads.center(roads.random_place(random));
    const Pose2 truth{p.x(), p.y(), random.uniform(-3.14, 3.14)};
    const double begun = thread_milliseconds();
    search.begin(beam_ends(robot.sweep({}, truth), 60));
    double slice = thread_milliseconds();
    while (!search.advance(10000)) {
      const double now = thread_milliseconds();
      found.longest_slice = std::max(found.longest_slice, now - slice);
      slice = now;
    }
    found.milliseconds += thread_milliseconds() - begun;
    found.nodes += static_cast<double>(search.visited());
    found.hypotheses += static_cast<double>(search.results().size());
    for (const PoseHypothesis& pose : search.results()) {
      const double error = (pose.X_MB.position() - p).norm();
      if (error > 0.4 || std::abs(wrap_angle(pose.X_MB.theta - truth.theta)) > 0.35) continue;
      found.first += &pose == search.results().data();
      found.error += error;
      ++found.among;
      break;
    }
  }
  found.error /= std::max(1, found.among);
  found.hypotheses /= trials;
  found.nodes /= trials;
  found.milliseconds /= trials;
  std::printf(
      "first %d, among %d of %d, hypotheses %.1f, nodes %.0f, %.1f ms, longest slice %.2f ms, error %.3f m\n",
      found.first, found.among, trials, found.hypotheses, found.nodes, found.milliseconds,
      found.longest_slice, found.error);
  return found;
}

int trials() {
  const char* asked = std::getenv("BANDWAGON_LOCALIZATION_TRIALS");
  return asked == nullptr ? 20 : 10 * std::atoi(asked);
}

TEST(PoseSearch, FindsTheRoomAmongOthersLikeIt) {
  const Found found = search_alone(test::repeated_rooms(1), {}, trials(), {});
  EXPECT_GE(found.among, trials() * 9 / 10);
}

TEST(PoseSearch, FindsTheRoomWithPeopleAndRandomReturns) {
  const Found found =
      search_alone(test::repeated_rooms(1), {.people = 6, .random_returns = 0.05}, trials(), {});
  EXPECT_GE(found.among, trials() * 9 / 10);
}

class RecordedMap : public testing::TestWithParam<const char*> {};
TEST_P(RecordedMap, PoseIsAmongThoseFound) {
  const auto map = test::recorded_map(GetParam());
  if (!map) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded maps are not at hand";
  const Found found = search_alone(map->grid, {}, trials(), {});
  EXPECT_GE(found.among, trials() * 9 / 10);
}
INSTANTIATE_TEST_SUITE_P(PoseSearch, RecordedMap, testing::Values("tb3_sandbox", "small_house", "warehouse"));

}  // namespace
}  // namespace bw::localization
