#include "components/tools/program/score_card_json.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/stamps.hpp"

namespace bw {
namespace {

std::vector<CallbackStatistics> statistics(const std::string& callback) {
  CallbackStatistics other{.component = "navigator", .callback = "step"};
  CallbackStatistics cycle{.component = "local_planner", .callback = callback};
  cycle.run.add(Duration::milliseconds(4));
  return {other, cycle};
}

TEST(ScoreCardJson, TellsTheTimesOfThePlanner) {
  RunFacts facts;
  facts.planner_component = "local_planner";
  facts.planner_name = "eteb";
  const nlohmann::json json = to_json(std::nullopt, facts, statistics("control_cycle"));
  EXPECT_EQ(json["planner"]["name"], "eteb");
  EXPECT_EQ(json["planner"]["cycles"], 1);
  EXPECT_NEAR(json["planner"]["median_ms"].get<double>(), 4.0, 0.2);  // within a bucket of the histogram
  EXPECT_TRUE(
      to_json(std::nullopt, {}, statistics("control_cycle"))["planner"].is_null());  // a graph without
}

TEST(ScoreCardJson, APlannerWhoseCycleIsNotFoundIsAnErrorAndNotZero) {
  EXPECT_THROW(planner_cycle(statistics("plan"), "local_planner"), std::runtime_error);
  EXPECT_THROW(planner_cycle({}, "local_planner"), std::runtime_error);
  EXPECT_EQ(planner_cycle({}, ""), nullptr);
  RunFacts facts;
  facts.planner_component = "local_planner";
  EXPECT_THROW(to_json(std::nullopt, facts, statistics("plan")), std::runtime_error);
}

// The drive began at 10 s and the card is of 12 s: looks at 9.8 and 9.9 s were before it.
TEST(ScoreCardJson, ThePathIsThinnedAndBeginsWithTheDrive) {
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

}  // namespace
}  // namespace bw
