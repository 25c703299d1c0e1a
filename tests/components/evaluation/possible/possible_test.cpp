// What was possible: scenes with known answers, and that the two searches never contradict each other.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

#include "components/evaluation/possible/contact_verdict.hpp"
#include "components/model/random.hpp"

namespace bw::possible {
namespace {

constexpr double kReach = 0.6;  // two discs of 0.3 m

/// From `from` with `velocity`, for 20 s.
Walk walker(const Vector2& from, const Vector2& velocity) {
  return {0.3, {{0.0, from}, {20.0, from + 20.0 * velocity}}};
}

/// Straight ahead along x with `speed` from the origin, every 0.1 s.
std::vector<MotionState> straight(double speed, double seconds) {
  std::vector<MotionState> drive;
  for (int k = 0; k <= std::lround(seconds / 0.1); ++k)
    drive.push_back({0.1 * k, {0.1 * k * speed, 0.0, 0.0}, {speed, 0.0}});
  return drive;
}

/// Walls along x from -20 to 20 m.
void add_wall(SearchScene& scene, double y) { scene.shapes.segments.push_back({{-20.0, y}, {20.0, y}}); }

ContactVerdict judge(const SearchScene& scene, const std::vector<MotionState>& drive, double contact,
                     double optimistic_factor = 2.0) {
  VerdictOptions options;
  options.optimistic_factor = optimistic_factor;
  return judge_contact(scene, drive, 0.0, contact, 20.0, Limits{}, options);
}

// Twelve people on a circle of 1.6 m come to its middle at 0.5 m/s, where the robot stands. Neighbours are
// 2 1.6 sin(15 deg) = 0.83 m apart and 1.2 m would let the robot through: it is touched when they are at 0.6
// m, after 2 s.
TEST(Possible, NobodyLeavesARingThatCloses) {
  SearchScene scene;
  for (int k = 0; k < 12; ++k) {
    const Vector2 outward = direction(2.0 * std::numbers::pi * k / 12.0);
    scene.walks.push_back({0.3, {{0.0, 1.6 * outward}, {3.2, Vector2(0.0, 0.0)}, {20.0, Vector2(0.0, 0.0)}}});
  }
  const ContactVerdict verdict = judge(scene, straight(0.0, 2.0), 2.0);
  EXPECT_EQ(verdict.avoidance, Avoidance::not_avoidable);
  EXPECT_EQ(verdict.lost_since, 0.0);
  // Six of them from 3 m on are 3 m apart at first: wide enough for who leaves at once.
  SearchScene open;
  for (int k = 0; k < 6; ++k) {
    const Vector2 outward = direction(2.0 * std::numbers::pi * k / 6.0);
    open.walks.push_back({0.3, {{0.0, 3.0 * outward}, {6.0, Vector2(0.0, 0.0)}, {20.0, Vector2(0.0, 0.0)}}});
  }
  EXPECT_EQ(judge(open, straight(0.0, 4.8), 4.8).avoidance, Avoidance::avoidable);
}

// A corridor of 1 m, a runner of 2.5 m/s 3 m behind a robot that drives as fast as it can, 1 m/s: the gap of
// 2.4 m is gone after 1.6 s, and nothing is faster. Without one of the walls there is room beside the runner.
TEST(Possible, ARunnerInACorridorIsFasterUnlessASideIsFree) {
  SearchScene scene;
  scene.walks.push_back(walker({-3.0, 0.0}, {2.5, 0.0}));
  add_wall(scene, -0.5);
  SearchScene closed = scene;
  add_wall(closed, 0.5);
  EXPECT_EQ(judge(closed, straight(1.0, 1.6), 1.6).avoidance, Avoidance::not_avoidable);
  const ContactVerdict open = judge(scene, straight(1.0, 1.6), 1.6);
  EXPECT_EQ(open.avoidance, Avoidance::avoidable);
  // 0.6 m to the side and 1.5 rad/s^2, 1 rad/s take more than 1 s: y(t) <= integral of sin(0.75 t^2) = 0.25
  // at 1 s.
  EXPECT_LE(*open.saveable_until, 0.6);
  ASSERT_TRUE(open.lost_since);
  EXPECT_GT(*open.lost_since, *open.saveable_until);
}

// Somebody comes at 1 m/s from 8 m ahead, and nothing else is there: a step to the side, in time.
TEST(Possible, WhoComesAheadCanBeSidestepped) {
  SearchScene scene;
  scene.walks.push_back(walker({8.0, 0.0}, {-1.0, 0.0}));
  const double contact = (8.0 - kReach) / 2.0;
  const ContactVerdict verdict = judge(scene, straight(1.0, contact), contact);
  EXPECT_EQ(verdict.avoidance, Avoidance::avoidable);
  // By then 0.6 m to the side are needed, 0.3 s before nothing moves so far.
  EXPECT_GT(*verdict.saveable_until, contact - 2.5);
  EXPECT_LT(*verdict.saveable_until, contact - 0.3);
}

// A robot in a corridor of 0.8 m, 0.1 m to either side, drives 1 m/s at somebody who stands at 3 m: contact
// at 2.4 m. With 1 m/s^2 it stops in 0.5 m, so it must brake at 1.9 m, after 1.9 s. States are 0.1 s apart,
// and the margins of both searches less than 3 cm.
TEST(Possible, MustHaveBrakedByTheClosedForm) {
  SearchScene scene;
  scene.walks.push_back(walker({3.0, 0.0}, {0.0, 0.0}));
  add_wall(scene, -0.4);
  add_wall(scene, 0.4);
  const ContactVerdict verdict = judge(scene, straight(1.0, 2.4), 2.4, 1.0);
  EXPECT_EQ(verdict.avoidance, Avoidance::avoidable);
  ASSERT_TRUE(verdict.saveable_until && verdict.lost_since);
  EXPECT_NEAR(*verdict.saveable_until, 1.9, 0.101);
  EXPECT_LE(*verdict.saveable_until, 1.9 + 1e-9);
  EXPECT_NEAR(*verdict.lost_since, 2.0, 0.101);
  // With twice the deceleration 0.25 m would do: lost after 2.15 s.
  EXPECT_NEAR(*judge(scene, straight(1.0, 2.4), 2.4, 2.0).lost_since, 2.2, 0.101);
}

// Who appears 0.1 m ahead of the rim of a robot at 1 m/s, 0.3 s before it is over: nothing could be done from
// then on.
TEST(Possible, WhoAppearsBeforeTheRimCannotBeAvoided) {
  SearchScene scene;
  scene.walks.push_back({0.3, {{1.5, {2.2, 0.0}}, {20.0, {2.2, 0.0}}}});
  const std::vector<MotionState> drive = straight(1.0, 1.6);
  const ContactVerdict verdict = judge_contact(scene, drive, 1.5, 1.6, 20.0, Limits{});
  EXPECT_EQ(verdict.avoidance, Avoidance::not_avoidable);
  // Who knew it from the beginning had time.
  EXPECT_EQ(judge_contact(scene, drive, 0.0, 1.6, 20.0, Limits{}).avoidance, Avoidance::avoidable);
}

struct RandomScene {
  SearchScene scene;
  MotionState start;
};

/// Three to six people within 3 m who walk up to 1.5 m/s, a wall in every second scene, any speeds within the
/// limits.
RandomScene random_scene(std::uint64_t seed) {
  Random random(seed);
  RandomScene drawn;
  const int count = 3 + static_cast<int>(seed % 4);
  while (static_cast<int>(drawn.scene.walks.size()) < count) {
    const Vector2 from = random.uniform(0.7, 3.0) * direction(random.uniform(-3.1, 3.1));
    drawn.scene.walks.push_back(walker(
        from,
        random.uniform(0.0, 1.5) * direction(std::atan2(-from.y(), -from.x()) + random.uniform(-0.6, 0.6))));
  }
  if (seed % 2 == 0) add_wall(drawn.scene, random.uniform(0.45, 1.0));
  drawn.start = {
      0.0, {0.0, 0.0, random.uniform(-3.1, 3.1)}, {random.uniform(-0.2, 1.0), random.uniform(-1.0, 1.0)}};
  return drawn;
}

/// Extreme accelerations, changed at random every 0.3 s; whether such a motion is clear of everybody at every
/// 0.1 s.
bool random_motion_is_clear(const RandomScene& drawn, const MotionBounds& bounds, double until,
                            Random& random) {
  Pose2 pose = drawn.start.pose;
  Twist2 twist = drawn.start.twist;
  double acceleration = 0.0;
  double alpha = 0.0;
  const int steps = static_cast<int>(std::lround(until / 0.01));
  for (int k = 0; k < steps; ++k) {
    if (k % 30 == 0) {
      acceleration = bounds.acceleration * (random.uniform() < 0.5 ? -1.0 : 1.0);
      alpha = bounds.alpha * (random.uniform() < 0.5 ? -1.0 : 1.0);
    }
    twist.v = std::clamp(twist.v + 0.01 * acceleration, -bounds.v_back_max, bounds.v_max);
    twist.omega = std::clamp(twist.omega + 0.01 * alpha, -bounds.omega_max, bounds.omega_max);
    pose = {pose.x + 0.01 * twist.v * std::cos(pose.theta + 0.005 * twist.omega),
            pose.y + 0.01 * twist.v * std::sin(pose.theta + 0.005 * twist.omega),
            pose.theta + 0.01 * twist.omega};
    if ((k + 1) % 10 != 0) continue;
    for (const Walk& walk : drawn.scene.walks)
      if ((*walk.at(0.01 * (k + 1)) - pose.position()).norm() < kReach) return false;
    for (const Segment& wall : drawn.scene.shapes.segments)
      if (std::abs(wall.a.y() - pose.y) < 0.3) return false;
  }
  return true;
}

// What is found, or drawn by chance, cannot have been proven away, not even when the hopeful search has no
// more than the robot's own limits. BANDWAGON_POSSIBLE_SCENES: how many scenes.
TEST(Possible, WhatExistsIsNeverProvenAway) {
  const char* asked = std::getenv("BANDWAGON_POSSIBLE_SCENES");
  const int scenes = asked != nullptr ? std::atoi(asked) : 24;
  const MotionBounds bounds = bounds_of(Limits{}, 1.0);
  int found = 0;
  int drawn_clear = 0;
  int proven_away = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    const RandomScene drawn = random_scene(static_cast<std::uint64_t>(seed));
    FinderOptions finder;
    finder.most_states = 500;
    const bool is_found = find_motion(drawn.scene, drawn.start, bounds, 4.0, finder).has_value();
    Random random(static_cast<std::uint64_t>(seed));
    bool is_drawn = false;
    for (int k = 0; k < 300 && !is_drawn; ++k) is_drawn = random_motion_is_clear(drawn, bounds, 4.0, random);
    OptimisticSearchOptions coarse;
    coarse.cell = 0.02;
    coarse.escape_area = 12.0;
    const bool is_none =
        search_optimistically(drawn.scene, drawn.start, bounds, 4.0, coarse) == SearchOutcome::none;
    EXPECT_FALSE(is_found && is_none) << "seed " << seed;
    EXPECT_FALSE(is_drawn && is_none) << "seed " << seed;
    found += is_found ? 1 : 0;
    drawn_clear += is_drawn ? 1 : 0;
    proven_away += is_none ? 1 : 0;
  }
  std::printf("%d scenes: a motion found in %d, drawn by chance in %d, proven away in %d\n", scenes, found,
              drawn_clear, proven_away);
  EXPECT_GT(found, scenes / 10);
  EXPECT_GT(drawn_clear, scenes / 20);
  EXPECT_GT(proven_away, scenes / 10);
}

// A motion that is found keeps the limits, and stays clear of everybody by the rule of contact.
TEST(Possible, WhatIsFoundKeepsLimitsAndDistance) {
  const Limits limits;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RandomScene drawn = random_scene(seed);
    const auto motion = find_motion(drawn.scene, drawn.start, bounds_of(limits, 1.0), 4.0);
    if (!motion) continue;
    ++found;
    EXPECT_NEAR(motion->back().time, 4.0, 0.051) << "seed " << seed;
    for (std::size_t k = 1; k < motion->size(); ++k) {
      const MotionState& a = (*motion)[k - 1];
      const MotionState& b = (*motion)[k];
      const double dt = b.time - a.time;
      EXPECT_LE(std::abs(b.twist.v - a.twist.v), limits.acc_max * dt + 1e-9) << "seed " << seed;
      EXPECT_LE(std::abs(b.twist.omega - a.twist.omega), limits.alpha_max * dt + 1e-9) << "seed " << seed;
      EXPECT_LE(b.twist.v, limits.v_max + 1e-9);
      EXPECT_GE(b.twist.v, -limits.v_back_max - 1e-9);
      EXPECT_NEAR((b.pose.position() - a.pose.position()).norm(), std::abs(a.twist.v + b.twist.v) / 2.0 * dt,
                  2e-3);
      for (const Walk& walk : drawn.scene.walks)
        EXPECT_GE((*walk.at(b.time) - b.pose.position()).norm(), kReach)
            << "seed " << seed << " at " << b.time;
    }
  }
  EXPECT_GE(found, 3);
}

// The same scene rotated and moved has the same verdict.
TEST(Possible, TurnedAndMovedScenesHaveTheSameVerdict) {
  const Pose2 X{12.3, -4.5, 2.1};
  SearchScene scene;
  scene.walks.push_back(walker({3.0, 0.0}, {0.0, 0.0}));
  add_wall(scene, -0.4);
  add_wall(scene, 0.4);
  SearchScene rotated = scene;
  for (Walk& walk : rotated.walks)
    for (TimedPosition& timed : walk.positions) timed.position = X * timed.position;
  for (Segment& wall : rotated.shapes.segments) wall = {X * wall.a, X * wall.b};
  std::vector<MotionState> drive = straight(1.0, 2.4);
  for (MotionState& state : drive) state.pose = X * state.pose;
  const ContactVerdict verdict = judge(rotated, drive, 2.4, 1.0);
  EXPECT_EQ(verdict.avoidance, Avoidance::avoidable);
  EXPECT_NEAR(verdict.saveable_until.value_or(0.0), 1.8, 0.101);
  EXPECT_NEAR(verdict.lost_since.value_or(0.0), 2.0, 0.101);
}

}  // namespace
}  // namespace bw::possible
