// A drive is recorded, and components run again on the recording: what they write is what they wrote, byte by
// byte.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "runtime/recording/bag/bag.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";

Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, std::chrono::seconds(300));
}

nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

/// The first 8 s of the hallway, recorded once for all tests.
class Recording : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / "recording";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    for (const bool records : {true, false}) {
      std::vector<std::string> command = {
          "run", kGraph,  "--clock", "lockstep", "--seed",
          "7",   "--for", "8",       "--json",   folder_ / (records ? "with.json" : "without.json")};
      if (records) command.insert(command.end(), {"--record", folder_ / "drive"});
      const Outcome run = bandwagon(command);
      ASSERT_EQ(run.status, 1) << run.err;  // 8 s are too few for the goal
    }
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }
  static Outcome replay(std::vector<std::string> run, std::vector<std::string> more = {}) {
    std::vector<std::string> command = {"replay",  folder_ / "drive", "--graph", kGraph,
                                        "--clock", "lockstep",        "--json",  folder_ / "verdict.json"};
    for (std::string& option : more) command.push_back(std::move(option));
    command.emplace_back("--run");
    for (std::string& name : run) command.push_back(std::move(name));
    return bandwagon(command);
  }
  static std::filesystem::path folder_;
};

std::filesystem::path Recording::folder_;

TEST_F(Recording, ChangesNoSample) {
  EXPECT_EQ(read_json(folder_ / "with.json")["samples_sha256"],
            read_json(folder_ / "without.json")["samples_sha256"]);
}

TEST_F(Recording, IsSoundAndSaysWhatItIs) {
  const Outcome check = bandwagon({"bag", "check", folder_ / "drive", "--json"});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
  const nlohmann::json json = nlohmann::json::parse(check.out);
  EXPECT_EQ(json["attachments"][0]["name"], "graph.yaml");
  for (const auto& topic : json["topics"]) {
    // 10 sweeps a second from 0.1 s on; 8 s end with the run.
    if (topic["name"] == "/scan") {
      EXPECT_EQ(topic["count"], 80);
    }
    EXPECT_EQ(topic["malformed"], 0) << topic;
  }
}

TEST_F(Recording, EachComponentAloneWritesWhatItWrote) {
  for (const char* name :
       {"localization", "people", "local_costmap", "local_planner", "collision_monitor", "navigator"}) {
    const Outcome outcome = replay({name});
    EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("equal: ")) << name;
  }
}

TEST_F(Recording, AllOfThemTogetherWriteWhatTheyWrote) {
  const Outcome outcome =
      replay({"localization", "people", "local_costmap", "local_planner", "collision_monitor", "navigator"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_GT(read_json(folder_ / "verdict.json")["compared"], 1000);
}

TEST_F(Recording, AChangedWeightIsNamedByItsFirstDifference) {
  const Outcome outcome = replay({"local_planner"}, {"--set", "local_planner.teb.band.weights.time=2"});
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("first difference: "));
  const nlohmann::json first = read_json(folder_ / "verdict.json")["first_difference"];
  EXPECT_FALSE(first["field"].get<std::string>().empty());
  EXPECT_NE(first["recorded"], first["replayed"]);
}

/// Everything but what each process says for itself: topic, time, stamp and bytes of every message.
std::vector<std::string> messages_of(const std::filesystem::path& path) {
  const auto recording = bag::open_bag(path);
  const std::string over = recording->metadata().at("result").at("messages_of_run");
  std::vector<std::string> list;
  const auto messages = recording->messages({});
  bag::BagMessage m;
  for (std::uint64_t i = 0; i < std::stoull(over) && messages->next(m) == bag::Step::message; ++i) {
    const std::string& topic = recording->topics()[m.topic].name;
    if (topic == "/rosout" || topic == "/diagnostics" || topic == "/clock") continue;
    list.push_back(topic + " " + recording->topics()[m.topic].writer + " " +
                   std::to_string(m.log_time.nanoseconds) + " " + std::to_string(m.publish_time.nanoseconds) +
                   " " + std::string(m.data.begin(), m.data.end()));
  }
  return list;
}

// Record, replay, record: the new bag holds the same messages at the same times in the same order, and is as
// good a truth as the first.
TEST_F(Recording, ReplayedAndRecordedAgainIsTheSame) {
  const std::vector<std::string> all = {"localization",      "people",   "local_costmap", "local_planner",
                                        "collision_monitor", "navigator"};
  const Outcome outcome = replay(all, {"--update"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const std::vector<std::string> first = messages_of(folder_ / "drive");
  const std::vector<std::string> second = messages_of(folder_ / "drive.replayed");
  EXPECT_GT(first.size(), 3000U);
  EXPECT_TRUE(first == second) << first.size() << " and " << second.size() << " messages";
  const Outcome again =
      bandwagon({"replay", folder_ / "drive.replayed", "--graph", kGraph, "--run", "people"});
  EXPECT_EQ(again.status, 0) << again.out << again.err;
}

// What one weight changes lies within a tolerance wide enough, or is left out.
TEST_F(Recording, TolerancesOfTheGraphHold) {
  std::ifstream in(kGraph);
  std::string graph((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto resolved = [&](const std::string& key) {  // paths are relative to the file they stand in
    const std::string from = key + ": ../";
    for (std::size_t at = graph.find(from); at != std::string::npos; at = graph.find(from))
      graph.replace(at, from.size(), key + ": " + std::string(BANDWAGON_SOURCE_DIR) + "/config/");
  };
  resolved("robot");
  std::ofstream(folder_ / "tolerant.yaml")
      << graph << "\ntolerances:\n  /cmd_vel_nav: {linear: 5, angular: 5}\n  /follow_status: {command: 5}\n"
      << "  /local_plan: {poses: left_out}\n  /local_planner_markers: {markers: left_out}\n"
      << "  /local_planner_cycle: {chosen_cost: left_out, chosen_label: left_out, class_switched: left_out, "
         "iterations: left_out, number_of_candidates: left_out}\n";
  const std::vector<std::string> change = {"--set", "local_planner.teb.band.weights.time=1.01"};
  const Outcome strict = replay({"local_planner"}, change);
  EXPECT_EQ(strict.status, 1) << strict.out << strict.err;
  const Outcome tolerant = bandwagon({"replay", folder_ / "drive", "--graph", folder_ / "tolerant.yaml",
                                      "--set", change[1], "--run", "local_planner"});
  EXPECT_EQ(tolerant.status, 0) << tolerant.out << tolerant.err;
  EXPECT_THAT(tolerant.out, HasSubstr("not compared: poses of /local_plan"));
}

TEST_F(Recording, WhatIsNotThereIsRefusedInWords) {
  const Outcome unknown = replay({"local_plannr"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'local_planner'"));
  const Outcome again =
      bandwagon({"run", kGraph, "--clock", "lockstep", "--for", "1", "--record", folder_ / "drive"});
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("is not empty"));
}

}  // namespace
}  // namespace bw::test
