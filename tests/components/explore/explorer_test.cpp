#include "components/explore/explorer.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace bw::explore {
namespace {

Frontier at(double x, double length, double path_length) {
  return {{x, 0.0}, length, {x - 0.3, 0.0, 0.0}, path_length};
}
FrontierSearch with(std::vector<Frontier> frontiers) { return {std::move(frontiers), {}, true}; }

constexpr Pose2 kStart{1.0, 2.0, 3.0};

Explorer begun() {
  Explorer explorer{ExplorerOptions{}};
  explorer.resume(kStart);
  return explorer;
}

TEST(Explorer, StartsPaused) {
  Explorer explorer{ExplorerOptions{}};
  EXPECT_EQ(explorer.state(), ExploreState::paused);
  EXPECT_FALSE(explorer.look(with({at(5.0, 1.0, 5.0)})).goal);
}

// Costs are 5 - 1, 9 - 6 and 6 - 1: a frontier as long as 6 m is worth the way.
TEST(Explorer, WeighsTheWayAgainstWhatThereIsToSee) {
  Explorer explorer = begun();
  const ExploreStep step = explorer.look(with({at(5.0, 1.0, 5.0), at(9.0, 6.0, 9.0), at(6.5, 1.0, 6.0)}));
  ASSERT_TRUE(step.goal);
  EXPECT_EQ(step.goal->x, 8.7);
}

TEST(Explorer, DrivesOnWhileTheFrontierIsThereAndElsewhereWhenItVanished) {
  Explorer explorer = begun();
  EXPECT_TRUE(explorer.look(with({at(5.0, 1.0, 5.0), at(9.0, 1.0, 9.0)})).goal);
  // Moved by 0.4 m with the map it is the same; a better one does not turn the robot round.
  EXPECT_FALSE(explorer.look(with({at(5.4, 1.0, 4.0), at(1.0, 9.0, 1.0), at(9.0, 1.0, 9.0)})).goal);
  const ExploreStep step = explorer.look(with({at(9.0, 1.0, 8.0)}));
  ASSERT_TRUE(step.goal);
  EXPECT_EQ(step.goal->x, 8.7);
  EXPECT_FALSE(step.cancels) << "the new goal takes the place of the old one";
}

TEST(Explorer, WhatWasNotReachedGetsASecondChanceAndNoThird) {
  Explorer explorer = begun();
  const FrontierSearch both = with({at(5.0, 1.0, 5.0), at(9.0, 1.0, 9.0)});
  const auto goal = [&] { return explorer.look(both).goal.value_or(Pose2{-1.0, 0.0, 0.0}).x; };
  EXPECT_EQ(goal(), 4.7);
  explorer.goal_ended(false);
  EXPECT_EQ(goal(), 8.7);
  explorer.goal_ended(false);
  EXPECT_EQ(goal(), 4.7) << "nothing else is left: once more";
  explorer.goal_ended(false);
  EXPECT_EQ(goal(), 8.7);
  explorer.goal_ended(false);
  EXPECT_EQ(goal(), kStart.x) << "back to where it began";
  EXPECT_EQ(explorer.state(), ExploreState::returning);
  EXPECT_EQ(explorer.given_up(), 2U);
  explorer.goal_ended(true);
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  EXPECT_EQ(explorer.failed(), 4U);
}

// The robot stood before it, three looks later it is still there: nothing is to be seen from there.
TEST(Explorer, AFrontierThatStaysIsGivenUp) {
  Explorer explorer = begun();
  const FrontierSearch one = with({at(5.0, 1.0, 5.0)});
  EXPECT_TRUE(explorer.look(one).goal);
  explorer.goal_ended(true);
  EXPECT_FALSE(explorer.look(one).goal);
  EXPECT_FALSE(explorer.look(one).goal);
  EXPECT_TRUE(explorer.look(one).goal);
  EXPECT_EQ(explorer.state(), ExploreState::returning);
  EXPECT_EQ(explorer.given_up(), 1U);
}

TEST(Explorer, PausedItStandsAndGoesOnWhereItWas) {
  Explorer explorer = begun();
  const FrontierSearch one = with({at(5.0, 1.0, 5.0)});
  explorer.look(one);
  EXPECT_TRUE(explorer.pause().cancels);
  EXPECT_FALSE(explorer.look(one).goal);
  explorer.resume({7.0, 7.0, 0.0});
  EXPECT_TRUE(explorer.look(one).goal);
  explorer.goal_ended(true);
  const ExploreStep back = explorer.look(with({}));
  ASSERT_TRUE(back.goal);
  EXPECT_EQ(back.goal->x, kStart.x) << "where it began, not where it went on";
}

TEST(Explorer, CompleteItBeginsAnew) {
  Explorer explorer = begun();
  explorer.look(with({}));
  explorer.goal_ended(true);
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  EXPECT_FALSE(explorer.pause().cancels);
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  explorer.resume(kStart);
  EXPECT_EQ(explorer.state(), ExploreState::exploring);
  EXPECT_EQ(explorer.goals(), 0U);
}

}  // namespace
}  // namespace bw::explore
