#include "components/lab/experiments/crossing_experiment.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "components/lab/experiments/crossing_report.hpp"
#include "runtime/parameters/config_error.hpp"

namespace bw {
namespace {

// Straight along x with constant speed, one position every 0.1 s.
std::vector<TimedPosition> straight(double speed, double y, double seconds) {
  std::vector<TimedPosition> path;
  for (int i = 0; i <= std::lround(10.0 * seconds); ++i) path.push_back({0.1 * i, {0.1 * i * speed, y}});
  return path;
}

TEST(Passing, IsDecidedByWhoIsAtTheCrossingFirst) {
  // The robot crosses x = 4 after 4 / 0.8 = 5 s at y = 0; a person from (4, -d) with 1 m/s is there after
  // d s.
  const std::vector<TimedPosition> path = straight(0.8, 0.0, 10.0);
  EXPECT_EQ(passing(path, {{4.0, -4.9}, {0.0, 1.0}}), Passing::behind);
  EXPECT_EQ(passing(path, {{4.0, -5.1}, {0.0, 1.0}}), Passing::in_front);
  // The same from above.
  EXPECT_EQ(passing(path, {{4.0, 4.9}, {0.0, -1.0}}), Passing::behind);
  EXPECT_EQ(passing(path, {{4.0, 5.1}, {0.0, -1.0}}), Passing::in_front);
}

TEST(Passing, CountsWhereTheRobotCrossesTheLine) {
  // At y = 1 the person from (4, -4.5) arrives after 5.5 s, half a second after the robot; at y = -1 before.
  EXPECT_EQ(passing(straight(0.8, 1.0, 10.0), {{4.0, -4.5}, {0.0, 1.0}}), Passing::in_front);
  EXPECT_EQ(passing(straight(0.8, -1.0, 10.0), {{4.0, -4.5}, {0.0, 1.0}}), Passing::behind);
}

TEST(Passing, ObliqueWalkersAndTurnedScenesAgree) {
  // A walker along (1, 1) / sqrt 2 with speed 1 from (2, -2) meets the x axis at (4, 0) after 2.83 s; the
  // robot is there after 4 / v.
  const double c = std::sqrt(0.5);
  EXPECT_EQ(passing(straight(1.0, 0.0, 10.0), {{2.0, -2.0}, {c, c}}), Passing::behind);
  EXPECT_EQ(passing(straight(1.6, 0.0, 10.0), {{2.0, -2.0}, {c, c}}), Passing::in_front);
  for (const double angle : {0.3, 1.7, -2.5}) {
    const Eigen::Rotation2Dd rotation(angle);
    std::vector<TimedPosition> path = straight(1.0, 0.0, 10.0);
    for (TimedPosition& p : path) p.position = rotation * p.position;
    EXPECT_EQ(passing(path, {rotation * Vector2(2.0, -2.0), rotation * Vector2(c, c)}), Passing::behind)
        << angle;
  }
}

TEST(Passing, ARobotThatStaysOnItsSideHasNotCrossed) {
  EXPECT_EQ(passing(straight(0.3, 0.0, 10.0), {{4.0, -5.0}, {0.0, 1.0}}), Passing::not_crossed);
  EXPECT_EQ(passing({}, {{4.0, -5.0}, {0.0, 1.0}}), Passing::not_crossed);
  std::vector<TimedPosition> and_back = straight(1.0, 0.0, 6.0);
  and_back.push_back({10.0, {1.0, 0.0}});
  EXPECT_EQ(passing(and_back, {{4.0, -3.0}, {0.0, 1.0}}), Passing::not_crossed);
}

TEST(Passing, TheLastCrossingCounts) {
  // In front at 4 s, back, and across again at 8.5 s, when the person (there after 5 s) has gone by.
  const std::vector<TimedPosition> path = {
      {0.0, {0.0, 0.0}}, {4.5, {4.5, 0.0}}, {7.5, {3.0, 0.0}}, {9.5, {5.0, 0.0}}};
  EXPECT_EQ(passing(path, {{4.0, -5.0}, {0.0, 1.0}}), Passing::behind);
}

TEST(CrossingScene, JittersBothPeopleWithinHalfAMeter) {
  double lowest = 1e9, highest = -1e9;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Scene scene = crossing_scene({}, seed);
    ASSERT_EQ(scene.obstacles.size(), 2u);
    const SceneObstacle& a = scene.obstacles[0];
    const SceneObstacle& b = scene.obstacles[1];
    EXPECT_EQ(a.position.x(), 4.0);
    EXPECT_EQ(b.position.x(), 6.5);
    EXPECT_NEAR(a.position.y(), -5.2, 0.5);
    EXPECT_NEAR(b.position.y(), 7.6, 0.5);
    EXPECT_EQ(a.velocity, Vector2(0.0, 1.0));
    EXPECT_EQ(b.velocity, Vector2(0.0, -1.0));
    lowest = std::min(lowest, a.position.y());
    highest = std::max(highest, a.position.y());
  }
  // 200 uniform draws leave a gap of 0.05 at an end with probability 0.95^200 = 4e-5.
  EXPECT_LT(lowest, -5.65);
  EXPECT_GT(highest, -4.75);
}

TEST(CrossingExperiment, SameSeedsGiveTheSameRuns) {
  const CrossingEntry entry{"teb", "teb", {}};
  const CrossingResult first = run_crossing(entry, {}, 3);
  const CrossingResult again = run_crossing(entry, {}, 3);
  ASSERT_EQ(first.runs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(first.runs[i].episode.max_collision_index, again.runs[i].episode.max_collision_index);
    ASSERT_EQ(first.runs[i].path.size(), again.runs[i].path.size());
    EXPECT_EQ(first.runs[i].path.back().position, again.runs[i].path.back().position);
  }
  EXPECT_EQ(crossing_json({}, {first}), crossing_json({}, {again}));
}

TEST(CrossingExperiment, AtTheProposedPlacesTheRobotComesAfterBoth) {
  // Unhindered it is at x = 4 after 5 s and at 6.5 after 7.5 s; A is there after 3.7 to 4.7 s, B after 6.1 to
  // 7.1 s.
  const CrossingResult result = run_crossing({"teb", "teb", {}}, proposed_crossing(), 5);
  const CrossingSummary s = summarize(result);
  EXPECT_EQ(s.share_behind_a, 1.0);
  EXPECT_EQ(s.share_behind_b, 1.0);
  EXPECT_EQ(s.successes, 5);
}

TEST(CrossingExperiment, RefusesUnknownPlannersAndParameters) {
  EXPECT_THROW(run_crossing({"x", "nobody", {}}, {}, 1), std::runtime_error);
  EXPECT_THROW(run_crossing({"x", "teb", {"teb.nothing=1"}}, {}, 1), ConfigError);
}

CrossingResult made_up(const std::string& label, int behind, double index, bool contact) {
  CrossingResult result{{label, label, {}}, {}};
  for (int i = 0; i < 10; ++i) {
    CrossingRun run;
    run.passing_a = i < behind ? Passing::behind : Passing::in_front;
    run.episode.max_collision_index = index;
    run.episode.success = !contact;
    run.episode.collision = contact;
    result.runs.push_back(run);
  }
  return result;
}

TEST(CrossingCriteria, AskForTwentyPercentMoreNoContactAndALowerIndex) {
  const std::vector<CrossingResult> results = {made_up("teb", 1, 0.4, false), made_up("good", 3, 0.3, false),
                                               made_up("bad", 2, 0.4, true)};
  for (const Criterion& c : crossing_criteria(results, "good", "teb")) EXPECT_TRUE(c.met) << c.name;
  for (const Criterion& c : crossing_criteria(results, "bad", "teb")) EXPECT_FALSE(c.met) << c.name;
  EXPECT_THROW(crossing_criteria(results, "eteb", "teb"), std::out_of_range);
}

TEST(CrossingEntries, EveryPublishedFormIsAPlannerWithKnownParameters) {
  for (const CrossingEntry& entry : published_entries(true))
    EXPECT_EQ(run_crossing(entry, {}, 0).runs.size(), 0u) << entry.label;
  EXPECT_EQ(default_entries(false).size() + 1, default_entries(true).size());
}

}  // namespace
}  // namespace bw
