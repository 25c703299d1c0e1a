// Snapshots: what they begin and end with, and what happens when the disk does not play along. Times are
// those recorded.
#include "runtime/recording/bag/flight_recorder.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <gmock/gmock.h>
#include <std_msgs/msg/float64.hpp>
#include <unistd.h>

#include "runtime/host/actor.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {
namespace {

using std_msgs::msg::Float64;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr Time kStart{1'000'000'000'000};

/// Three outputs of one component, in virtual time of 0.1 s a message.
class Talker {
 public:
  Talker() {
    actor_.name = "talker";
    const MessageType type{MessageTraits<Float64>::ros_name, MessageTraits<Float64>::dds_name,
                           MessageTraits<Float64>::type_hash};
    for (OutputEnd* end : {&value, &alarm, &map}) end->type = type;
  }
  std::vector<const OutputEnd*> outputs() const { return {&value, &alarm, &map}; }
  static std::vector<std::uint8_t> bytes(double number) {
    Float64 message;
    message.data(number);
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    return cdr;
  }
  static Time at(double seconds) { return kStart + Duration::seconds(seconds); }

 private:
  Actor actor_;

 public:
  OutputEnd value{actor_, "/value", {}, Qos::standard(), false};
  OutputEnd alarm{actor_, "/alarm", {}, Qos::standard(), false};
  OutputEnd map{actor_, "/map", {}, Qos::latched(), false};
};

FlightRecorderOptions options(const mcap::Folder& folder) {
  return {.ring = {.keep = Duration::milliseconds(2000)},
          .after = Duration::milliseconds(1000),
          .folder = folder / "misses",
          .events = {{"alarm", "/alarm", {}},
                     {"high", "/value", {{.field = "data", .rule = EventRule::above, .number = 1000.0}}}},
          .waits = true,
          .name_of = [](Time time) { return std::to_string((time - kStart).nanoseconds / 1'000'000); }};
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

/// Topic and seconds of every message, as "/value 1.2".
std::vector<std::string> messages(const Bag& bag) {
  std::vector<std::string> out;
  const auto all = bag.messages({});
  for (BagMessage m; all->next(m) == Step::message;) {
    const auto tenths = (m.log_time - kStart).nanoseconds / 100'000'000;
    out.push_back(bag.topics()[m.topic].name + " " + std::to_string(tenths));
  }
  return out;
}

/// `count` values from tenth `first` on, in between an alarm at the tenths named.
void drive(FlightRecorder& recorder, const Talker& run, int first, int count,
           const std::vector<int>& alarms) {
  for (int tenth = first; tenth < first + count; ++tenth) {
    recorder.on_sample(run.value, Talker::at(0.1 * tenth), Talker::bytes(tenth));
    if (std::ranges::find(alarms, tenth) != alarms.end())
      recorder.on_sample(run.alarm, Talker::at(0.1 * tenth), Talker::bytes(0.0));
  }
}

TEST(FlightRecorder, WritesTheTimeBeforeAndAfterAndTheMapFromLongAgo) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorder recorder(options(folder));
  recorder.describe({.attachments = {{"graph.yaml", "application/yaml", "components:"}},
                     .metadata = {{"bandwagon", {{"seed", "7"}}}}});
  recorder.connect(run.outputs());
  recorder.on_sample(run.map, Talker::at(0.0), Talker::bytes(1.0));
  drive(recorder, run, 1, 49, {});
  EXPECT_TRUE(names_in(folder / "misses").empty()) << "nothing happened yet";
  drive(recorder, run, 50, 50, {50});
  recorder.close();
  ASSERT_THAT(names_in(folder / "misses"), ElementsAre("5000_alarm"));
  const auto bag = open_bag(folder / "misses/5000_alarm");
  EXPECT_TRUE(bag->faults().empty());
  std::vector<std::string> expected = {"/map 30"};  // of 0.0 s, where the bag begins
  for (int tenth = 30; tenth <= 60; ++tenth) {
    expected.push_back("/value " + std::to_string(tenth));
    if (tenth == 50) expected.emplace_back("/alarm 50");
  }
  EXPECT_EQ(messages(*bag), expected);
  EXPECT_EQ(bag->metadata().at("snapshot").at("event"), "alarm");
  EXPECT_EQ(bag->metadata().at("snapshot").at("topic"), "/alarm");
  EXPECT_EQ(bag->metadata().at("snapshot").at("time"), "1005.000");
  EXPECT_EQ(bag->metadata().at("snapshot_result").at("events"), "alarm at 1005.000");
  EXPECT_EQ(bag->metadata().at("bandwagon").at("seed"), "7");
  EXPECT_EQ(bag->attachment("graph.yaml")->size(), 11U);
  EXPECT_THAT(recorder.status().log, ElementsAre(HasSubstr("alarm at 1005.000 s"), HasSubstr("33 messages")));
}

TEST(FlightRecorder, AFurtherEventProlongsAndALaterOneIsABagOfItsOwn) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorder recorder(options(folder));
  recorder.connect(run.outputs());
  drive(recorder, run, 0, 100, {30, 38, 80});
  recorder.close();
  ASSERT_THAT(names_in(folder / "misses"), ElementsAre("3000_alarm", "8000_alarm"));
  // From 1.0 to 4.8 s, with two alarms; the second bag from 6.0 to 9.0 s, with one.
  EXPECT_THAT(messages(*open_bag(folder / "misses/3000_alarm")), SizeIs(39 + 2));
  EXPECT_THAT(messages(*open_bag(folder / "misses/8000_alarm")), SizeIs(31 + 1));
}

