// The planner's time on a score card is that of its control cycle, or there is none; the robot's path is
// thinned.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "components/program/score_card_json.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

CallbackStatistics called(const std::string& component, const std::string& callback, int milliseconds) {
  CallbackStatistics s{.component = component, .callback = callback};
  s.run.add(Duration::milliseconds(milliseconds));
  return s;
}

TEST(ScoreCard, TheTimeOfThePlannerIsThatOfItsControlCycle) {
  const std::vector<CallbackStatistics> all = {called("navigator", "control_cycle", 50),
                                               called("local_planner", "follow_request", 1),
                                               called("local_planner", "control_cycle", 4)};
  // One sample: every quantile is it, within the 2 % of a bucket.
  EXPECT_NEAR(planner_cycle(all, "local_planner").run.quantile_ms(0.5), 4.0, 0.08);
  const auto json = to_json({}, {.planner_component = "local_planner", .planner_name = "teb"}, all);
  EXPECT_NEAR(json["planner"]["median_ms"].get<double>(), 4.0, 0.08);
  EXPECT_EQ(json["planner"]["name"], "teb");
}

TEST(ScoreCard, ARenamedControlCycleIsAnErrorAndNoFastPlanner) {
  const std::vector<CallbackStatistics> all = {called("local_planner", "follow_request", 1),
                                               called("local_planner", "cycle", 4)};
  EXPECT_THAT([&] { planner_cycle(all, "local_planner"); },
              testing::ThrowsMessage<std::runtime_error>(
                  "the planner's time is that of the callback control_cycle, which local_planner does not "
                  "have; it has: follow_request, cycle"));
  EXPECT_THROW(to_json({}, {.planner_component = "local_planner"}, all), std::runtime_error);
}

TEST(ScoreCard, WithoutAPlannerThereIsNoTime) {
  EXPECT_TRUE(to_json({}, {}, {called("world", "step", 1)})["planner"].is_null());
}

// The drive began at 10 s and the card is of 12 s: looks at 9.8 and 9.9 s were before it.
TEST(ScoreCard, ThePathIsThinnedAndBeginsWithTheDrive) {
  std::vector<PathPoint> path;
  for (int i = 98; i <= 120; ++i) path.push_back({Time::seconds(0.1 * i), {0.1 * i - 10.0, 0.12345, -3.0}});
  bandwagon_msgs::msg::ScoreCard card;
  card.header().stamp(to_stamp(Time::seconds(12.0)));
  card.time_to_goal_s(2.0);
  const nlohmann::json points = path_json(path, card);
  ASSERT_EQ(points.size(), 5U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i][0].get<double>(), 0.5 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(points[i][1].get<double>(), 0.5 * static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(points[0][2], 0.123);
  EXPECT_EQ(points[0][3], -3.0);
}

// A run that stays is not over when its goal is: the card's own outcome counts, not how the run ended.
TEST(ScoreCard, ARunThatStaysTellsTheLastGoalsOutcome) {
  bandwagon_msgs::msg::ScoreCard card;
  card.reached(true);
  card.reason("reached");
  card.path_length_m(21.0);
  card.time_to_goal_s(70.0);
  const RunFacts facts{.end_reason = "interrupted", .stays = true};
  nlohmann::json json = to_json(card, facts, {});
  EXPECT_EQ(json["stayed"], true);
  EXPECT_EQ(json["reason"], "reached");
  EXPECT_THAT(in_words(json),
              testing::StartsWith("Last goal reached; the whole run since the first, 70.0 s over 21.00 m"));
  card.reached(false);
  card.reason("canceled by request");
  EXPECT_THAT(in_words(to_json(card, facts, {})),
              testing::StartsWith("Last goal not reached: canceled by request;"));
  EXPECT_EQ(in_words(to_json({}, facts, {})), "No goal was set: interrupted.\n");
}

TEST(ScoreCard, ARunThatNobodyDroveTellsTheErrorOfThePose) {
  bandwagon_msgs::msg::ScoreCard card;
  card.path_length_m(47.0);
  card.time_to_goal_s(770.0);
  card.localization_poses(6000);
  card.localization_mean_m(0.104);
  card.localization_rms_m(0.117);
  card.localization_max_m(0.26);
  card.localization_rms_rad(0.0196);
  card.distance_to_goal_m(std::nan(""));
  card.closest_person_m(std::numeric_limits<double>::infinity());  // nobody was there
  const RunFacts facts{.end_reason = "the bag is over", .has_goal = false};
  nlohmann::json json = to_json(card, facts, {});
  EXPECT_EQ(json["has_goal"], false);
  EXPECT_EQ(json["localization"]["mean_m"], 0.104);
  EXPECT_TRUE(json["distance_to_goal_m"].is_null());
  EXPECT_EQ(
      in_words(json),
      "Run over: the bag is over; 47.00 m in 770.0 s.\n"
      "Localization off by 0.104 m on average, 0.117 m and 0.0196 rad rms, 0.260 m at most (6000 poses).\n");
  card.localization_rms_rad(std::nan(""));
  EXPECT_THAT(in_words(to_json(card, facts, {})), testing::HasSubstr("0.117 m rms, 0.260 m at most"));
  EXPECT_THAT(in_words(to_json({}, facts, {})), testing::HasSubstr("nobody told the truth"));
}

}  // namespace
}  // namespace bw
