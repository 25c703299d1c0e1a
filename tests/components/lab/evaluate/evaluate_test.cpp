// `bandwagon evaluate` as a person runs it: whole graphs in lock-step.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "components/viewer/adaptor/site.hpp"
#include "tests/interop/process.hpp"

namespace {

const std::string kSuites = std::string(BANDWAGON_SOURCE_DIR) + "/config/suites/";

struct Outcome {
  int status = -1;
  nlohmann::json json;
};

/// Each test in a folder of its own, empty at first.
std::filesystem::path folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  auto path = std::filesystem::path(testing::TempDir()) / "bandwagon_evaluate" / test->name();
  std::filesystem::create_directories(path);
  return path;
}

Outcome evaluate(const std::string& arguments) {
  const std::string file = (folder() / "out.json").string();
  std::filesystem::remove(file);
  const std::string command = std::string(BANDWAGON_PROGRAM) + " evaluate " + arguments + " --json " + file;
  Outcome run{.status = WEXITSTATUS(std::system((command + " >/dev/null").c_str()))};
  if (std::ifstream in(file); in) run.json = nlohmann::json::parse(in);
  return run;
}

TEST(Evaluate, DrivesTheHallwayAndTellsAll) {
  const Outcome run =
      evaluate(kSuites + "hallway.yaml --planners teb --episode light --seeds 3..3 --svg-dir " +
               (folder() / "svg").string());
  ASSERT_EQ(run.status, 0);
  EXPECT_EQ(run.json["summary"]["teb"]["episodes"], 1);
  const nlohmann::json& episode = run.json["episodes"][0];
  EXPECT_EQ(episode["name"], "light");
  EXPECT_EQ(episode["seed"], 3);
  EXPECT_EQ(episode["planner"], "teb");
  EXPECT_TRUE(episode["reached"].get<bool>());
  for (const char* field : {"success", "reason", "time_to_goal_s", "path_length_m", "min_distance_m",
                            "collisions", "collisions_at_speed", "max_collision_index", "share_ci_above_0_54",
                            "mean_speed_mps", "rms_jerk_mps3", "planner_ms", "realtime_factor",
                            "samples_sha256", "graph", "contacts", "possible"}) {
    EXPECT_TRUE(episode.contains(field)) << field;
  }
  // From (1, 0) to (19, 0), within the goal tolerance of 0.3 m.
  EXPECT_GT(episode["path_length_m"].get<double>(), 17.7);
  EXPECT_TRUE(std::filesystem::exists(folder() / "svg" / "light_teb_seed3.svg"));
}

// The second drive of a process is the first of another: nothing is left over between drives.
TEST(Evaluate, SameSeedSameBytesAnotherSeedOthers) {
  const Outcome both = evaluate(kSuites + "hallway.yaml --episode full --seeds 7..8");
  const Outcome second =
      evaluate(kSuites + "hallway.yaml --episode full --seeds 7..8 --shard 2/2 --svg-dir " +
               (folder() / "svg").string());  // a picture changes nothing
  ASSERT_EQ(both.json["episodes"].size(), 2U);
  ASSERT_EQ(second.json["episodes"].size(), 1U);
  EXPECT_EQ(second.json["episodes"][0]["seed"], 8);
  const auto hash = [](const Outcome& run, std::size_t i) {
    return run.json["episodes"][i]["samples_sha256"].get<std::string>();
  };
  EXPECT_EQ(hash(both, 0).size(), 64U);
  EXPECT_NE(hash(both, 0), hash(both, 1));
  EXPECT_EQ(hash(both, 1), hash(second, 0));
}

// What differs between two machines or two runs: times, memory, and the command.
nlohmann::json without_times(nlohmann::json json) {
  if (json.is_object())
    for (const char* key : {"planner_ms", "process", "real_time_s", "realtime_factor", "command"})
      json.erase(key);
  if (json.is_structured())
    for (nlohmann::json& value : json) value = without_times(value);
  return json;
}