TEST(FlightRecorder, AnEventNearTheEndIsWrittenAsFarAsTheRunGoes) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorder recorder(options(folder));
  recorder.connect(run.outputs());
  drive(recorder, run, 0, 52, {50});
  recorder.close();
  EXPECT_EQ(messages(*open_bag(folder / "misses/5000_alarm")).back(), "/value 51");
}

TEST(FlightRecorder, AConditionTriggersOnceAndANameThatIsTakenGetsANumber) {
  const mcap::Folder folder;
  std::filesystem::create_directories(folder / "misses/200000_high");
  const Talker run;
  FlightRecorder recorder(options(folder));
  recorder.connect(run.outputs());
  for (const double number : {1.0, 1500.0, 1600.0})
    recorder.on_sample(run.value, Talker::at(200.0), Talker::bytes(number));
  recorder.close();
  EXPECT_THAT(names_in(folder / "misses"), ElementsAre("200000_high", "200000_high_2"));
  EXPECT_EQ(recorder.take_events(), std::vector<std::string>{"high"});
}

TEST(FlightRecorder, WritesNoMoreThanAllowedAndCountsTheRest) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorderOptions few = options(folder);
  few.most = 2;
  FlightRecorder recorder(few);
  recorder.connect(run.outputs());
  drive(recorder, run, 0, 400, {50, 150, 250, 350});
  recorder.close();
  EXPECT_THAT(names_in(folder / "misses"), ElementsAre("15000_alarm", "5000_alarm"));
  EXPECT_EQ(recorder.status().unwritten, 2U);
}

TEST(FlightRecorder, ADiskThatFailsEndsASnapshotAndTheNextOneTriesAnew) {
  class FullDisk final : public ByteSink {
   public:
    void write(BytesView) override { throw std::system_error(ENOSPC, std::generic_category(), "disk"); }
    void sync() override {}
    std::uint64_t size() const override { return 0; }
  };
  const mcap::Folder folder;
  const Talker run;
  FlightRecorderOptions first_fails = options(folder);
  int files = 0;
  first_fails.writer.create = [&files](const std::filesystem::path& path) -> std::unique_ptr<ByteSink> {
    if (files++ == 0) return std::make_unique<FullDisk>();
    return create_file(path);
  };
  FlightRecorder recorder(first_fails);
  recorder.connect(run.outputs());
  drive(recorder, run, 0, 60, {50});
  EXPECT_THAT(recorder.status().error, HasSubstr("No space left"));
  EXPECT_THAT(recorder.status().log, ElementsAre(HasSubstr("ended early")));
  drive(recorder, run, 60, 60, {90});
  recorder.close();
  EXPECT_TRUE(recorder.status().error.empty());
  EXPECT_THAT(messages(*open_bag(folder / "misses/9000_alarm")), SizeIs(31 + 1));
}

// Linux takes no name longer than 255 bytes, and refuses to look whether it is there. In lock-step that was
// thrown to whoever wrote the message, and in real time it ended the process.
TEST(FlightRecorder, ANameThatCannotBeLookedForEndsTheSnapshotAlone) {
  const mcap::Folder folder;
  const Talker run;
  for (const bool waits : {true, false}) {
    FlightRecorderOptions long_name = options(folder);
    long_name.waits = waits;
    long_name.events.front().name = std::string(300, 'a');
    FlightRecorder recorder(long_name);
    recorder.connect(run.outputs());
    drive(recorder, run, 0, 60, {50});
    recorder.close();
    EXPECT_THAT(recorder.status().error, HasSubstr("File name too long")) << waits;
  }
  EXPECT_TRUE(names_in(folder / "misses").empty());
}

TEST(FlightRecorder, OnAThreadOfItsOwnItWritesTheSame) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorderOptions own_thread = options(folder);
  own_thread.waits = false;
  FlightRecorder recorder(own_thread);
  recorder.connect(run.outputs());
  recorder.on_sample(run.map, Talker::at(0.0), Talker::bytes(1.0));
  drive(recorder, run, 1, 99, {50});
  recorder.close();
  const auto bag = open_bag(folder / "misses/5000_alarm");
  EXPECT_THAT(messages(*bag), SizeIs(1 + 31 + 1));
  EXPECT_EQ(bag->metadata().at("snapshot_result").at("lost"), "0");
}

TEST(FlightRecorder, IsTriggeredFromOutside) {
  const mcap::Folder folder;
  const Talker run;
  FlightRecorder recorder(options(folder));
  recorder.connect(run.outputs());
  drive(recorder, run, 0, 50, {});
  recorder.trigger("bumper");
  drive(recorder, run, 50, 50, {});
  recorder.close();
  // At the first message behind it, 5.0 s.
  EXPECT_THAT(names_in(folder / "misses"), ElementsAre("5000_bumper"));
  EXPECT_THAT(messages(*open_bag(folder / "misses/5000_bumper")), SizeIs(31));
  EXPECT_TRUE(recorder.take_events().empty()) << "others are told of what messages told";
}

}  // namespace
}  // namespace bw::bag
