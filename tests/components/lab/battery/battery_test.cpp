// The battery's table: what it reads of the table of hazards, of test programs, and of what they print.
#include "components/lab/battery/battery.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

namespace bw {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kReadme = R"(# tests

| row | hazard | barrier | figure | test | what remains |
|---|---|---|---|---|---|
| 1 | the planner is killed | age | asked: soon | `CommandLoss.Brakes`, `tests/faults/kill_planner.cpp`; `Launch.GoesOn` | open: 300 |
| 2 | a reader stands still | open | asked: nothing | open | all |

| other | table |
)";

TEST(Battery, ReadsRowsAndTheirTests) {
  const auto rows = rows_of(kReadme);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].number, 1);
  EXPECT_EQ(rows[0].hazard, "the planner is killed");
  EXPECT_THAT(rows[0].tests, ElementsAre("CommandLoss.Brakes", "Launch.GoesOn"));
  EXPECT_THAT(rows[1].tests, IsEmpty());
  EXPECT_EQ(rows_of(kReadme, 1).size(), 1U);
  EXPECT_THROW(rows_of("# nothing"), std::runtime_error);
}

TEST(Battery, ReadsTheTableThatThereIs) {
  std::ifstream in(BANDWAGON_SOURCE_DIR "/tests/README.md");
  const auto rows = rows_of({std::istreambuf_iterator<char>(in), {}});
  ASSERT_EQ(rows.size(), 36U);
  EXPECT_EQ(rows[5].hazard, "laser silent");
  EXPECT_THAT(rows[5].tests, testing::Contains("LaserFaults.ASilentLaserBrakesTheRobotWithin300Ms"));
}

TEST(Battery, FindsTheProgramsOfARow) {
  const auto listed = tests_listed(
      "Running main() from somewhere\nCommandLoss.\n  Brakes\n  Other\nKinds/LostSweeps.\n  AreASilentLaser/nan  # "
      "GetParam() = 1\n  AreASilentLaser/zero\n");
  EXPECT_THAT(listed, ElementsAre("CommandLoss.Brakes", "CommandLoss.Other", "LostSweeps.AreASilentLaser"));
  const auto commands = test_commands(rows_of(kReadme), {{"test_a", listed}, {"test_b", {"Launch.GoesOn"}}});
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_THAT(commands[0].words,
              ElementsAre("test_a", "--gtest_filter=CommandLoss.Brakes:*/CommandLoss.Brakes/*"));
  EXPECT_THAT(commands[1].words.front(), "test_b");
  EXPECT_EQ(commands[1].row, 1);
}

TEST(Battery, ReadsFiguresOfWhatIsPrinted) {
  const auto laser = figures_of("silent laser, 59 trials: braking after 290 ms at the latest\n", 0);
  EXPECT_EQ(laser.n, 59);
  EXPECT_TRUE(laser.has_trials);
  EXPECT_EQ(laser.worst, "290 ms");
  EXPECT_EQ(laser.failures, 0);
  const auto lost = figures_of("stop frame: 299 of 300 within 300 ms, median 210 ms, worst 311 ms\n", 1);
  EXPECT_EQ(lost.n, 300);
  EXPECT_EQ(lost.worst, "311 ms");
  EXPECT_EQ(lost.failures, 1);
  const auto loops =
      figures_of("100 loops, 2 failures; up after 1.20 s at the latest, ended after 0.31 s\n", 1);
  EXPECT_EQ(loops.n, 100);
  EXPECT_EQ(loops.failures, 2);
  EXPECT_EQ(loops.worst, "1.20 s");
  const auto tests =
      figures_of("[==========] 3 tests from 1 test suite ran. (5 ms total)\n[  PASSED  ] 3 tests.\n", 0);
  EXPECT_EQ(tests.n, 3);
  EXPECT_FALSE(tests.has_trials);
  EXPECT_EQ(
      figures_of("[==========] 3 tests from 1 test suite ran. (5 ms total)\n[  FAILED  ] 2 tests, listed "
                 "below:\n",
                 1)
          .failures,
      2);
  EXPECT_EQ(figures_of("", 134).failures, 1);
}

TEST(Battery, NeverCountsAsPassedWhatWasNotRun) {
  const auto rows = rows_of(kReadme);
  const std::vector<BatteryResult> results = {
      {rows[0], {{"test_a", {.n = 59, .has_trials = true, .failures = 0, .worst = "290 ms"}}}},
      {rows[1], {}}};
  EXPECT_THAT(battery_table(results), AllOf(HasSubstr("59 trials"), HasSubstr("not run"),
                                            HasSubstr("1 of 2 rows ran, 0 with failures; 1 not run")));
  EXPECT_EQ(failed_rows(results), 0);
}

TEST(Battery, ReadsRowsThatAreNamed) {
  EXPECT_THAT(rows_named("1,2,6-8"), ElementsAre(1, 2, 6, 7, 8));
  EXPECT_THAT(rows_named(""), IsEmpty());
  for (const char* text : {"x", "0", "-", "3-", "1,,2"})
    EXPECT_THROW(rows_named(text), std::runtime_error) << text;
}

TEST(Battery, AsksForHundredsOfTheWorstRowsAnd59OfOthers) {
  EXPECT_EQ(asked_of(1), 300);
  EXPECT_EQ(asked_of(6), 59);
  EXPECT_EQ(asked_of(35), 1000);
}

}  // namespace
}  // namespace bw
