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
    const Vector2 p = roads.center(roads.random_cell(random));
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

// Every heading and every cell of a small map, compared one by one.
TEST(PoseSearch, NoPoseOfTheMapFitsBetterThanTheFirstFound) {
  OccupancyGrid map = test::repeated_rooms(4);
  OccupancyGrid corner{.resolution = 0.05, .origin = map.origin, .width = 120, .height = 120};
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 120; ++column) corner.cells.push_back(map.at(column, row));
  }
  const LikelihoodField field(corner, {});
  test::SensedRobot robot(corner, {.people = 3}, 5);
  const Pose2 truth{-8.2, -7.1, 0.4};
  const BeamEnds ends = beam_ends(robot.sweep({}, truth), 30);
  PoseSearch search(field, {});
  search.begin(ends);
  while (!search.advance(100)) continue;
  ASSERT_FALSE(search.results().empty());
  const auto likelihood = [&](const Pose2& X_MB) {
    double sum = 0.0;
    for (std::size_t b = 0; b < ends.size(); ++b) {
      const Vector2 end = X_MB * Vector2{static_cast<double>(ends.x[b]), static_cast<double>(ends.y[b])};
      sum += field.log_likelihood(end.x(), end.y());
    }
    return sum;
  };
  const double found = likelihood(search.results().front().X_MB);
  double best = -1e9;
  for (double theta = -3.14; theta < 3.14; theta += 0.07) {
    for (int row = 0; row < 120; row += 2) {
      for (int column = 0; column < 120; column += 2) {
        const Vector2 p = corner.center(column, row);
        if (field.distance(p.x(), p.y()) > 0.1) best = std::max(best, likelihood({p.x(), p.y(), theta}));
      }
    }
  }
  EXPECT_GE(found, best - 0.5);  // rounding of the table to 255 steps: 30 ends, 2.4 / 255 each, and of cells
}

TEST(PoseSearch, SlicesDoNotChangeWhatIsFound) {
  const OccupancyGrid map = test::repeated_rooms(2);
  const LikelihoodField field(map, {});
  test::SensedRobot robot(map, {}, 6);
  const BeamEnds ends = beam_ends(robot.sweep({}, {2.0, 2.5, 1.0}), 60);
  PoseSearch at_once(field, {});
  at_once.begin(ends);
  EXPECT_TRUE(at_once.advance(1 << 30));
  PoseSearch sliced(field, {});
  sliced.begin(ends);
  int slices = 1;
  while (!sliced.advance(500)) ++slices;
  EXPECT_GT(slices, 20);
  ASSERT_EQ(sliced.results().size(), at_once.results().size());
  for (std::size_t i = 0; i < sliced.results().size(); ++i) {
    EXPECT_EQ(sliced.results()[i].X_MB, at_once.results()[i].X_MB);
    EXPECT_EQ(sliced.results()[i].fit, at_once.results()[i].fit);
  }
}

TEST(PoseSearch, WithoutBeamsOrFreeSpaceItEndsWithNothing) {
  const LikelihoodField none;
  PoseSearch nowhere(none, {});
  nowhere.begin({.x = {1.0F}, .y = {0.0F}});
  while (!nowhere.advance(1000)) continue;
  EXPECT_TRUE(nowhere.results().empty());
  PoseSearch rooms(LikelihoodField(test::repeated_rooms(1), {}), {});
  rooms.begin({});
  EXPECT_TRUE(rooms.advance(1));
  EXPECT_TRUE(rooms.results().empty());
}

}  // namespace
}  // namespace bw::localization
