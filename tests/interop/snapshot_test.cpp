// The flight recorder of a whole graph: nothing of it enters a sample, a near miss is a bag of its own, what
// cannot be is refused before anything moves, and processes of one graph write together.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kSource = BANDWAGON_SOURCE_DIR;
const std::string kGraph = kSource + "/config/graphs/hallway.yaml";

Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, std::chrono::seconds(300));
}

nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> folders_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  if (!std::filesystem::exists(folder)) return paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

class Snapshot : public testing::Test {
 protected:
  Snapshot()
      : folder_(std::filesystem::temp_directory_path() /
                ("snapshot_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Snapshot() override { std::filesystem::remove_all(folder_); }

  /// The hallway for `seconds` in lock-step; the score card.
  nlohmann::json drive(const std::string& seconds, std::vector<std::string> more) {
    std::vector<std::string> command = {"run", kGraph,  "--clock", "lockstep", "--seed",
                                        "1",   "--for", seconds,   "--json",   folder_ / "card.json"};
    for (std::string& option : more) command.push_back(std::move(option));
    const Outcome run = bandwagon(command);
    EXPECT_EQ(run.status, 1) << run.err;  // too short for the goal
    err_ = run.err;
    return read_json(folder_ / "card.json");
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::filesystem::path folder_;
  std::string err_;
};

// A monitor that takes every sweep for one of a broken laser stops the robot as soon as it wants to drive.
const std::vector<std::string> kBlind = {"--set", "collision_monitor.sweep.min_returns=2000"};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST_F(Snapshot, ChangesNoSampleAndEqualRunsGiveEqualBags) {
  const std::string plain = drive("6", kBlind)["samples_sha256"];
  std::vector<std::string> bags;
  for (const char* name : {"a", "b"}) {
    const std::filesystem::path to = folder_ / name;
    const auto card = drive("6", kBlind + std::vector<std::string>{"--snapshot", "1s", "--snapshot-to", to});
    EXPECT_EQ(card["samples_sha256"], plain);
    ASSERT_EQ(card["snapshots"]["written"], 1) << card["snapshots"];
    ASSERT_EQ(folders_in(to).size(), 1U);
    bags.push_back(content_of(folders_in(to)[0] / (folders_in(to)[0].filename().string() + "_0.mcap")));
  }
  EXPECT_FALSE(bags[0].empty());
  EXPECT_TRUE(bags[0] == bags[1]);
  const auto both =
      drive("6", kBlind + std::vector<std::string>{"--snapshot", "1s", "--snapshot-to", folder_ / "c",
                                                   "--record", folder_ / "drive"});
  EXPECT_EQ(both["samples_sha256"], plain);
}

TEST_F(Snapshot, AStopIsABagOfTheTimeAroundIt) {
  const std::filesystem::path to = folder_ / "misses";
  drive("8", kBlind + std::vector<std::string>{"--snapshot", "2s", "--snapshot-to", to});
  const auto bags = folders_in(to);
  ASSERT_EQ(bags.size(), 1U);
  EXPECT_THAT(bags[0].filename().string(), EndsWith("_stop"));
  EXPECT_THAT(err_, HasSubstr("stop at "));
  EXPECT_THAT(err_, HasSubstr(bags[0].string()));
  EXPECT_EQ(bandwagon({"bag", "check", bags[0]}).status, 0);
  const nlohmann::json info = nlohmann::json::parse(bandwagon({"bag", "info", bags[0], "--json"}).out);
  std::vector<std::string> attachments;
  for (const auto& attachment : info["attachments"]) attachments.push_back(attachment["name"]);
  EXPECT_THAT(attachments, ElementsAre("graph.yaml", "parameters.yaml", "robot.yaml"));
  for (const auto& topic : info["topics"]) {
    // Both were written at the start, seconds before what is kept.
    if (topic["name"] == "/map" || topic["name"] == "/tf_static") {
      EXPECT_EQ(topic["count"], 1) << topic;
    }
    // 2 s before and 2 s after at 10 Hz, both ends included.
    if (topic["name"] == "/scan") {
      EXPECT_GE(topic["count"], 40) << topic;
      EXPECT_LE(topic["count"], 41) << topic;
    }
  }
}

TEST_F(Snapshot, ALostRobotAndAContactAreEventsAndADriveWithoutThemLeavesNothing) {
  const std::filesystem::path to = folder_ / "misses";
  const std::vector<std::string> snapshot = {"--snapshot", "2s", "--snapshot-to", to};
  drive("6", snapshot);
  EXPECT_FALSE(std::filesystem::exists(to));
  // A pose 4 m off, which every fix contradicts.
  drive("6", snapshot + std::vector<std::string>{"--set", "localization.set_initial_pose=true", "--set",
                                                 "localization.initial_pose.x=5"});
  ASSERT_EQ(folders_in(to).size(), 1U);
  EXPECT_THAT(folders_in(to)[0].string(), EndsWith("_lost"));
  // The dynamic window as published, without evasive moves, among people who do not make way.
  const auto card =
      drive("16", snapshot + std::vector<std::string>{"--set", "world.people_react=false", "--set",
                                                      "local_planner.algorithm=dwa", "--set",
                                                      "local_planner.dwa.check_movers=false", "--set",
                                                      "local_planner.evasion_horizon=0"});
  ASSERT_GT(card["collisions"], 0);
  EXPECT_THAT(folders_in(to), Contains(testing::ResultOf([](const auto& path) { return path.string(); },
                                                         EndsWith("_contact"))));
}

TEST_F(Snapshot, WhatCannotBeIsRefusedBeforeAnythingMoves) {
  std::string hallway = content_of(kGraph);
  hallway.replace(hallway.find("../robots"), 9, kSource + "/config/robots");
  const auto said = [&](const std::string& section) {
    const auto graph = write("g.yaml", hallway + "\nsnapshot: " + section + "\n");
    const Outcome run = bandwagon({"run", graph, "--clock", "lockstep", "--for", "1"});
    EXPECT_EQ(run.status, 2) << section;
    return run.err;
  };
  const int line = static_cast<int>(std::ranges::count(hallway, '\n')) + 2;
  const std::string where = (folder_ / "g.yaml").string() + ":" + std::to_string(line) + ": snapshot.on = ";
  EXPECT_THAT(said("{to: x, on: [contct]}"),
              HasSubstr(where + "contct: unknown event; did you mean 'contact'?; a topic begins with /"));
  EXPECT_THAT(said("{to: x, on: [/scn]}"),
              HasSubstr(where + "/scn: nobody in this graph publishes it; did you mean '/scan'?"));
  EXPECT_THAT(said("{to: x, on: [{topic: /scan, field: range_mx, above: 1}]}"),
              HasSubstr(where + "/scan range_mx: sensor_msgs/msg/LaserScan: unknown field"));
  EXPECT_THAT(said("{to: g.yaml}"), HasSubstr("is no folder that can be written"));
  const Outcome none =
      bandwagon({"run", kSource + "/tests/interop/drive.yaml", "--clock", "lockstep", "--for", "1",
                 "--snapshot", "5s", "--snapshot-on", "lost", "--record", folder_ / "drive"});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("tells of a component that this graph does not have: localization"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "drive"));
}

TEST_F(Snapshot, OptionsThatSayNothingAreRefused) {
  const std::vector<std::string> run = {"run", kGraph, "--clock", "lockstep", "--for", "1"};
  const std::string record = folder_ / "drive";
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
      {{"--split-size", "5MB"}, "need --record"},
      {{"--record", record + ".mcap", "--max-size", "50MB"}, "one file is not split"},
      {{"--record", record, "--split-size", "5MX"}, "--split-size 5MX: must be a size of at least 1MB"},
      {{"--record", record, "--split-duration", "0s"},
       "--split-duration 0s: must be a duration of at least 1 s"},
      {{"--record", record, "--max-size", "20MB", "--split-size", "15MB"}, "at most half of --max-size"},
      {{"--record", record, "--compression", "zip"}, "zip"},
      {{"--snapshot", "soon"}, "--snapshot soon: must be a duration"},
      {{"--snapshot-to", "x"}, "need --snapshot"},
      {{"--snapshot", "5s", "--snapshot-memory", "5"},
       "--snapshot-memory 5: must be a size of at least 1MB"}};
  for (const auto& [options, words] : refused) {
    const Outcome outcome = bandwagon(run + options);
    EXPECT_EQ(outcome.status, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
  }
  EXPECT_FALSE(std::filesystem::exists(record));
}

TEST_F(Snapshot, ALimitedRecordingHasTheNewestAndItsMap) {
  const std::filesystem::path bag = folder_ / "drive";
  const Outcome run = bandwagon({"run", kGraph, "--clock", "lockstep", "--seed", "1", "--for", "12",
                                 "--record", bag, "--compression", "none", "--max-size", "10MB"});
  EXPECT_EQ(run.status, 1) << run.err;
  std::uintmax_t size = 0;
  for (const auto& entry : std::filesystem::directory_iterator(bag)) size += entry.file_size();
  EXPECT_LE(size, 10'500'000U);  // with metadata.yaml and the summary of the last file
  const Outcome check = bandwagon({"bag", "check", bag});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
  const nlohmann::json info = nlohmann::json::parse(bandwagon({"bag", "info", bag, "--json"}).out);
  std::set<std::string> once;
  for (const auto& topic : info["topics"]) {
    if (topic["count"] == 1) once.insert(topic["name"]);
  }
  EXPECT_THAT(once, AllOf(Contains("/map"), Contains("/tf_static")));
}

TEST_F(Snapshot, ProcessesOfOneGraphWriteTogether) {
  std::ifstream file(kSource + "/tests/interop/drive.yaml");
  std::string graph = (std::ostringstream() << file.rdbuf()).str();
  graph.replace(graph.find("../.."), 5, kSource);
  graph.replace(graph.find("  map_server:\n"), 14, "  map_server:\n    process: rest\n");
  graph += "\nsnapshot: {keep: 2s, to: misses, on: [/joint_states]}\n";
  const auto path = write("g.yaml", graph);
  // Each message is an event, so that one comes when both have found each other.
  Process rest({BANDWAGON_PROGRAM, "run", path, "--only", "rest", "--for", "8"});
  Process main({BANDWAGON_PROGRAM, "run", path, "--only", "main", "--for", "8"});
  EXPECT_EQ(main.wait(std::chrono::seconds(60)).value_or(-1), 0) << main.err();
  EXPECT_EQ(rest.wait(std::chrono::seconds(60)).value_or(-1), 0) << rest.err();
  const auto bags = folders_in(folder_ / "misses");
  ASSERT_EQ(bags.size(), 2U) << main.err() << rest.err();
  std::map<std::string, bool> has_map;
  for (const auto& bag : bags) {
    const nlohmann::json info = nlohmann::json::parse(bandwagon({"bag", "info", bag, "--json"}).out);
    for (const auto& topic : info["topics"]) {
      if (topic["name"] == "/map") has_map[bag.filename().string().substr(20)] = topic["count"] == 1;
    }
  }
  EXPECT_THAT(has_map, ElementsAre(testing::Pair("_rest_joint_states", true)));
}

}  // namespace
}  // namespace bw::test
