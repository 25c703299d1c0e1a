// `bandwagon bag` and `bandwagon bench bag` as somebody at a terminal meets them.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, std::chrono::seconds(120));
}

/// The first 2 s of the hallway, and the same without the last third of the file.
class BagVerbs : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / "bag_verbs";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    const Outcome run = bandwagon({"run", std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml",
                                   "--clock", "lockstep", "--for", "2", "--record", folder_ / "drive.mcap"});
    ASSERT_EQ(run.status, 1) << run.err;  // 2 s are too few for the goal
    std::ifstream in(folder_ / "drive.mcap", std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    std::ofstream(folder_ / "cut.mcap", std::ios::binary) << whole.substr(0, whole.size() * 2 / 3);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }
  static json said(std::vector<std::string> arguments, int status) {
    arguments.emplace_back("--json");
    const Outcome outcome = bandwagon(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
    return json::parse(outcome.out);
  }
  static std::filesystem::path folder_;
};

std::filesystem::path BagVerbs::folder_;

TEST_F(BagVerbs, InfoTellsTheWritersOfATopicInOneLine) {
  const Outcome info = bandwagon({"bag", "info", folder_ / "drive.mcap"});
  EXPECT_EQ(info.status, 0);
  EXPECT_THAT(info.out,
              ContainsRegex("/tf +1[0-9]+ .*tf2_msgs/msg/TFMessage +localization [0-9]+, robot_base [0-9]+"));
  EXPECT_THAT(info.out, ContainsRegex("/scan +20 +10.00 Hz +sensor_msgs/msg/LaserScan +world"));
  EXPECT_THAT(info.out, AllOf(HasSubstr("attachment graph.yaml"), Not(HasSubstr("damage"))));
  const json description = said({"bag", "info", folder_ / "drive.mcap"}, 0);
  int tf = 0;
  for (const json& topic : description["topics"]) {
    if (topic["name"] != "/tf") continue;
    ++tf;
    EXPECT_EQ(topic["writers"].size(), 2U);
    EXPECT_TRUE(topic["known_type"]);
  }
  EXPECT_EQ(tf, 1);
}

TEST_F(BagVerbs, CheckTellsGapsAndThatItIsSound) {
  const Outcome check = bandwagon({"bag", "check", folder_ / "drive.mcap"});
  EXPECT_EQ(check.status, 0);
  EXPECT_THAT(check.out, ContainsRegex("/scan +20 +10.00 Hz +0.100 s"));
  EXPECT_THAT(check.out, HasSubstr("sound: "));
}

TEST_F(BagVerbs, ACutBagIsLookedAtRecoveredAndConverted) {
  const Outcome info = bandwagon({"bag", "info", folder_ / "cut.mcap"});
  EXPECT_EQ(info.status, 0);
  EXPECT_THAT(info.out, HasSubstr("was not closed"));
  const json check = said({"bag", "check", folder_ / "cut.mcap"}, 1);
  EXPECT_FALSE(check["sound"]);
  const json recovered = said({"bag", "recover", folder_ / "cut.mcap", folder_ / "recovered.mcap"}, 1);
  EXPECT_EQ(recovered["messages"], check["messages"]);
  EXPECT_GT(recovered["lost_bytes"], 0);
  const json converted =
      said({"bag", "convert", folder_ / "cut.mcap", folder_ / "converted", "--compression", "lz4"}, 1);
  EXPECT_EQ(converted["messages"], check["messages"]);
  EXPECT_EQ(converted["faults"].size(), 2U);  // not closed, and where it ends
  for (const char* name : {"recovered.mcap", "converted"}) {
    const json mended = said({"bag", "check", folder_ / name}, 0);
    EXPECT_EQ(mended["messages"], check["messages"]) << name;
  }
}

TEST_F(BagVerbs, NothingIsWrittenOver) {
  const Outcome outcome = bandwagon({"bag", "convert", folder_ / "drive.mcap", folder_ / "cut.mcap"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("cut.mcap"), HasSubstr("File exists")));
}

TEST_F(BagVerbs, BenchMeasuresAndLeavesNothingBehind) {
  const std::filesystem::path folder = folder_ / "bench";
  std::filesystem::create_directories(folder);
  const Outcome outcome = bandwagon({"bench", "bag", "--folder", folder, "--size", "0.01", "--write", "0.01",
                                     "--seeks", "3", "--json", folder_ / "bench.json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::ifstream in(folder_ / "bench.json");
  const json figures = json::parse(in);
  EXPECT_EQ(figures["write"].size(), 3U);
  EXPECT_GT(figures["read"]["open_s"], 0.0);
  EXPECT_GT(figures["read"]["seek_worst_s"], 0.0);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  const Outcome too_much = bandwagon({"bench", "bag", "--folder", folder, "--write", "1e9"});
  EXPECT_EQ(too_much.status, 2);
  EXPECT_THAT(too_much.err, HasSubstr("GB are needed"));
}

}  // namespace
}  // namespace bw::test
