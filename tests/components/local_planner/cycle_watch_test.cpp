#include "components/local_planner/adaptor/cycle_watch.hpp"

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
  const CycleWatch watch(0.1, 0.05, 100, false);
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
