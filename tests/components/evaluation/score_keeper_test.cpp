#include "components/evaluation/score_keeper.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/evaluation/collision_index.hpp"
#include "components/evaluation/comfort.hpp"
#include "components/model/footprint_outline.hpp"

namespace bw {
namespace {

constexpr double kRobotRadius = 0.3;

TruthSample sample(double t, double x, double v, std::vector<TruePerson> people = {}) {
  TruthSample s;
  s.time = Time::seconds(t);
  s.X_MB = {x, 0.0, 0.0};
  s.twist = {v, 0.0};
  s.people = std::move(people);
  return s;
}

TruePerson person(std::uint32_t id, double x, double y) { return {id, {x, y}, {0.0, 0.0}, 0.3}; }

ScoreKeeper started(double at = 0.0, const Vector2& goal = {10.0, 0.0}) {
  ScoreKeeper keeper({}, {kRobotRadius, {}});
  keeper.start(Time::seconds(at), goal);
  return keeper;
}

TEST(CollisionIndex, HasTheValuesOfTheBook) {
  // evaluation/theory.md 7.7: sigma 0.6: 0.14 at 1.19 m, 0.54 at 0.666 m, 0.607 at 0.6 m; sigma 0.45: 0.54 at
  // 0.50 m.
  const auto at = [](double d, double sigma) {
    return collision_index({0.0, 0.0}, {person(1, d, 0.0)}, sigma);
  };
  EXPECT_NEAR(at(1.19, 0.6), 0.14, 0.001);
  EXPECT_NEAR(at(0.666, 0.6), 0.54, 0.001);
  EXPECT_NEAR(at(0.6, 0.6), 0.6065, 0.0001);
  EXPECT_NEAR(at(0.4995, 0.45), 0.54, 0.001);
  EXPECT_EQ(collision_index({0.0, 0.0}, {}, 0.6), 0.0);
  EXPECT_EQ(collision_index({0.0, 0.0}, {person(1, 0.0, 0.0), person(2, 9.0, 0.0)}, 0.6), 1.0);
}

TEST(ScoreKeeper, AStraightDriveHasItsLengthTimeAndSpeed) {
  ScoreKeeper keeper = started(100.0, {4.0, 0.0});
  for (int i = 0; i <= 400; ++i) keeper.add(sample(100.0 + 0.02 * i, 0.01 * i, 0.5));
  keeper.finish(Time::seconds(108.0), true, "reached");
  const ScoreCard& card = keeper.card();
  EXPECT_TRUE(card.finished);
  EXPECT_TRUE(card.reached);
  EXPECT_EQ(card.reason, "reached");
  EXPECT_NEAR(card.path_length, 4.0, 1e-9);
  EXPECT_NEAR(card.time_to_goal, 8.0, 1e-9);
  EXPECT_NEAR(card.mean_speed, 0.5, 1e-9);
  EXPECT_NEAR(card.distance_to_goal, 0.0, 1e-9);
  EXPECT_EQ(card.collisions, 0);
  EXPECT_EQ(card.min_distance, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(card.closest.has_value());
  EXPECT_EQ(card.rms_jerk, 0.0);
}

TEST(ScoreKeeper, TheClosestEncounterIsFound) {
  // Passing at 1 m/s a person 1.1 m aside of the line at x = 3: gap 1.1 - 0.6 = 0.5 m at 3 s.
  ScoreKeeper keeper = started();
  for (int i = 0; i <= 300; ++i) {
    keeper.add(sample(0.02 * i, 0.02 * i, 1.0, {person(4, 8.0, 3.0), person(7, 3.0, 1.1)}));
  }
  const ScoreCard& card = keeper.card();
  ASSERT_TRUE(card.closest.has_value());
  EXPECT_NEAR(card.closest->gap, 0.5, 1e-9);
  EXPECT_NEAR(card.closest->time, 3.0, 1e-9);
  EXPECT_EQ(card.closest->person, 7U);
  EXPECT_NEAR(card.closest->X_MB.x, 3.0, 1e-9);
  EXPECT_NEAR(card.min_distance, 0.5, 1e-9);
  EXPECT_NEAR(card.max_collision_index, std::exp(-1.21 / 0.72), 1e-9);
  EXPECT_NEAR(card.max_collision_index_045, std::exp(-1.21 / 0.405), 1e-9);
}

// Somebody of 0.3 m stands 0.53 m beside the line that a rectangle of 0.51 x 0.43 m drives on: its side
// passes at 0.53 - 0.3 - 0.215 =
// 0.015 m, the disc around it would touch. Padded by 0.02 m the rectangle touches, too.
TEST(ScoreKeeper, ARectangleIsJudgedByItsSides) {
  const Footprint rectangle =
      footprint_of("[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]", 0.0).footprint;
  const auto drive = [](const Footprint& footprint) {
    ScoreKeeper keeper({}, footprint);
    keeper.start(Time::seconds(0.0), {2.0, 0.0});
    for (int i = 0; i <= 100; ++i) keeper.add(sample(0.02 * i, 0.02 * i, 1.0, {person(7, 1.0, 0.53)}));
    return keeper.card();
  };
  EXPECT_EQ(drive(rectangle).collisions, 0);
  EXPECT_NEAR(drive(rectangle).closest->gap, 0.015, 1e-12);
  EXPECT_NEAR(drive(rectangle).min_distance, 0.015, 1e-12);
  EXPECT_EQ(drive({rectangle.radius, {}}).collisions, 1);
  EXPECT_EQ(drive(padded(rectangle, 0.02)).collisions, 1);
  EXPECT_NEAR(comfort_of(sample(1.0, 1.0, 1.0, {person(7, 1.0, 0.53)}), rectangle)->closest_person, 0.015,
              1e-12);
  // A truth without heading: the disc around it.
  TruthSample unturned = sample(1.0, 1.0, 1.0, {person(7, 1.0, 1.0)});
  unturned.X_MB.theta = std::nan("");
  EXPECT_NEAR(comfort_of(unturned, rectangle)->closest_person, 0.7 - rectangle.radius, 1e-12);
}

TEST(ScoreKeeper, SharesOfTimeAreWeightedByTime) {
  // 1 s beside a person at 0.65 m (CI 0.556), 3 s at 1.0 m (0.249), 4 s alone; sampled at uneven rates.
  ScoreKeeper keeper = started();
  keeper.add(sample(0.0, 0.0, 0.0));
  for (int i = 1; i <= 50; ++i) keeper.add(sample(0.02 * i, 0.0, 0.0, {person(1, 0.65, 0.0)}));
  for (int i = 1; i <= 30; ++i) keeper.add(sample(1.0 + 0.1 * i, 0.0, 0.0, {person(1, 1.0, 0.0)}));
  for (int i = 1; i <= 8; ++i) keeper.add(sample(4.0 + 0.5 * i, 0.0, 0.0));
  EXPECT_NEAR(keeper.card().share_ci_above_0_54, 1.0 / 8.0, 1e-9);
  EXPECT_NEAR(keeper.card().share_ci_above_0_14, 4.0 / 8.0, 1e-9);
}

TEST(ScoreKeeper, AContactCountsOnceUntilClearlyApart) {
  ScoreKeeper keeper = started();
  double t = 0.0;
  const auto at = [&](double distance, double v) {
    keeper.add(sample(t += 0.02, 0.0, v, {person(1, distance, 0.0)}));
  };
  at(0.70, 0.0);
  at(0.59, 0.0);  // touch, standing
  at(0.61, 0.0);  // trembling at the edge
  at(0.595, 0.0);
  EXPECT_EQ(keeper.card().collisions, 1);
  EXPECT_EQ(keeper.card().collisions_at_speed, 0);
  at(0.63, 0.0);   // apart
  at(0.58, 0.05);  // second touch, creeping
  EXPECT_EQ(keeper.card().collisions, 2);
  EXPECT_EQ(keeper.card().collisions_at_speed, 0);
  at(0.58, 0.3);  // the robot drives on during it
  at(0.58, 0.3);
  EXPECT_EQ(keeper.card().collisions, 2);
  EXPECT_EQ(keeper.card().collisions_at_speed, 1);
  EXPECT_NEAR(keeper.card().min_distance, -0.02, 1e-9);
}

TEST(ScoreKeeper, EachPersonIsAContactOfTheirOwn) {
  ScoreKeeper keeper = started();
  keeper.add(sample(0.0, 0.0, 0.5, {person(1, 0.55, 0.0), person(2, -0.55, 0.0)}));
  EXPECT_EQ(keeper.card().collisions, 2);
  EXPECT_EQ(keeper.card().collisions_at_speed, 2);
  keeper.add(sample(0.1, 0.0, 0.5));                          // both gone
  keeper.add(sample(0.2, 0.0, 0.5, {person(1, 0.55, 0.0)}));  // one back
  EXPECT_EQ(keeper.card().collisions, 3);
}

TEST(ScoreKeeper, ContactsOnlyTheWorldSawCount) {
  ScoreKeeper keeper = started();
  TruthSample s = sample(0.0, 0.0, 0.8);
  s.contacts = 5;  // from before the drive
  s.wall_gap = 0.5;
  keeper.add(s);
  s.time = Time::seconds(0.02);
  s.twist.v = 0.0;  // the wall took the speed
  s.contacts = 6;
  s.wall_gap = 0.001;
  keeper.add(s);
  EXPECT_EQ(keeper.card().collisions, 1);
  EXPECT_EQ(keeper.card().collisions_at_speed, 1);
  EXPECT_NEAR(keeper.card().min_distance, 0.001, 1e-12);
}

TEST(ScoreKeeper, AFalseClaimIsNotReached) {
  ScoreKeeper keeper = started(0.0, {10.0, 0.0});
  keeper.add(sample(1.0, 9.0, 0.0));
  keeper.finish(Time::seconds(1.0), true, "reached");
  EXPECT_FALSE(keeper.card().reached);
  EXPECT_EQ(keeper.card().reason, "the robot claims the goal but is not there");
  EXPECT_NEAR(keeper.card().distance_to_goal, 1.0, 1e-12);
}

// Nobody told where the robot was, or not lately: that is no false claim.
TEST(ScoreKeeper, AClaimWithoutATruthIsNotKnown) {
  for (const bool had_a_truth : {false, true}) {
    ScoreKeeper keeper = started(0.0, {10.0, 0.0});
    if (had_a_truth) keeper.add(sample(1.0, 2.0, 1.0));
    keeper.lose_pose();
    keeper.finish(Time::seconds(10.0), true, "reached");
    EXPECT_FALSE(keeper.card().reached);
    EXPECT_FALSE(keeper.card().is_outcome_known);
    EXPECT_EQ(keeper.card().reason, "the robot claims the goal, and nothing tells where it was then");
    EXPECT_TRUE(std::isnan(keeper.card().distance_to_goal));
  }
  // One that the robot itself gave up is known.
  ScoreKeeper keeper = started();
  keeper.finish(Time::seconds(10.0), false, "blocked");
  EXPECT_TRUE(keeper.card().is_outcome_known);
  EXPECT_EQ(keeper.card().reason, "blocked");
}

TEST(ScoreKeeper, AFailureKeepsItsReason) {
  ScoreKeeper keeper = started();
  keeper.add(sample(1.0, 1.0, 0.0));
  keeper.finish(Time::seconds(20.0), false, "blocked: a crowd");
  EXPECT_FALSE(keeper.card().reached);
  EXPECT_EQ(keeper.card().reason, "blocked: a crowd");
  EXPECT_NEAR(keeper.card().time_to_goal, 20.0, 1e-12);
}

TEST(ScoreKeeper, OnlyTheDriveCountsAndANewOneBeginsAfresh) {
  ScoreKeeper keeper({}, {kRobotRadius, {}});
  keeper.add(sample(0.0, 0.0, 1.0, {person(1, 0.1, 0.0)}));
  EXPECT_EQ(keeper.card().collisions, 0);
  keeper.start(Time::seconds(1.0), {5.0, 0.0});
  keeper.add(sample(1.1, 0.0, 1.0, {person(1, 0.1, 0.0)}));
  keeper.finish(Time::seconds(2.0), false, "x");
  keeper.add(sample(2.1, 3.0, 1.0));
  EXPECT_EQ(keeper.card().path_length, 0.0);
  keeper.start(Time::seconds(3.0), {5.0, 0.0});
  EXPECT_EQ(keeper.card().collisions, 0);
  EXPECT_FALSE(keeper.card().finished);
}

// A reference may know positions alone: the path is theirs, and nothing becomes NaN by what it does not know.
TEST(ScoreKeeper, ATruthWithoutHeadingAndSpeedIsScoredByItsPlaces) {
  ScoreKeeper keeper = started();
  for (int i = 0; i <= 10; ++i) {
    TruthSample position = sample(1.0 + 0.5 * i, 0.25 * i, 0.5);
    position.X_MB.theta = std::nan("");
    position.twist = {std::nan(""), std::nan("")};
    keeper.add(position);
  }
  EXPECT_NEAR(keeper.card().path_length, 2.5, 1e-12);
  EXPECT_NEAR(keeper.card().mean_speed, 2.5 / keeper.card().time_to_goal, 1e-12);
  EXPECT_EQ(keeper.card().rms_jerk, 0.0);
  EXPECT_EQ(keeper.card().collisions_at_speed, 0);
}

TEST(ScoreKeeper, UnsoundSamplesChangeNothing) {
  ScoreKeeper keeper = started();
  keeper.add(sample(1.0, 0.0, 0.5));
  keeper.add(sample(1.0, 5.0, 0.5));
  keeper.add(sample(0.5, 5.0, 0.5));
  keeper.add(sample(2.0, std::nan(""), 0.5));
  keeper.add(sample(2.0, 0.0, 0.5, {person(1, std::nan(""), 0.0)}));
  EXPECT_EQ(keeper.card().path_length, 0.0);
  EXPECT_NEAR(keeper.card().time_to_goal, 1.0, 1e-12);
}

}  // namespace
}  // namespace bw
