// Planners that are processes of their own, asked over DDS: examples drive, and what goes wrong is told while nothing is
// lost.
#include "components/local_planner/adaptor/planner_process.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <nlohmann/json.hpp>

#include "components/local_planner/planner_registry.hpp"
#include "runtime/recording/bag/bag.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kSource = BANDWAGON_SOURCE_DIR;

PlanningProblem straight_on() {
  PlanningProblem problem{.now = Time::seconds(1000.0), .twist = {0.5, 0.0}};
  for (int i = 0; i <= 20; ++i) problem.plan.push_back({0.2 * i, 0.0, 0.0});
  return problem;
}

/// What five cycles of the odd planner end with.
std::string end_of(const std::string& kind) {
  setenv("ODD_PLANNER", kind.c_str(), 1);
  const PlannerPatience patience{
      .first = std::chrono::milliseconds(kind == "silent" ? 300 : 20'000),
      .answer = std::chrono::milliseconds(kind == "hang" || kind == "stale" ? 1500 : 20'000)};
  PlanningProblem problem = straight_on();
  try {
    PlannerProcess process(ODD_PLANNER, patience);
    for (int cycle = 0; cycle < 5; ++cycle) {
      EXPECT_EQ(process.ask(problem), (Twist2{0.5, 0.0})) << kind << " " << cycle;
      problem.now = problem.now + Duration::milliseconds(100);
    }
  } catch (const std::runtime_error& error) {
    const std::string before = "planner process " ODD_PLANNER " ";
    EXPECT_THAT(error.what(), testing::StartsWith(before));
    return std::string(error.what()).substr(before.size());
  }
  return "well";
}

TEST(PlannerProcess, SaysHowAProgramFailed) {
  EXPECT_EQ(end_of("well"), "well");
  EXPECT_EQ(end_of("hang"),
            "does not answer: nothing with the stamp 1000.200 within 1.5 s, its last answer has 1000.100");
  EXPECT_EQ(end_of("stale"),
            "does not answer: nothing with the stamp 1000.200 within 1.5 s, its last answer has 1000.100");
  EXPECT_EQ(end_of("crash"), "was killed by signal 6 (Aborted): out of ideas");
  EXPECT_EQ(end_of("nan"), "answered with a velocity that is no number: nan m/s, 0 rad/s");
  EXPECT_EQ(end_of("refuse"), "ended with status 3: no weights");
  EXPECT_EQ(
      end_of("silent"),
      "does not answer: nothing with the stamp 1000.000 within 0.3 s, and it does not publish cmd_vel as "
      "geometry_msgs/TwistStamped, transient local");
}

TEST(PlannerProcess, WhatTheBaseCannotDoIsLimited) {
  setenv("ODD_PLANNER", "well", 1);
  PlanningProblem problem = straight_on();
  problem.twist = {};
  problem.limits.acc_max = 1.0;
  problem.command_lead = 0.2;
  // 0.5 m/s is wanted, 1 m/s^2 for 0.2 s is what there is.
  EXPECT_NEAR(make_planner(ODD_PLANNER, {})->plan(problem).command.v, 0.2, 1e-12);
}

TEST(PlannerProcess, APathThatIsNoProgramIsRefused) {
  const Outcome run = run_to_end({BANDWAGON_PROGRAM, "param", "list", kSource + "/config/graphs/hallway.yaml",
                                  "--set", "local_planner.algorithm=./no_such_planner"},
                                 std::chrono::seconds(60));
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("local_planner.algorithm = ./no_such_planner"),
                             HasSubstr("must be a program that may be executed")));
}

struct Evaluation {
  Outcome run;
  nlohmann::json json;
};

/// Drives of the hallway with three walkers.
Evaluation evaluate(const std::string& planners, const std::string& seeds, const std::string& jobs = "1") {
  const Folder folder;
  Evaluation result{.run = run_to_end({BANDWAGON_PROGRAM, "evaluate", kSource + "/config/suites/hallway.yaml",
                                       "--episode", "light", "--planners", planners, "--seeds", seeds,
                                       "--jobs", jobs, "--json", folder / "out.json"},
                                      std::chrono::seconds(300))};
  if (std::ifstream in(folder / "out.json"); in) result.json = nlohmann::json::parse(in);
  return result;
}

/// It reaches the goal, and does the same again to the byte, wherever it lies.
void expect_drives_alike(const std::filesystem::path& program) {
  const Folder elsewhere;
  std::filesystem::create_symlink(program, elsewhere / program.filename());
  const Evaluation first = evaluate(program, "3..3");
  const Evaluation second = evaluate(elsewhere / program.filename(), "3..3");
  ASSERT_EQ(first.run.status, 0) << first.run.err;
  ASSERT_EQ(second.run.status, 0) << second.run.err;
  const nlohmann::json& drive = first.json["episodes"][0];
  EXPECT_EQ(drive["planner"], program.string());
  EXPECT_TRUE(drive["reached"].get<bool>()) << drive["reason"];
  EXPECT_EQ(drive["samples_sha256"], second.json["episodes"][0]["samples_sha256"]);
}

TEST(PlannerProcess, TheExampleInCppReachesTheGoalTheSameEachTime) { expect_drives_alike(FOLLOWER); }

TEST(PlannerProcess, TheExampleInPythonReachesTheGoalTheSameEachTime) {
  if (std::system("command -v python3 idlc cc >/dev/null") != 0)
    GTEST_SKIP() << "no python3, idlc (cyclonedds-tools) or cc: the example in Python is not tried";
  setenv("PYTHONDONTWRITEBYTECODE", "1", 1);
  const Folder cache;
  setenv("XDG_CACHE_HOME", (cache / "cache").c_str(), 1);
  expect_drives_alike(kSource + "/tests/examples/planner_process/follower.py");
}

TEST(PlannerProcess, ADriveWhoseProgramDiesFailsAndTheOthersAreDriven) {
  setenv("ODD_PLANNER", "crash", 1);
  const Evaluation result = evaluate(ODD_PLANNER ",hrvo", "3..4", "2");
  EXPECT_EQ(result.run.status, 1);
  EXPECT_EQ(result.json["complete"], true);
  ASSERT_EQ(result.json["episodes"].size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const nlohmann::json& drive = result.json["episodes"][i];
    EXPECT_EQ(drive["planner"], i < 2 ? ODD_PLANNER : "hrvo");
    EXPECT_EQ(drive.value("run_failed", false), i < 2);
    EXPECT_EQ(drive["reached"], i >= 2) << drive["reason"];
  }
  EXPECT_EQ(result.json["summary"][ODD_PLANNER]["episodes"], 2);
  const std::string reason = "local_planner failed in control_cycle: planner process " ODD_PLANNER
                             " was killed by signal 6 (Aborted): out of ideas";
  EXPECT_EQ(result.json["episodes"][0]["reason"], reason);
  EXPECT_THAT(result.run.out, HasSubstr(reason));
}

TEST(PlannerProcess, TheRobotStandsWhenItsProgramHasDied) {
  setenv("ODD_PLANNER", "crash", 1);
  const Folder folder;
  const Outcome run =
      run_to_end({BANDWAGON_PROGRAM, "run", kSource + "/config/graphs/hallway.yaml", "--clock", "lockstep",
                  "--set", "local_planner.algorithm=" ODD_PLANNER, "--record", folder / "drive.mcap"},
                 std::chrono::seconds(60));
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("was killed by signal 6 (Aborted): out of ideas"));
  const auto bag = bag::open_bag(folder / "drive.mcap");
  const auto messages = bag->messages({.topics = {{"/odom"}}});
  double fastest = 0.0, last = -1.0;
  for (bag::BagMessage message; messages->next(message) == bag::Step::message;) {
    nav_msgs::msg::Odometry odom;
    ASSERT_TRUE(deserialize(message.data, odom));
    last = std::abs(odom.twist().twist().linear().x());
    fastest = std::max(fastest, last);
  }
  EXPECT_GT(fastest, 0.05) << "it drove for two cycles";
  EXPECT_LT(last, 0.01);
}

}  // namespace
}  // namespace bw::test