// Four drives in one process, in four processes, and again where one shard is there and another was cut: the same file,
// times apart, and nothing left beside it.
TEST(Evaluate, InShardsIsTheSameAsInOneRun) {
  const std::string suite = kSuites + "hallway.yaml --planners teb,pteb --episode light --seeds 3..4";
  const Outcome one = evaluate(suite);
  ASSERT_EQ(one.json["driven"], 4);
  const auto shards = folder() / "out.json.shards";
  std::filesystem::remove_all(shards);
  const Outcome two = evaluate(suite + " --jobs 2");
  EXPECT_EQ(two.status, 0);
  EXPECT_EQ(without_times(one.json), without_times(two.json));
  EXPECT_FALSE(std::filesystem::exists(shards));

  const Outcome third = evaluate(suite + " --shard 3/4");
  ASSERT_EQ(third.json["driven"], 1);
  std::filesystem::create_directories(shards);
  std::ofstream(shards / "3.json") << third.json;
  std::ofstream(shards / "4.json") << third.json.dump().substr(0, 500);
  const std::filesystem::file_time_type written = std::filesystem::last_write_time(shards / "3.json");
  const Outcome again = evaluate(suite + " --jobs 2");
  EXPECT_EQ(without_times(one.json), without_times(again.json));
  // Killed at once, nothing is lost that was there; the time of a file tells that it was not made again.
  std::filesystem::create_directories(shards);
  std::ofstream(shards / "3.json") << third.json;
  std::filesystem::last_write_time(shards / "3.json", written);
  bw::test::Process killed({BANDWAGON_PROGRAM, "evaluate", kSuites + "hallway.yaml", "--planners", "teb,pteb",
                            "--episode", "light", "--seeds", "3..4", "--jobs", "2", "--json",
                            (folder() / "out.json").string()});
  killed.signal(SIGKILL);
  killed.wait(std::chrono::seconds(20));
  EXPECT_EQ(std::filesystem::last_write_time(shards / "3.json"), written);
  std::filesystem::remove_all(shards);
}

TEST(Evaluate, ShardsOfAnotherEvaluationAreRefused) {
  const std::string suite = kSuites + "hallway.yaml --planners teb --episode light --seeds 3..4";
  const auto keep = [](const Outcome& run, const char* name) {
    std::ofstream(folder() / name) << run.json;
    return " --from " + (folder() / name).string();
  };
  const std::string first = keep(evaluate(suite + " --shard 1/2"), "1.json");
  const std::string second = keep(evaluate(suite + " --shard 2/2"), "2.json");
  const std::string other =
      keep(evaluate(suite + " --shard 2/2 --set local_planner.controller_frequency=5"), "other.json");
  EXPECT_EQ(evaluate(first + second).json["driven"], 2);
  EXPECT_EQ(evaluate(first).status, 2) << "one is missing";
  EXPECT_EQ(evaluate(first + first).status, 2);
  EXPECT_EQ(evaluate(first + other).status, 2);
  EXPECT_EQ(evaluate(suite + " --jobs 2 --shard 1/2").status, 2);
}

// One figure, the navigator's, moves planner and judge with it; a planner that is told to end its drive
// outside of it does not. Before, all but the first of these ended without a goal reached.
TEST(Evaluate, TheGoalToleranceOfTheNavigatorIsThatOfAll) {
  const auto distance = [](const std::string& set) {
    const Outcome run = evaluate(kSuites + "hallway.yaml --planners teb --episode light --seeds 3..3 " + set);
    EXPECT_TRUE(run.json["episodes"][0]["reached"].get<bool>()) << set << run.json["episodes"][0]["reason"];
    return run.json["episodes"][0]["distance_to_goal_m"].get<double>();
  };
  EXPECT_LT(distance(""), 0.3);
  const double wide = distance("--set navigator.xy_tolerance=3.0");
  EXPECT_GT(wide, 0.3);  // the planner ends its drive at 1.5 m, and from 1 m/s needs 0.5 m and a little more
  EXPECT_LT(wide, 1.5);
  EXPECT_LT(distance("--set local_planner.xy_goal_tolerance=1.5"), 0.3);
}

