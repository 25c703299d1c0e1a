// Bags that are not quite ours, in the program's hands: messages that are none and types that are others
// reach no component, and every verb says what it did with them.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
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

/// The first 5 s of the hallway, and copies of them in which something of /scan is not as it was.
class ForeignBag : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() / "foreign_bag";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    const Outcome run =
        bandwagon({"run", kGraph, "--clock", "lockstep", "--for", "5", "--record", folder_ / "drive.mcap"});
    ASSERT_EQ(run.status, 1) << run.err;  // 5 s are too few for the goal
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
  struct Message {
    std::string topic;
    std::size_t number_of_topic;
    Time log_time;
    Time publish_time;
    bag::Bytes data;
  };
  /// As the recorder of another system would have it in real time: nothing about a clock, a build, or who
  /// wrote what; and what `change` makes of the order in which it heard the messages.
  static void as_others_record(const std::string& name,
                               const std::function<void(std::vector<Message>&)>& change) {
    const auto from = bag::open_bag(folder_ / "drive.mcap");
    bag::BagWriter to(folder_ / name, {});
    for (bag::BagTopic topic : from->topics()) {
      topic.writer.clear();
      to.add_topic(topic);
    }
    std::vector<Message> all;
    const auto messages = from->messages({});
    for (bag::BagMessage m; messages->next(m) == bag::Step::message;)
      all.push_back({from->topics()[m.topic].name, m.topic, m.log_time, m.publish_time,
                     bag::Bytes(m.data.begin(), m.data.end())});
    change(all);
    for (const Message& m : all) to.write(m.number_of_topic, m.log_time, m.publish_time, m.data);
    to.close();
  }
  /// The message of a topic nearest to so many seconds behind the beginning.
  static std::vector<Message>::iterator nearest(std::vector<Message>& all, const std::string& topic,
                                                double seconds) {
    const Time wanted = all.front().log_time + Duration::seconds(seconds);
    const auto off = [&](const Message& m) {
      return m.topic == topic ? std::abs((m.log_time - wanted).nanoseconds)
                              : std::numeric_limits<std::int64_t>::max();
    };
    return std::ranges::min_element(all, {}, off);
  }
  /// The verdict in words, and as JSON.
  static std::pair<Outcome, nlohmann::json> costmap_again(const std::string& name,
                                                          std::vector<std::string> more = {}) {
    const std::filesystem::path json = folder_ / "verdict.json";
    std::vector<std::string> arguments = {"replay", folder_ / name,  "--graph", kGraph,
                                          "--run",  "local_costmap", "--json",  json};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = bandwagon(arguments);
    return {outcome, nlohmann::json::parse(std::ifstream(json))};
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

TEST_F(ForeignBag, OfRealTimeSaysThatItHasNoOrderOfInputs) {
  as_others_record("foreign.mcap", [](std::vector<Message>&) {});
  const auto [outcome, verdict] = costmap_again("foreign.mcap");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("it does not say in which order inputs were taken"));
  EXPECT_TRUE(verdict["input_order"].is_null());
}

// In the hallway the costmap takes a sweep in at its own tick 10 ms later, with the tracks that were made of
// that sweep. A recorder that hears one set of tracks 12 ms after the sweep has people of the sweep before
// there.
TEST_F(ForeignBag, SaysWhichOtherOrderOfInputsMakesItEqual) {
  Time scan_at, tracks_at, start;
  as_others_record("shuffled.mcap", [&](std::vector<Message>& all) {
    start = all.front().log_time;
    scan_at = nearest(all, "/scan", 4.0)->log_time;
    const auto tracks = nearest(all, "/tracks", 4.0);
    ASSERT_EQ(tracks->log_time, scan_at);
    tracks_at = tracks->log_time = scan_at + Duration::milliseconds(12);
    std::ranges::stable_sort(all, {}, &Message::log_time);
  });
  const auto [outcome, verdict] = costmap_again("shuffled.mcap");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  const auto text = [&](Time time) { return fmt::format("{:.6f} s", (time - start).to_seconds()); };
  EXPECT_THAT(outcome.out,
              HasSubstr("  equal there when /scan at " + text(scan_at) + " is taken after /tracks at " +
                        text(tracks_at) +
                        " (12.000 ms apart in the bag)\n"
                        "order of inputs: with that order everything is equal; it is not the code\n"));
  const nlohmann::json order = verdict["input_order"];
  ASSERT_TRUE(order.is_object()) << outcome.out;
  EXPECT_TRUE(order["left"].is_null());
  ASSERT_EQ(order["equal_when"].size(), 1U) << order.dump(2);
  EXPECT_EQ(order["equal_when"][0]["input"]["topic"], "/scan");
  EXPECT_EQ(order["equal_when"][0]["after"]["topic"], "/tracks");
}

TEST_F(ForeignBag, SaysWhenTheRecorderDidNotHearWhatAnOutputAnswers) {
  as_others_record("unheard.mcap", [](std::vector<Message>& all) {
    all.erase(nearest(all, "/scan", 4.0));
    // Heard at other times than their stamps, those without a stamp first.
    for (Message& m : all) {
      if (m.topic == "/leg_detections") m.log_time = m.log_time + Duration::milliseconds(2);
      if (m.topic == "/tracks" || m.topic == "/people") m.log_time = m.log_time + Duration::milliseconds(3);
    }
    std::ranges::stable_sort(all, {}, &Message::log_time);
  });
  const Outcome outcome = replay("unheard.mcap");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  // A sweep is answered with its stamp; virtual time begins at 1000 s.
  EXPECT_THAT(outcome.out,
              HasSubstr("order of inputs: the bag lacks the input of its stamp, 1004.000000000 s"));
}

TEST_F(ForeignBag, SaysThatNoOrderOfInputsMakesOtherParametersEqual) {
  as_others_record("same.mcap", [](std::vector<Message>&) {});
  const auto [outcome, verdict] = costmap_again("same.mcap", {"--set", "local_costmap.inflation_radius=0.3"});
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr(" tried: none makes it equal"));
  EXPECT_EQ(verdict["input_order"]["equal_when"].size(), 0U);
  EXPECT_GE(verdict["input_order"]["tried"], 1);
}

}  // namespace
}  // namespace bw::test
