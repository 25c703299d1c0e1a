// A log of one's own from its tables to the error of the pose: two commands, no C++.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

class ImportRun : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static Outcome bandwagon(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
    return run_to_end(arguments, std::chrono::seconds(120));
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Straight on along x at 0.5 m/s for 8 s; the reference runs beside it, 0.5 m to the left.
  void write_log() const {
    std::string wheels;
    std::string reference;
    for (int i = 0; i <= 160; ++i) wheels += fmt::format("{} {} 0 0 500\n", 50 * i, 25 * i);
    for (int i = 0; i <= 80; ++i) reference += fmt::format("{};{};0.5;90\n", 0.1 * i, 0.05 * i);
    write("wheels.txt", wheels);
    write("reference.csv", "s;x;y;bearing\n" + reference);
    write("log.yaml", R"(
log: {name: straight, start: 0}
tables:
  - file: wheels.txt
    separator: whitespace
    columns: [t, x, y, heading, v]
    stamp: {column: t, unit: ms}
    messages:
      - topic: /odom
        type: nav_msgs/msg/Odometry
        fields:
          pose.pose.position.x: {column: x, unit: mm}
          pose.pose.position.y: {column: y, unit: mm}
          pose.pose.orientation.yaw: {column: heading, unit: deg}
          twist.twist.linear.x: {column: v, unit: mm/s}
  - file: reference.csv
    separator: semicolon
    header: true
    stamp: {column: s}
    messages:
      - topic: /ground_truth
        type: geometry_msgs/msg/PoseStamped
        fields:
          pose.position.x: x
          pose.position.y: y
          pose.orientation.yaw: {column: bearing, unit: deg, zero: north, turning: clockwise}
)");
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  ("import_run_" + std::to_string(getpid()) +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ImportRun, ALogOfOnesOwnTellsTheErrorOfThePose) {
  write_log();
  const Outcome import = bandwagon(
      {"bag", "import", folder_.string(), "--columns", file("log.yaml"), "--out", file("log.mcap")});
  ASSERT_EQ(import.status, 0) << import.err;
  EXPECT_THAT(import.out, HasSubstr("wheels.txt: /odom: 161 rows, 161 messages"));
  EXPECT_THAT(import.out, HasSubstr("log.mcap: 242 messages of 2 topics"));
  const Outcome run = bandwagon({"run", BANDWAGON_SOURCE_DIR "/config/graphs/recorded_robot.yaml", "--clock",
                                 "lockstep", "--set", "recorded_robot.bag=" + file("log.mcap"), "--set",
                                 "localization.set_initial_pose=true", "--set",
                                 "localization.publish_when_lost=true", "--json", file("card.json")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("plays straight"));
  EXPECT_THAT(run.out, HasSubstr("Run over: the bag is over; 4.00 m in"));
  EXPECT_THAT(
      run.out,
      HasSubstr("Localization off by 0.500 m on average, 0.500 m and 0.0000 rad rms, 0.500 m at most"));
  const nlohmann::json card = nlohmann::json::parse(std::ifstream(file("card.json")));
  EXPECT_NEAR(card["localization"]["mean_m"].get<double>(), 0.5, 1e-6);
  EXPECT_GT(card["localization"]["poses"].get<int>(), 150);  // of 160 steps
}

TEST_F(ImportRun, AnImportThatIsRefusedLeavesNothing) {
  write_log();
  write("wheels.txt", "0 0 0 0 500\n50 25 0 x 500\n");
  const Outcome import = bandwagon(
      {"bag", "import", folder_.string(), "--columns", file("log.yaml"), "--out", file("log.mcap")});
  EXPECT_EQ(import.status, 2);
  EXPECT_THAT(import.err, HasSubstr("wheels.txt:2: column 4 (heading) = 'x': is no finite number"));
  EXPECT_FALSE(std::filesystem::exists(file("log.mcap")));
}

TEST_F(ImportRun, TheReportIsJsonForScripts) {
  write_log();
  const Outcome import = bandwagon({"bag", "import", file("wheels.txt"), file("reference.csv"), "--columns",
                                    file("log.yaml"), "--out", file("bag"), "--json"});
  ASSERT_EQ(import.status, 0) << import.err;
  const nlohmann::json json = nlohmann::json::parse(import.out);
  EXPECT_EQ(json["log"]["name"], "straight");
  EXPECT_EQ(json["messages"], 242);
  EXPECT_EQ(json["tables"][0]["rows"], 161);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bag/metadata.yaml"));
}

}  // namespace
}  // namespace bw::test