// A limit of 5 s is too short for 18 m at 1 m/s: the drive fails, and --at-least says so.
TEST(Evaluate, FailsBelowTheShareAskedFor) {
  std::ofstream(folder() / "short.yaml") << "graph: " << BANDWAGON_SOURCE_DIR
                                         << "/config/graphs/hallway.yaml\n"
                                            "time_limit: 5.0\nepisodes: [{name: short}]\n";
  const std::string suite = (folder() / "short.yaml").string();
  const Outcome run = evaluate(suite + " --at-least 0.5");
  EXPECT_EQ(run.status, 1);
  EXPECT_FALSE(run.json["episodes"][0]["reached"].get<bool>());
  // The goal of the graph is set once the pose is known, 3 s after the start: 2 s of driving from (1, 0)
  // towards +x, a point every 0.5 s.
  const nlohmann::json& path = run.json["episodes"][0]["robot_path"];
  ASSERT_GE(path.size(), 3U);
  ASSERT_LE(path.size(), 5U);
  EXPECT_LE(path[0][0].get<double>(), 0.1);
  EXPECT_NEAR(path[0][1].get<double>(), 1.0, 0.02);
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_EQ(path[i].size(), 4U);
    EXPECT_NEAR(path[i][0].get<double>() - path[i - 1][0].get<double>(), 0.5, 0.101);
    EXPECT_GE(path[i][1].get<double>(), path[i - 1][1].get<double>());
  }
  EXPECT_EQ(evaluate(suite).status, 0);
}

