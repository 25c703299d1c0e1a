#include "components/lab/bench/crowd_episode.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/crowd_people.hpp"
#include "components/lab/bench/crowd_recording.hpp"
#include "components/lab/bench/crowd_report.hpp"
#include "components/lab/bench/crowd_verdict.hpp"
#include "components/lab/bench/crowd_walk.hpp"
#include "tests/components/lab/bench/constant_planner.hpp"

namespace bw {
namespace {

using test::ConstantPlanner;

double no_time() { return 0.0; }

CrowdEpisode drive(const std::vector<SceneObstacle>& obstacles, double speed, const SceneFile& file) {
  ConstantPlanner planner({speed, 0.0});
  return drive_crowd({"hand made", {}, {12.0, 0.0, 0.0}, obstacles}, file, planner, no_time);
}

TEST(CrowdWalk, WalkersAreMirroredAtTheWalls) {
  const SceneBox box{-1.0, 13.0, -4.0, 4.0};
  const SceneObstacle walker{{12.0, -3.0}, 0.3, {1.0, -0.5}};
  // After 4 s: x = 16 is mirrored at 13 to 10, y = -5 at -4 to -3.
  EXPECT_TRUE(position_at(walker, box, 4.0).isApprox(Vector2(10.0, -3.0)));
  EXPECT_TRUE(velocity_at(walker, box, 4.0).isApprox(Vector2(-1.0, 0.5)));
  // After one period of x (28 s), y = -17 has met three walls: -17 -> 9 -> -1.
  EXPECT_TRUE(position_at(walker, box, 28.0).isApprox(Vector2(12.0, -1.0)));
  EXPECT_TRUE(velocity_at(walker, box, 28.0).isApprox(Vector2(1.0, -0.5)));
  const SceneObstacle outside{{20.0, 0.0}, 0.3, {0.0, 0.0}};
  EXPECT_EQ(position_at(outside, box, 4.0), outside.position);
}

TEST(CrowdEpisode, StraightDriveHasTheTimeAndJerkOfTheRule) {
  // The speed rises by 2 acc_max 0.1 s = 0.2 m/s per period: 0.3 m in 5 periods, then 0.1 m each. 11.65 m are
  // reached in 5 + 114 periods. One jerk of 2 / 0.1 = 20 m/s^3 among 118 differences.
  SceneFile file = crowd_rules();
  file.closed_loop->goal_tolerance = 0.35;
  const CrowdEpisode episode = drive({}, 1.0, file);
  EXPECT_TRUE(episode.success);
  EXPECT_NEAR(episode.time, 11.9, 1e-9);
  EXPECT_NEAR(episode.rms_jerk, 20.0 / std::sqrt(118.0), 1e-9);
  EXPECT_EQ(episode.ms.size(), 119u);
  EXPECT_EQ(episode.max_collision_index, 0.0);
}

TEST(CrowdEpisode, DrivingThroughADiscIsACollisionAtSpeedAndNoSuccess) {
  const CrowdEpisode episode = drive({{{6.0, 0.5}, 0.3, {0.0, 0.0}}}, 1.0, crowd_rules());
  EXPECT_TRUE(episode.collision);
  EXPECT_TRUE(episode.collision_at_speed);
  EXPECT_FALSE(episode.success);
  EXPECT_NEAR(episode.min_clearance, 0.2, 1e-3);  // passes the centre at 0.5 m
  EXPECT_LT(episode.time, 13.0);                  // the run goes on to the goal
}

TEST(CrowdEpisode, AWalkerWhoWalksIntoAStandingRobotIsNoContactAtSpeed) {
  const CrowdEpisode episode = drive({{{-0.9, 3.0}, 0.3, {0.3, -1.0}}}, 0.0, crowd_rules());
  EXPECT_TRUE(episode.collision);
  EXPECT_FALSE(episode.collision_at_speed);
  EXPECT_NEAR(episode.time, 60.0, 1e-9);
  EXPECT_GT(episode.max_collision_index, 0.99);  // it passes the centre
}

TEST(CrowdEpisode, CollisionIndexIsThatOfTheNearestApproach) {
  // A walker crosses ahead of a standing robot along x = 0.9: CI = exp(-0.81 / 0.72) = 0.3247.
  const CrowdEpisode episode = drive({{{0.9, 3.9}, 0.3, {0.0, -1.0}}}, 0.0, crowd_rules());
  EXPECT_NEAR(episode.max_collision_index, std::exp(-0.81 / 0.72), 1e-9);
  EXPECT_FALSE(episode.collision);
  EXPECT_FALSE(episode.success);
}

std::vector<JudgedContact> judged_drive(const std::vector<SceneObstacle>& obstacles, double speed) {
  ConstantPlanner planner({speed, 0.0});
  const Scene scene{"hand made", {}, {12.0, 0.0, 0.0}, obstacles};
  const SceneFile file = crowd_rules();
  return judge_crowd(scene, file, drive_crowd(scene, file, planner, no_time));
}

// The robot reaches 1 m/s after 0.5 s and 0.3 m. A disc at 6 m is touched at 5.4 m, and half a metre is
// enough to stop.
TEST(CrowdVerdict, ADiscInTheWayCouldBeAvoided) {
  const std::vector<JudgedContact> judged = judged_drive({{{6.0, 0.0}, 0.3, {0.0, 0.0}}}, 1.0);
  ASSERT_EQ(judged.size(), 1U);
  EXPECT_EQ(judged[0].record.person, 1U);
  EXPECT_EQ(judged[0].record.closing.who, WhoHit::robot_closing);
  EXPECT_NEAR(judged[0].record.time, 5.6, 0.021);
  EXPECT_EQ(judged[0].verdict.avoidance, possible::Avoidance::avoidable);
  EXPECT_NEAR(*judged[0].verdict.saveable_until, 5.1, 0.25);
}

// 0.2 m before the rim of a robot that stands, and 1.2 m/s: 0.17 s. In that time 2 m/s^2 move it by 3 cm.
TEST(CrowdVerdict, WhoStandsBeforeARunnerIsLost) {
  const std::vector<JudgedContact> judged = judged_drive({{{0.8, 0.0}, 0.3, {-1.2, 0.0}}}, 0.0);
  ASSERT_GE(judged.size(), 1U);
  EXPECT_EQ(judged[0].record.closing.who, WhoHit::robot_standing);
  EXPECT_EQ(judged[0].verdict.avoidance, possible::Avoidance::not_avoidable);
}

ClosedLoop rule_of(WalkersManner walkers) {
  ClosedLoop rule = *crowd_rules().closed_loop;
  rule.walkers = walkers;
  return rule;
}

/// Where everybody is after 10 s beside a robot that stands at `robot`.
std::vector<Vector2> after_ten_seconds(const Scene& scene, WalkersManner walkers, const Vector2& robot) {
  CrowdPeople people(scene, rule_of(walkers));
  for (int i = 1; i <= 500; ++i) people.move_to(0.02 * i, {robot.x(), robot.y(), 0.0}, {});
  std::vector<Vector2> positions;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) positions.push_back(people.position(i));
  return positions;
}

// Who goes straight on is where the formula says and sees no robot; who reacts walks otherwise beside another
// robot, and the same beside the same. Static discs stay.
TEST(CrowdPeople, WhoReactsSeesTheRobot) {
  const Scene scene = generate_dense_crowd_scene(5001, 0.3);
  const SceneBox box = crowd_rules().closed_loop->box;
  const Vector2 middle{6.0, 0.0};
  const Vector2 far_away{100.0, 0.0};
  const std::vector<Vector2> straight = after_ten_seconds(scene, WalkersManner::straight, middle);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    EXPECT_EQ(straight[i], position_at(scene.obstacles[i], box, 0.02 * 500));
  EXPECT_EQ(straight, after_ten_seconds(scene, WalkersManner::straight, far_away));
  for (const WalkersManner walkers : {WalkersManner::social, WalkersManner::orca}) {
    const std::vector<Vector2> beside = after_ten_seconds(scene, walkers, middle);
    EXPECT_EQ(beside, after_ten_seconds(scene, walkers, middle));
    EXPECT_NE(beside, after_ten_seconds(scene, walkers, far_away));
    EXPECT_EQ(beside[0], scene.obstacles[0].position);
    EXPECT_NE(beside[6], scene.obstacles[6].position);
  }
}

// ORCA keeps them apart: discs of 0.3 m whose centres come no nearer than 0.6 m, less what discs that trust
// each other within 0.1 s overlap.
TEST(CrowdPeople, WhoWalksByOrcaTouchesNobody) {
  const Scene scene = generate_dense_crowd_scene(5001, 0.3);
  CrowdPeople people(scene, rule_of(WalkersManner::orca));
  double nearest = 1e9;
  for (int i = 1; i <= 1000; ++i) {
    people.move_to(0.02 * i, {100.0, 0.0, 0.0}, {});
    for (std::size_t a = 6; a < scene.obstacles.size(); ++a) {
      EXPECT_LE(people.velocity(a).norm(), 1.2 + 1e-9);
      for (std::size_t b = 6; b < a; ++b)
        nearest = std::min(nearest, (people.position(a) - people.position(b)).norm());
    }
  }
  EXPECT_GT(nearest, 0.58);
}

// The walks of who reacts are kept for the verdict, from the start to the end; a recorded drive is the same
// drive.
TEST(CrowdEpisode, KeepsTheWalksOfWhoReacts) {
  SceneFile file = crowd_rules();
  file.closed_loop->timeout = 5.0;
  const Scene scene = generate_dense_crowd_scene(5002, 0.3);
  ConstantPlanner planner({0.5, 0.0});
  EXPECT_TRUE(drive_crowd(scene, file, planner, no_time).walks.empty());
  file.closed_loop->walkers = WalkersManner::orca;
  const CrowdEpisode episode = drive_crowd(scene, file, planner, no_time);
  ASSERT_EQ(episode.walks.size(), 34U);
  EXPECT_EQ(episode.walks[0].positions.front().position, scene.obstacles[6].position);
  EXPECT_NEAR(episode.walks[0].positions.back().time, 5.0, 1e-9);
  const RunRecording recording = record_crowd(scene, file, planner);
  ASSERT_EQ(recording.moments.size(), 50U);
  EXPECT_EQ(recording.shapes.discs.size(), 6U);
  EXPECT_EQ(recording.moments[20].X_MB, episode.states[20].pose);
  EXPECT_TRUE(recording.moments[20].people[0].position.isApprox(*episode.walks[0].at(2.0), 1e-9));
}

// Two of three succeed and the third could not: 2 of 2 where possible. One that is late failed all the same.
TEST(CrowdSummary, TellsSuccessWhereItWasPossible) {
  const CrowdEpisode good{.name = "good", .success = true, .reached = true};
  CrowdEpisode lost{.name = "lost", .reached = true, .collision = true};
  lost.contacts.resize(1);
  lost.judged = {{lost.contacts[0], true, {.avoidance = possible::Avoidance::not_avoidable}}};
  const CrowdSummary s = summarize("x", {good, good, lost});
  EXPECT_EQ(s.rates.successes, 2);
  EXPECT_EQ(s.rates.possible, 2);
  EXPECT_NE(table({s}).find("2 of 2"), std::string::npos);
  EXPECT_NE(failures("x", rated({good, lost})).find("failed: x lost: contact, could not succeed"),
            std::string::npos);
  lost.reached = false;
  EXPECT_EQ(summarize("x", {good, good, lost}).rates.possible, 3);
  lost.reached = true;
  lost.judged[0].verdict.avoidance = possible::Avoidance::undecided;
  EXPECT_EQ(summarize("x", {good, good, lost}).rates.possible, 3);
}

TEST(CrowdSummary, CountsAndMeansOfHandMadeEpisodes) {
  CrowdEpisode good{.name = "good", .success = true, .time = 10.0, .min_clearance = 0.5};
  good.ms = {1.0, 2.0};
  CrowdEpisode touched{.name = "touched", .collision = true, .time = 14.0, .min_clearance = 0.1};
  touched.ms = {3.0};
  CrowdEpisode late{.name = "late", .time = 60.0, .min_clearance = 0.6};
  const CrowdSummary s = summarize("x", {good, touched, late});
  EXPECT_EQ(s.rates.episodes, 3);
  EXPECT_EQ(s.rates.successes, 1);
  EXPECT_EQ(s.contacts, 1);
  EXPECT_EQ(s.contacts_at_speed, 0);
  EXPECT_EQ(s.rates.timeouts, 1);
  EXPECT_NEAR(s.mean_time, 28.0, 1e-12);
  EXPECT_NEAR(s.min_clearance, 0.1, 1e-12);
  EXPECT_NEAR(s.rates.mean_ms, 2.0, 1e-12);
  EXPECT_EQ(s.rates.max_ms, 3.0);
  EXPECT_NE(table({s}).find("1 of 3"), std::string::npos);
}

}  // namespace
}  // namespace bw
