// Which frontier comes next, without a map.
#include "components/explore/explorer.hpp"

#include <gtest/gtest.h>

namespace bw::explore {
namespace {

constexpr Pose2 kStart{1.0, 2.0, 0.5};

Frontier frontier(double x, double path_length, double length = 1.0) {
  return {.centre = {x, 0.0}, .length = length, .goal = {x - 0.3, 0.0, 0.0}, .path_length = path_length};
}

FrontierSearch search(std::vector<Frontier> frontiers) {
  FrontierSearch result;
  result.frontiers = std::move(frontiers);
  result.is_placed = true;
  return result;
}

Explorer begun(bool return_to_init = true) {
  Explorer explorer(return_to_init);
  explorer.resume(kStart);
  return explorer;
}

/// Nothing is left only after three looks.
ExploreStep third_look(Explorer& explorer, const FrontierSearch& found) {
  EXPECT_FALSE(explorer.look(found).goal);
  EXPECT_FALSE(explorer.look(found).goal);
  return explorer.look(found);
}

double goal_x(const ExploreStep& step) { return step.goal ? step.goal->x : -1.0; }

TEST(Explorer, IsPausedUntilItIsTold) {
  Explorer explorer;
  EXPECT_EQ(explorer.state(), ExploreState::paused);
  EXPECT_FALSE(explorer.look(search({frontier(5.0, 5.0)})).goal);
}

TEST(Explorer, DrivesToTheNearestFrontierOfEachMap) {
  Explorer explorer = begun();
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({frontier(8.0, 8.0), frontier(5.0, 5.0)}))), 4.7);
  EXPECT_FALSE(explorer.look(search({frontier(5.0, 5.0), frontier(20.0, 5.1)})).goal);
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({frontier(5.0, 5.0), frontier(20.0, 4.9)}))), 19.7);
}

TEST(Explorer, FollowsAFrontierThatMovesOn) {
  Explorer explorer = begun();
  explorer.look(search({frontier(5.0, 5.0)}));
  EXPECT_FALSE(explorer.look(search({frontier(5.4, 5.0)})).goal);              // 0.4 m: the same goal will do
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({frontier(5.8, 5.0)}))), 5.5);  // 0.8 m
  EXPECT_EQ(explorer.goals(), 2U);
}

TEST(Explorer, AVanishedFrontierGivesWayToTheNext) {
  Explorer explorer = begun();
  explorer.look(search({frontier(5.0, 5.0), frontier(9.0, 9.0)}));
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({frontier(9.0, 9.0)}))), 8.7);
}

TEST(Explorer, AFailureIsTriedAgainOnceWhenNothingElseIsLeft) {
  Explorer explorer = begun();
  const FrontierSearch both = search({frontier(5.0, 5.0), frontier(9.0, 9.0)});
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(both)), 4.7);
  explorer.goal_ended(GoalEnd::failed, "blocked");
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(both)), 8.7);
  const FrontierSearch one = search({frontier(5.0, 5.0)});
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(one)), 4.7);  // the second chance
  explorer.goal_ended(GoalEnd::failed, "blocked again");
  const ExploreStep step = third_look(explorer, one);
  EXPECT_EQ(explorer.state(), ExploreState::returning);
  ASSERT_TRUE(step.goal);
  EXPECT_EQ(step.goal->x, kStart.x);
  ASSERT_EQ(explorer.left().size(), 1U);
  EXPECT_EQ(explorer.left()[0].why, "not reached: blocked again");
  explorer.goal_ended(GoalEnd::reached, "");
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  EXPECT_EQ(explorer.failed(), 2U);
}

TEST(Explorer, AFaultOfTheRobotIsNoneOfTheFrontier) {
  Explorer explorer = begun();
  const FrontierSearch one = search({frontier(5.0, 5.0)});
  explorer.look(one);
  explorer.goal_ended(GoalEnd::dropped, "the base stands");
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(one)), 4.7);
  EXPECT_EQ(explorer.failed(), 0U);
}

