// Bags that are not quite ours, in the program's hands: messages that are none and types that are others reach no component,
// and every verb says what it did with them.
#include <filesystem>
#include <functional>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "runtime/bag/bag.hpp"
#include "runtime/bag/bag_writer.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";

Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, std::chrono::seconds(120));
}

/// The first 3 s of the hallway, and copies of them in which something of /scan is not as it was.
class ForeignBag : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / "foreign_bag";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    const Outcome run =
        bandwagon({"run", kGraph, "--clock", "lockstep", "--for", "3", "--record", folder_ / "drive.mcap"});
    ASSERT_EQ(run.status, 1) << run.err;  // 3 s are too few for the goal
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static void copy(const std::string& name, const std::function<void(bag::BagTopic&)>& on_scan,
                   const std::function<void(bag::Bytes&, int number)>& on_message) {
    const auto from = bag::open_bag(folder_ / "drive.mcap");
    bag::BagWriter to(folder_ / name, {});
    for (bag::BagTopic topic : from->topics()) {
      if (topic.name == "/scan") on_scan(topic);
      to.add_topic(topic);
    }
    for (const auto& [record, entries] : from->metadata()) {
      if (record != "rosbag2") to.add_metadata(record, entries);
    }
    const auto messages = from->messages({});
    int number = 0;
    for (bag::BagMessage m; messages->next(m) == bag::Step::message;) {
      bag::Bytes data(m.data.begin(), m.data.end());
      if (from->topics()[m.topic].name == "/scan") on_message(data, number++);
      to.write(m.topic, m.log_time, m.publish_time, data);
    }
    to.close();
  }
  static Outcome replay(const std::string& name) {
    return bandwagon({"replay", folder_ / name, "--graph", kGraph, "--run", "people"});
  }
  static nlohmann::json scan_of(const std::string& verb, const std::string& name) {
    const Outcome outcome = bandwagon({"bag", verb, folder_ / name, "--json"});
    const nlohmann::json said = nlohmann::json::parse(outcome.out);
    for (const auto& topic : said["topics"]) {
      if (topic["name"] == "/scan") return topic;
    }
    return nullptr;
  }
  static std::filesystem::path folder_;
};

std::filesystem::path ForeignBag::folder_;

TEST_F(ForeignBag, ItselfIsReplayedWithoutAWord) {
  const Outcome outcome = replay("drive.mcap");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("note")));
}

TEST_F(ForeignBag, AMessageThatIsNoneReachesNobody) {
  copy(
      "cut.mcap", [](bag::BagTopic&) {},
      [](bag::Bytes& data, int number) {
        if (number == 10) data.resize(data.size() / 2);
      });
  const Outcome outcome = replay("cut.mcap");
  // The tracker misses one sweep, and nothing else: another verdict than equal, and no crash.
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1 messages of the bag do not fit their type"));
  EXPECT_EQ(scan_of("check", "cut.mcap")["malformed"], 1);
}

TEST_F(ForeignBag, ATypeOfOtherFieldsIsNotPlayed) {
  copy(
      "other.mcap",
      [](bag::BagTopic& scan) {
        scan.type_hash.clear();
        scan.schema_text.replace(scan.schema_text.find("float32 scan_time"), 17, "int32 scan_time");
      },
      [](bag::Bytes&, int) {});
  const std::string difference =
      "the bag's schema has int32 scan_time where this build has float32 scan_time";
  const Outcome outcome = replay("other.mcap");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("/scan is not played: " + difference));
  EXPECT_EQ(scan_of("check", "other.mcap")["not_decoded"], difference);
  EXPECT_EQ(scan_of("info", "other.mcap")["not_decoded"], difference);
}

}  // namespace
}  // namespace bw::test
