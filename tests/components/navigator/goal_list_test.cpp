#include "components/navigator/goal_list.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

GoalReport report(std::uint64_t id, GoalStatus status) { return {.goal_id = id, .status = status}; }

Time at(double seconds) { return Time::seconds(100.0 + seconds); }

GoalListOptions three() {
  return {.goals = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
          .delay = 2.0,
          .pause = 0.5,
          .loops = 0,
          .stop_on_failure = true};
}

// Delay 2 s before the first, pause 0.5 s after each; 2, 1 and 0 goals follow.
TEST(GoalList, GoalsComeInTurnAfterDelayAndPause) {
  GoalList goals(three());
  goals.activate(at(0.0));
  EXPECT_FALSE(goals.due(at(1.99)));
  double now = 2.0;
  for (std::uint64_t id = 1; id <= 3; ++id) {
    const auto X_MG = goals.due(at(now));
    ASSERT_TRUE(X_MG);
    EXPECT_EQ(X_MG->x, static_cast<double>(id));
    goals.taken(10 * id);
    EXPECT_FALSE(goals.due(at(now + 100.0))) << "one is in hand";
    EXPECT_EQ(goals.see(report(10 * id, GoalStatus::executing), at(now)), 3 - id);
    now += 100.0;
    EXPECT_EQ(goals.see(report(10 * id, GoalStatus::succeeded), at(now)), 3 - id);
    EXPECT_FALSE(goals.due(at(now + 0.49)));
    now += 0.5;
  }
  EXPECT_FALSE(goals.due(at(now + 1e4)));
}

TEST(GoalList, LoopsDriveTheWholeListAgain) {
  GoalListOptions options = three();
  options.loops = 2;
  GoalList goals(options);
  goals.activate(at(0.0));
  for (std::uint64_t id = 0; id < 9; ++id) {
    const auto X_MG = goals.due(at(10.0 * static_cast<double>(id + 1)));
    ASSERT_TRUE(X_MG);
    EXPECT_EQ(X_MG->x, static_cast<double>(id % 3 + 1));
    goals.taken(id + 1);
    EXPECT_EQ(goals.see(report(id + 1, GoalStatus::succeeded), at(10.0 * static_cast<double>(id + 1))),
              8 - id);
  }
  EXPECT_FALSE(goals.due(at(1e4)));
}

TEST(GoalList, AFailureIsTheLastOrNot) {
  for (const bool stop : {true, false}) {
    GoalListOptions options = three();
    options.stop_on_failure = stop;
    GoalList goals(options);
    goals.activate(at(0.0));
    ASSERT_TRUE(goals.due(at(2.0)));
    goals.taken(1);
    EXPECT_EQ(goals.see(report(1, GoalStatus::aborted), at(5.0)), stop ? 0U : 2U);
    EXPECT_EQ(goals.due(at(5.5)).has_value(), !stop);
  }
}

TEST(GoalList, WhoeverElseSaysWhereToGoEndsTheList) {
  GoalList goals(three());
  goals.activate(at(0.0));
  goals.taken(1);
  EXPECT_EQ(goals.see(report(7, GoalStatus::accepted), at(3.0)), 0U) << "not of the list";
  goals.give_up("a newer goal");
  EXPECT_EQ(goals.see(report(1, GoalStatus::aborted), at(3.0)), 0U);
  EXPECT_FALSE(goals.due(at(1e4)));
}

// Of three goals the second is first: 2, 3, and in the second round 1, 2, 3.
TEST(GoalList, TheFirstRoundMayBeginLater) {
  GoalListOptions options = three();
  options.first = 1;
  options.loops = 1;
  GoalList goals(options);
  goals.activate(at(0.0));
  std::vector<std::size_t> driven;
  for (std::uint64_t id = 1; goals.end() == GoalList::End::none; ++id) {
    const Time now = at(10.0 * static_cast<double>(id));
    const auto X_MG = goals.due(now);
    ASSERT_TRUE(X_MG);
    goals.taken(id);
    driven.push_back(goals.current());
    EXPECT_EQ(X_MG->x, static_cast<double>(goals.current() + 1));
    EXPECT_EQ(goals.see(report(id, GoalStatus::succeeded), now), 5 - id);
  }
  EXPECT_EQ(driven, (std::vector<std::size_t>{1, 2, 0, 1, 2}));
  EXPECT_EQ(goals.end(), GoalList::End::completed);
  EXPECT_TRUE(goals.missed().empty());
}

// The second of three is missed: the list ends there, or after the third; either way it tells which one and
// why.
TEST(GoalList, TellsWhatWasMissedAndHowItEnded) {
  for (const bool stop : {true, false}) {
    GoalListOptions options = three();
    options.stop_on_failure = stop;
    GoalList goals(options);
    goals.activate(at(0.0));
    double now = 2.0;
    std::uint64_t id = 1;
    while (goals.end() == GoalList::End::none) {
      ASSERT_TRUE(goals.due(at(now)));
      goals.taken(id);
      EXPECT_EQ(goals.end(), GoalList::End::none);
      goals.see({.goal_id = id,
                 .status = id == 2 ? GoalStatus::aborted : GoalStatus::succeeded,
                 .reason = "in a wall"},
                at(now));
      now += 1.0;
      ++id;
    }
    EXPECT_EQ(id, stop ? 3U : 4U);
    EXPECT_EQ(goals.end(), stop ? GoalList::End::stopped : GoalList::End::completed);
    ASSERT_EQ(goals.missed().size(), 1U);
    EXPECT_EQ(goals.end_reason(), stop ? "goal 1 of the list was missed: in a wall" : "");
    EXPECT_EQ(goals.missed()[0].index, 1U);
    EXPECT_EQ(goals.missed()[0].report.reason, "in a wall");
  }
}

TEST(GoalList, AListGivenUpEndsWithItsGoalInHandAndInAPauseAtOnce) {
  GoalList goals(three());
  goals.activate(at(0.0));
  goals.taken(1);
  goals.give_up("a newer goal");
  EXPECT_EQ(goals.end(), GoalList::End::none);
  goals.see(report(1, GoalStatus::canceled), at(3.0));
  EXPECT_EQ(goals.end(), GoalList::End::given_up);
  EXPECT_TRUE(goals.missed().empty()) << "it could have been reached";

  GoalList pausing(three());
  pausing.activate(at(0.0));
  pausing.taken(1);
  pausing.see(report(1, GoalStatus::succeeded), at(3.0));
  pausing.give_up("canceled");
  EXPECT_EQ(pausing.end(), GoalList::End::given_up);
  EXPECT_EQ(pausing.end_reason(), "canceled");
}

TEST(GoalList, WithoutGoalsNothingIsDue) {
  GoalList goals(GoalListOptions{});
  goals.activate(at(0.0));
  EXPECT_FALSE(goals.due(at(1e4)));
}

}  // namespace
}  // namespace bw