TEST(Explorer, AFrontierThatStaysThoughTheRobotStandsBeforeItIsLeft) {
  Explorer explorer = begun(false);
  const FrontierSearch one = search({frontier(5.0, 5.0)});
  for (int chance = 0; chance < 2; ++chance) {
    EXPECT_DOUBLE_EQ(goal_x(explorer.look(one)), 4.7);
    explorer.goal_ended(GoalEnd::reached, "");
    EXPECT_FALSE(explorer.look(one).goal);  // the map may be of a moment before
    EXPECT_FALSE(explorer.look(one).goal);
  }
  third_look(explorer, one);
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  EXPECT_EQ(explorer.left().size(), 1U);
}

TEST(Explorer, AFrontierThatItCanComeNearerToByNowIsNotLeft) {
  // 3 m away from where it stood; what was seen from there lets it come to 1 m.
  Explorer explorer = begun(false);
  Frontier far = frontier(9.0, 9.0);
  far.goal.x = 6.0;
  explorer.look(search({far}));
  explorer.goal_ended(GoalEnd::reached, "");
  far.goal.x = 8.0;
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({far}))), 8.0);
}

TEST(Explorer, AMomentWithoutFrontiersIsNoEnd) {
  Explorer explorer = begun();
  explorer.look(search({frontier(5.0, 5.0)}));
  EXPECT_FALSE(explorer.look(search({})).goal);
  EXPECT_TRUE(explorer.is_idle());                                 // and looks again at once
  EXPECT_FALSE(explorer.look(search({frontier(5.0, 5.0)})).goal);  // it drives there still
  EXPECT_FALSE(explorer.look(search({})).goal);
  EXPECT_FALSE(explorer.look(search({})).goal);
  EXPECT_EQ(explorer.state(), ExploreState::exploring);
}

TEST(Explorer, ReturnsAndIsComplete) {
  Explorer explorer = begun();
  const ExploreStep step = third_look(explorer, search({}));
  EXPECT_EQ(goal_x(step), kStart.x);
  EXPECT_EQ(explorer.state(), ExploreState::returning);
  // Something new on the way comes first.
  EXPECT_DOUBLE_EQ(goal_x(explorer.look(search({frontier(5.0, 5.0)}))), 4.7);
  EXPECT_EQ(explorer.state(), ExploreState::exploring);
  EXPECT_EQ(goal_x(third_look(explorer, search({}))), kStart.x);
  explorer.goal_ended(GoalEnd::reached, "");
  EXPECT_EQ(explorer.state(), ExploreState::complete);
  EXPECT_TRUE(explorer.left().empty());
}

TEST(Explorer, CancelsWhenItIsCompleteOrPausedOnTheWay) {
  Explorer explorer = begun(false);
  explorer.look(search({frontier(5.0, 5.0)}));
  const ExploreStep step = third_look(explorer, search({}));
  EXPECT_TRUE(step.cancels);
  EXPECT_EQ(explorer.state(), ExploreState::complete);

  Explorer paused = begun();
  paused.look(search({frontier(5.0, 5.0)}));
  EXPECT_TRUE(paused.pause().cancels);
  EXPECT_FALSE(paused.pause().cancels);
  EXPECT_FALSE(paused.look(search({frontier(5.0, 5.0)})).goal);
  paused.resume({});
  EXPECT_DOUBLE_EQ(goal_x(paused.look(search({frontier(5.0, 5.0)}))), 4.7);
  EXPECT_EQ(goal_x(third_look(paused, search({}))), kStart.x);  // where it began, not where it went on
}

TEST(Explorer, AfterItIsCompleteItBeginsAnew) {
  Explorer explorer = begun(false);
  third_look(explorer, search({}));
  ASSERT_EQ(explorer.state(), ExploreState::complete);
  explorer.resume({});
  EXPECT_EQ(explorer.state(), ExploreState::exploring);
  EXPECT_EQ(explorer.goals(), 0U);
}

}  // namespace
}  // namespace bw::explore