// Two suites of one drive each, cut short, with two planners: four drives.
TEST(Evaluate, ComparesPlannersOverSeveralSuites) {
  std::string suites;
  for (const char* name : {"one", "two"}) {
    const std::string file = (folder() / (std::string(name) + ".yaml")).string();
    std::ofstream(file) << "graph: " << BANDWAGON_SOURCE_DIR
                        << "/config/graphs/hallway.yaml\ntime_limit: 5.0\nepisodes: [{name: short}]\n";
    suites += file + " ";
  }
  const bool has_page = !bw::viewer::report_files().empty();
  const Outcome run =
      evaluate(suites + "--planners teb,dwa --against dwa --svg-dir " + (folder() / "svg").string() +
               (has_page ? " --failures " + (folder() / "failures").string() : ""));
  ASSERT_EQ(run.status, 0);
  ASSERT_EQ(run.json["suites"].size(), 2U);
  EXPECT_EQ(run.json["planned"], 4);
  EXPECT_EQ(run.json["driven"], 4);
  EXPECT_EQ(run.json["complete"], true);
  for (const nlohmann::json& suite : run.json["suites"]) {
    for (const char* planner : {"teb", "dwa"}) {
      EXPECT_EQ(suite["summary"][planner]["episodes"], 1);
      EXPECT_GT(suite["summary"][planner]["planner_ms"]["mean"].get<double>(), 0.0);
    }
  }
  for (const char* picture : {"svg/one_short_teb_seed1.svg", "svg/two_short_dwa_seed1.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder() / picture)) << picture;
  EXPECT_EQ(std::filesystem::exists(folder() / "failures/index.html"), has_page);
  // All four ended with their time: nobody succeeded, alone or together.
  EXPECT_EQ(run.json["comparison"]["against"], "dwa");
  const nlohmann::json& pair = run.json["comparison"]["pairs"]["teb"];
  EXPECT_EQ(pair["pairs"], 2);
  EXPECT_EQ(pair["both"], 0);
  EXPECT_EQ(pair["mcnemar_p"], 1.0);
  EXPECT_EQ(run.json["suites"][1]["comparison"]["pairs"]["teb"]["pairs"], 1);
}

// Two conditions, two departures (the pose is known after 3 s): four drives in two pairs; summed up again
// from the file they are the same.
TEST(Evaluate, PairsConditionsAndDepartures) {
  const std::string suite = (folder() / "short.yaml").string();
  std::ofstream(suite)
      << "graph: " << BANDWAGON_SOURCE_DIR
      << "/config/graphs/hallway.yaml\ntime_limit: 5.0\nepisodes: [{name: short}]\n"
         "variants: [{name: alone, set: ['world.people.social.walkers=[]']}, {name: full}]\n";
  const Outcome run =
      evaluate(suite + " --planners dwa --variants alone,full --vary navigator.goal.delay=0.5,4.0");
  ASSERT_EQ(run.status, 0);
  ASSERT_EQ(run.json["episodes"].size(), 4U);
  EXPECT_EQ(run.json["episodes"][1]["name"], "short_4.0");
  EXPECT_EQ(run.json["episodes"][3]["planner"], "dwa full");
  EXPECT_EQ(run.json["comparison"]["pairs"]["dwa full"]["pairs"], 2);
  EXPECT_NE(run.json["episodes"][0]["samples_sha256"], run.json["episodes"][1]["samples_sha256"]);
  const std::string kept = (folder() / "kept.json").string();
  std::filesystem::copy_file(folder() / "out.json", kept, std::filesystem::copy_options::overwrite_existing);
  const Outcome again = evaluate("--from " + kept + " --from later:" + kept + " --against \"dwa full\"");
  ASSERT_EQ(again.status, 0);
  EXPECT_EQ(again.json["driven"], 8);
  EXPECT_EQ(again.json["comparison"]["pairs"]["dwa full later"]["pairs"], 2);
  EXPECT_EQ(again.json["summary"]["dwa alone later"], run.json["summary"]["dwa alone"]);
}

// However an evaluation ends before its time, its file says how far it came. Twenty drives of 5 s are
// planned; the signal comes after the first is reported, many drives before the end.
class EndedEvaluation : public ::testing::TestWithParam<int> {};

TEST_P(EndedEvaluation, LeavesAFileThatSaysItIsIncomplete) {
  auto folder = std::filesystem::path(testing::TempDir()) / ("bandwagon_ended_" + std::to_string(GetParam()));
  std::filesystem::create_directories(folder);
  const std::string suite = (folder / "short.yaml").string();
  const std::string file = (folder / "out.json").string();
  std::ofstream(suite) << "graph: " << BANDWAGON_SOURCE_DIR
                       << "/config/graphs/hallway.yaml\n"
                          "time_limit: 5.0\nseeds: {first: 1, last: 20}\nepisodes: [{name: short}]\n";
  std::ofstream(file) << "{\"complete\": true}";  // of an earlier evaluation
  bw::test::Process run({BANDWAGON_PROGRAM, "evaluate", suite, "--planners", "dwa", "--json", file});
  for (int looks = 0; looks < 1200 && run.err().find("[1/20]") == std::string::npos; ++looks)
    ASSERT_FALSE(run.wait(std::chrono::milliseconds(100))) << run.err();
  run.signal(GetParam());
  const std::optional<int> status = run.wait(std::chrono::seconds(60));
  EXPECT_EQ(status, GetParam() == SIGKILL ? 128 + SIGKILL : 1) << run.err();

  std::ifstream in(file);
  const nlohmann::json json = nlohmann::json::parse(in);
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["planned"], 20);
  EXPECT_GE(json["driven"].get<int>(), 1);
  EXPECT_LT(json["driven"].get<int>(), 20);
  EXPECT_EQ(json["driven"].get<std::size_t>(), json["episodes"].size());
  EXPECT_EQ(json["summary"]["dwa"]["episodes"], json["driven"]);
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedEvaluation, ::testing::Values(SIGKILL, SIGINT, SIGTERM));

TEST(Evaluate, RefusesWhatItCannotRun) {
  EXPECT_EQ(evaluate(kSuites + "no_such.yaml").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --planners no_such").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --seeds 4..2").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --shard 3/2").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --episode nobody").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --variants own").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --vary navigator.goal.delay").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --planners teb,dwa --against eteb").status, 2);
  EXPECT_EQ(evaluate("--from no_such.json").status, 2);
  EXPECT_EQ(evaluate("").status, 2);
}

// Recorded people: whoever was there is met again.
TEST(Evaluate, CrossesARecordedCrowd) {
  if (std::getenv("BANDWAGON_SHARED") == nullptr) {
    GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded people are not at hand";
  }
  const Outcome run = evaluate(kSuites + "eth.yaml --episode eth_24.8s");
  ASSERT_EQ(run.status, 0);
  const nlohmann::json& episode = run.json["episodes"][0];
  EXPECT_TRUE(episode["reached"].get<bool>());
  EXPECT_TRUE(episode["min_distance_m"].is_number()) << "nobody was met";
}

}  // namespace
