// `bandwagon evaluate` as a person runs it: whole graphs in lock-step.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

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
  for (const char* field :
       {"success", "reason", "time_to_goal_s", "path_length_m", "min_distance_m", "collisions",
        "collisions_at_speed", "max_collision_index", "share_ci_above_0_54", "mean_speed_mps",
        "rms_jerk_mps3", "planner_ms", "realtime_factor", "samples_sha256", "graph"}) {
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

// A limit of 3 s is too short for 18 m at 1 m/s: the drive fails, and --at-least says so.
TEST(Evaluate, FailsBelowTheShareAskedFor) {
  std::ofstream(folder() / "short.yaml") << "graph: " << BANDWAGON_SOURCE_DIR
                                         << "/config/graphs/hallway.yaml\n"
                                            "time_limit: 3.0\nepisodes: [{name: short}]\n";
  const std::string suite = (folder() / "short.yaml").string();
  const Outcome run = evaluate(suite + " --at-least 0.5");
  EXPECT_EQ(run.status, 1);
  EXPECT_FALSE(run.json["episodes"][0]["reached"].get<bool>());
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
  const Outcome run = evaluate(suites + "--planners teb,dwa --svg-dir " + (folder() / "svg").string());
  ASSERT_EQ(run.status, 0);
  ASSERT_EQ(run.json["suites"].size(), 2U);
  for (const nlohmann::json& suite : run.json["suites"]) {
    for (const char* planner : {"teb", "dwa"}) {
      EXPECT_EQ(suite["summary"][planner]["episodes"], 1);
      EXPECT_GT(suite["summary"][planner]["planner_ms"]["mean"].get<double>(), 0.0);
    }
  }
  for (const char* picture : {"one_short_teb_seed1.svg", "two_short_dwa_seed1.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder() / "svg" / picture)) << picture;
}

TEST(Evaluate, RefusesWhatItCannotRun) {
  EXPECT_EQ(evaluate(kSuites + "no_such.yaml").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --planners no_such").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --seeds 4..2").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --shard 3/2").status, 2);
  EXPECT_EQ(evaluate(kSuites + "hallway.yaml --episode nobody").status, 2);
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
