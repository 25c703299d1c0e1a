#include "components/local_planner/adaptor/cycle_watch.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace bw {
namespace {

struct Reported final : DiagnosticReporter {
  void report(Level new_level, std::string new_message) override {
    level = new_level;
    message = std::move(new_message);
  }
  void set_value(const std::string& key, std::string value) override { values[key] = std::move(value); }

  Level level = Level::error;
  std::string message;
  std::map<std::string, std::string> values;
};

PlanningResult cycle(PlanningStatus status, int iterations, std::string reason = "") {
  PlanningResult result;
  result.status = status;
  result.iterations = iterations;
  result.reason = std::move(reason);
  result.candidates.resize(2);
  return result;
}

TEST(CycleWatch, InLockstepTheBudgetIsThatOfTheParameters) {
  CycleWatch watch(0.1, 1e-9, 100, false);
  for (int i = 0; i < 10; ++i) {
    watch.begin();
    watch.end(cycle(PlanningStatus::ok, 20));
    EXPECT_EQ(watch.budget().max_iterations, 100);
  }
  Reported reported;
  watch.report(cycle(PlanningStatus::ok, 20), false, reported);
  const std::map<std::string, std::string> expected = {
      {"candidates", "2"}, {"iterations", "20"}, {"iteration_budget", "100"}};
  EXPECT_EQ(reported.values, expected);
}

// Nothing is told of obstacles left out until there were any; from then on the figure is up to date.
TEST(CycleWatch, TellsWhenObstaclesAreLeftOut) {
  CycleWatch watch(0.1, 0.04, 100, false);
  PlanningResult result = cycle(PlanningStatus::ok, 20);
  Reported reported;
  watch.report(result, false, reported);
  EXPECT_FALSE(reported.values.contains("obstacles_left_out"));
  result.obstacles_left_out = 3;
  watch.report(result, false, reported);
  EXPECT_EQ(reported.values["obstacles_left_out"], "3");
  result.obstacles_left_out = 0;
  watch.report(result, false, reported);
  EXPECT_EQ(reported.values["obstacles_left_out"], "0");
}

// What is driven is told, not what is cheapest; a planner without candidates has neither class nor cost.
TEST(CycleWatch, TheMessageTellsWhatIsDriven) {
  namespace value = bandwagon_msgs::msg::PlannerCycle_Constants;
  CycleWatch watch(0.1, 0.04, 100, false);
  PlanningResult result = cycle(PlanningStatus::ok, 20);
  result.candidates[0] = {"L", 3.0, false, {}};
  result.candidates[1] = {"R", 4.0, true, {}};
  result.class_switched = true;
  const auto told = watch.message(result, false);
  EXPECT_EQ(told.status(), value::OK);
  EXPECT_EQ(told.chosen_label(), "R");
  EXPECT_EQ(told.chosen_cost(), 4.0);
  EXPECT_TRUE(told.class_switched());
  EXPECT_EQ(told.number_of_candidates(), 2U);
  EXPECT_EQ(told.iterations(), 20U);
  EXPECT_EQ(told.iteration_budget(), 100U);
  EXPECT_TRUE(std::isnan(told.duration_ms()));
  EXPECT_EQ(told.budget_ms(), 40.0);
  EXPECT_EQ(told.period_ms(), 100.0);

  PlanningResult nothing = cycle(PlanningStatus::infeasible, 0, "boxed in");
  nothing.candidates.clear();
  const auto stopped = watch.message(nothing, false);
  EXPECT_EQ(stopped.status(), value::INFEASIBLE);
  EXPECT_EQ(stopped.reason(), "boxed in");
  EXPECT_EQ(stopped.chosen_label(), "");
  EXPECT_TRUE(std::isnan(stopped.chosen_cost()));
  const auto idle = watch.message(nothing, true);
  EXPECT_EQ(idle.status(), value::IDLE);
  EXPECT_EQ(idle.reason(), "");
  EXPECT_EQ(watch.message(cycle(PlanningStatus::no_plan, 0), false).status(), value::NO_PLAN);
  EXPECT_EQ(watch.message(cycle(PlanningStatus::bad_input, 0), false).status(), value::BAD_INPUT);
}

// A period of a picosecond is overrun by any cycle, one of a thousand years by none; a nanosecond has room
// for the smallest budget only, an hour for all.
TEST(CycleWatch, InRealTimeCyclesAreMeasured) {
  const auto after_three = [](double period, double allowed) {
    CycleWatch watch(period, allowed, 100, true);
    for (int i = 0; i < 3; ++i) {
      watch.begin();
      watch.end(cycle(PlanningStatus::ok, 20));
    }
    Reported reported;
    watch.report(cycle(PlanningStatus::ok, 20), false, reported);
    return reported.values;
  };
  auto slow = after_three(1e-12, 1e-9);
  EXPECT_EQ(slow["overruns"], "3");
  EXPECT_EQ(slow["iteration_budget"], "10");
  EXPECT_TRUE(slow.contains("cycle_p95_ms"));
  EXPECT_TRUE(slow.contains("cycle_max_ms"));
  auto quick = after_three(3e10, 3600.0);
  EXPECT_EQ(quick["overruns"], "0");
  EXPECT_EQ(quick["iteration_budget"], "100");
}

TEST(CycleWatch, TellsTheStateInWords) {
  using Level = DiagnosticReporter::Level;
  CycleWatch watch(0.1, 0.05, 100, false);
  Reported reported;
  watch.report(cycle(PlanningStatus::ok, 0), false, reported);
  EXPECT_EQ(reported.message, "following");
  EXPECT_EQ(reported.level, Level::ok);
  watch.report(cycle(PlanningStatus::ok, 0, "evading"), false, reported);
  EXPECT_EQ(reported.message, "evading");
  EXPECT_EQ(reported.level, Level::ok);
  watch.report(cycle(PlanningStatus::infeasible, 0, "boxed in"), false, reported);
  EXPECT_EQ(reported.message, "boxed in");
  EXPECT_EQ(reported.level, Level::warn);
  watch.report(cycle(PlanningStatus::no_plan, 0, "no request"), true, reported);
  EXPECT_EQ(reported.message, "idle");
  EXPECT_EQ(reported.level, Level::ok);
}

}  // namespace
}  // namespace bw
