// `bandwagon replay BAG...` as topics: names, bytes, offers, order, what late readers get, the clock, the
// keys.
#include <array>

#include <gmock/gmock.h>
#include <rosgraph_msgs/msg/clock.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "runtime/stamps.hpp"
#include "tests/interop/bags_on_the_wire.hpp"
#include "tests/interop/on_terminal.hpp"

namespace bw::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Time kStart{1'000'000'000'000};

Bytes transform(const std::string& child) {
  tf2_msgs::msg::TFMessage message;
  message.transforms().emplace_back().child_frame_id(child);
  Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

/// A bag in the making; times in milliseconds from its beginning.
class NewBag {
 public:
  explicit NewBag(const std::filesystem::path& path) : writer_(path, {}) {}
  ~NewBag() { writer_.close(); }
  NewBag(const NewBag&) = delete;
  NewBag& operator=(const NewBag&) = delete;

  std::size_t topic(const std::string& name, const std::string& type, const Qos& qos = Qos::standard()) {
    return writer_.add_topic({.name = name, .type = type, .offered_qos_profiles = bag::to_qos_text({qos})});
  }
  void write(std::size_t topic, std::int64_t ms, const Bytes& cdr) {
    const Time time = kStart + Duration::milliseconds(ms);
    writer_.write(topic, time, time, cdr);
  }

 private:
  bag::BagWriter writer_;
};

/// Everything that a reader of the test has received so far.
class Ear {
 public:
  Ear(dds::Participant& participant, const std::string& topic, const std::string& type, const Qos& qos)
      : reader_(participant.create_reader(endpoint(topic, type, qos), [] {})) {}
  const std::vector<Bytes>& heard() {
    for (dds::Sample sample; reader_->take(sample);) heard_.push_back(sample.cdr);
    return heard_;
  }

 private:
  std::unique_ptr<dds::Reader> reader_;
  std::vector<Bytes> heard_;
};

TEST(ReplayTopics, WhatIsPlayedAndRecordedAgainIsTheSame) {
  const Folder folder;
  {
    NewBag bag(folder / "first");
    const std::array topics = {
        bag.topic("/chatter", "std_msgs/msg/String"), bag.topic("/scan", "odd_msgs/msg/Scan", Qos::sensor()),
        bag.topic("/map", "std_msgs/msg/String", Qos::latched()), bag.topic("/odd", "odd_msgs/msg/Thing")};
    // A message of the next topic every 3 ms, for 0.9 s.
    for (std::size_t i = 0; i < 300; ++i) {
      const bool is_text = i % 2 == 0;
      bag.write(topics.at(i % 4), static_cast<std::int64_t>(3 * i),
                is_text ? text(std::string(i, 't')) : unknown(4 * i, static_cast<std::uint8_t>(i)));
    }
  }
  Running recorder({"record", "--all", "--out", folder / "second"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  const Outcome player =
      bandwagon({"replay", folder / "first", "--wait-for", "/chatter", "/scan", "/map", "/odd"});
  EXPECT_EQ(player.status, 0) << player.err;
  EXPECT_THAT(player.out, HasSubstr("300 messages of 4 topics"));
  EXPECT_EQ(recorder.stop().status, 0);
  EXPECT_EQ(messages_of(folder / "second"), messages_of(folder / "first")) << "bytes and order";
  const auto second = bag::open_bag(folder / "second");
  for (const bag::BagTopic& topic : second->topics()) {
    const auto offered = bag::from_qos_text(topic.offered_qos_profiles).front();
    EXPECT_EQ(offered.reliability == Reliability::best_effort, topic.name == "/scan") << topic.name;
    EXPECT_EQ(offered.durability == Durability::transient_local, topic.name == "/map") << topic.name;
    if (topic.type == "std_msgs/msg/String") {
      EXPECT_EQ(topic.type_hash, kStringHash);
    }
  }
}

TEST(ReplayTopics, WhoComesLateGetsEveryStaticTransformFromBeforeTheStart) {
  const Folder folder;
  {
    NewBag bag(folder / "drive.mcap");
    const auto tf_static = bag.topic("/tf_static", "tf2_msgs/msg/TFMessage", Qos::latched());
    const auto map = bag.topic("/map", "std_msgs/msg/String", Qos::latched());
    const auto text_topic = bag.topic("/text", "std_msgs/msg/String");
    bag.write(tf_static, 0, transform("laser"));
    bag.write(tf_static, 10, transform("imu"));
    bag.write(map, 20, text("old map"));
    bag.write(map, 30, text("map"));
    for (std::int64_t i = 0; i < 6000; ++i) bag.write(text_topic, 100 + 10 * i, text("tick"));
  }
  dds::Participant participant(local());
  Ear ticks(participant, "/text", "std_msgs/msg/String", Qos::standard());
  Running player({"replay", folder / "drive.mcap", "--start", "3", "--wait-for", "/text"});
  ASSERT_TRUE(eventually([&] { return !ticks.heard().empty(); })) << player.process().err();
  // It plays; only now somebody wants to know where the laser is.
  dds::Participant late(local());
  Ear transforms(late, "/tf_static", "tf2_msgs/msg/TFMessage", Qos::tf_static());
  Ear map(late, "/map", "std_msgs/msg/String", Qos::latched());
  EXPECT_TRUE(eventually([&] { return transforms.heard().size() == 2 && map.heard().size() == 1; }));
  ASSERT_EQ(transforms.heard().size(), 2U);
  const auto same = [](Bytes cdr, const Bytes& expected) {
    cdr.resize(expected.size());  // DDS pads
    return cdr == expected;
  };
  EXPECT_TRUE(same(transforms.heard()[0], transform("laser")));
  EXPECT_TRUE(same(transforms.heard()[1], transform("imu")));
  EXPECT_TRUE(same(map.heard().at(0), text("map")));
  const Outcome outcome = player.stop();
  EXPECT_EQ(outcome.status, 1) << "interrupted";
  EXPECT_THAT(outcome.out, HasSubstr("3 from before the start"));
}

TEST(ReplayTopics, SeveralBagsGoByTheirTimesUnderOtherNames) {
  const Folder folder;
  for (const auto& [name, first] : {std::pair("even.mcap", 0), std::pair("odd.mcap", 1)}) {
    NewBag bag(folder / name);
    const auto topic = bag.topic(std::string("/") + (first == 0 ? "even" : "odd"), "std_msgs/msg/String");
    const auto noise = bag.topic("/noise", "std_msgs/msg/String");
    for (int i = first; i < 8; i += 2) {
      bag.write(topic, i, text(std::to_string(i)));
      bag.write(noise, i, text("noise"));
    }
  }
  dds::Participant participant(local());
  Ear numbers(participant, "/numbers", "std_msgs/msg/String", Qos::standard(100));
  Ear noise(participant, "/noise", "std_msgs/msg/String", Qos::standard(100));
  const Outcome player =
      bandwagon({"replay", folder / "even.mcap", folder / "odd.mcap", "--remap", "/even:=/numbers", "--remap",
                 "/odd:=/numbers", "--exclude", "noise", "--duration", "0.006", "--wait-for", "/numbers"});
  EXPECT_EQ(player.status, 0) << player.err;
  std::vector<std::string> texts;
  for (const Bytes& cdr : numbers.heard()) {
    std_msgs::msg::String message;
    ASSERT_TRUE(deserialize(cdr, message));
    texts.push_back(message.data());
  }
  EXPECT_THAT(texts, ElementsAre("0", "1", "2", "3", "4", "5")) << "6 and 7 lie beyond the 6 ms";
  EXPECT_TRUE(noise.heard().empty());
}

TEST(ReplayTopics, TheClockIsTheBagsAndTheRecordedOneIsNotPlayed) {
  const Folder folder;
  {
    NewBag bag(folder / "drive.mcap");
    const auto clock = bag.topic("/clock", "rosgraph_msgs/msg/Clock");
    const auto text_topic = bag.topic("/text", "std_msgs/msg/String");
    rosgraph_msgs::msg::Clock wrong;
    wrong.clock(to_stamp({1}));
    Bytes cdr;
    serialize(wrong, cdr);
    for (std::int64_t i = 0; i <= 100; ++i) {
      bag.write(clock, 10 * i, cdr);
      bag.write(text_topic, 10 * i, text("tick"));
    }
  }
  dds::Participant participant(local());
  Ear clock(participant, "/clock", "rosgraph_msgs/msg/Clock", Qos::standard(1000));
  const Outcome player =
      bandwagon({"replay", folder / "drive.mcap", "--clock", "100", "--rate", "2", "--wait-for", "/clock"});
  EXPECT_EQ(player.status, 0) << player.err;
  EXPECT_THAT(player.out, HasSubstr("101 messages of 1 topics"));
  // 1 s of the bag at rate 2 is 0.5 s: ticks at 0, 10, ..., 500 ms, fewer where the machine was late.
  ASSERT_GE(clock.heard().size(), 2U);
  EXPECT_LE(clock.heard().size(), 51U);
  Time last = kStart;
  for (const Bytes& bytes : clock.heard()) {
    rosgraph_msgs::msg::Clock message;
    ASSERT_TRUE(deserialize(bytes, message));
    const Time time = from_stamp(message.clock());
    EXPECT_GE(time, last);
    last = time;
  }
  EXPECT_GT(last, kStart);
}

TEST(ReplayTopics, AMessageThatIsNoneIsCountedAndLeftOut) {
  const Folder folder;
  {
    NewBag bag(folder / "drive.mcap");
    const auto topic = bag.topic("/text", "std_msgs/msg/String");
    bag.write(topic, 0, text("sound"));
    bag.write(topic, 1, Bytes{0, 1, 0, 0, 200, 0, 0, 0, 'x'});  // claims 200 characters
    bag.write(topic, 2, text("sound too"));
  }
  dds::Participant participant(local());
  Ear texts(participant, "/text", "std_msgs/msg/String", Qos::standard());
  const Outcome player = bandwagon({"replay", folder / "drive.mcap", "--rate", "0", "--wait-for", "/text"});
  EXPECT_EQ(player.status, 0) << player.err;
  EXPECT_THAT(player.out, HasSubstr("1 messages do not fit their type"));
  EXPECT_EQ(texts.heard().size(), 2U);
}

TEST(ReplayTopics, KeysPauseStepAndChangeTheRateAndTheTerminalIsLeftAsItWas) {
  const Folder folder;
  {
    NewBag bag(folder / "slow.mcap");
    const auto topic = bag.topic("/text", "std_msgs/msg/String");
    // An hour between two messages: what comes earlier, a key brought.
    for (std::int64_t i = 0; i < 5; ++i) bag.write(topic, 3'600'000 * i, text(std::to_string(i)));
  }
  dds::Participant participant(local());
  Ear texts(participant, "/text", "std_msgs/msg/String", Qos::standard());
  OnTerminal player({"replay", folder / "slow.mcap", "--pause", "--wait-for", "/text"});
  ASSERT_TRUE(player.shows("paused")) << player.out();
  EXPECT_FALSE(player.is_ordinary());
  EXPECT_TRUE(texts.heard().empty());
  player.press("\x1b[C");
  EXPECT_TRUE(eventually([&] { return texts.heard().size() == 1; })) << player.out();
  player.press("n");
  EXPECT_TRUE(eventually([&] { return texts.heard().size() == 2; })) << player.out();
  EXPECT_TRUE(player.shows("3600.0 / 14400.0 s"));
  player.press("\x1b[A");
  EXPECT_TRUE(player.shows("rate 1.1"));
  player.press("\x1b[B");
  player.press("\x1b[B");
  EXPECT_TRUE(player.shows("rate 0.9"));
  player.forget();
  player.press(" ");
  EXPECT_TRUE(player.shows("2 messages\x1b")) << "no longer paused";
  EXPECT_EQ(texts.heard().size(), 2U);
  player.end();
  EXPECT_EQ(player.status(), 1) << player.out();
  EXPECT_TRUE(player.is_ordinary());
}

TEST(ReplayTopics, OptionsThatDoNotBelongTogetherAreRefused) {
  const Folder folder;
  {
    NewBag bag(folder / "a.mcap");
    bag.write(bag.topic("/text", "std_msgs/msg/String"), 0, text("x"));
  }
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), {"replay", folder / "a.mcap"});
    const Outcome outcome = bandwagon(arguments);
    EXPECT_EQ(outcome.status, 2) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refused({"--pause"}, "--pause needs a terminal");
  refused({"--graph", "g.yaml", "--run", "x", "--rate", "2"}, "--rate is for a replay as topics");
  refused({"--graph", "g.yaml"}, "--graph and --run go together");
  refused({folder / "a.mcap", "--graph", "g.yaml", "--run", "x"}, "is too many");
  refused({"--set", "a.b=1"}, "--set is for a replay as the truth");
  refused({"--clock", "lockstep"}, "without --graph it is how often /clock is published");
  refused({"--graph", "g.yaml", "--run", "x", "--clock", "40"}, "with --graph the clock is lockstep");
  refused({"--start", "1"}, "lies behind the bag's end");
  refused({"--wait-for", "/txt"}, "--wait-for /txt: unknown topic");
  refused({"--topics", "/txt"}, "did you mean '/text'");
  refused({"--remap", "/text=/b"}, "must be /recorded:=/played");
}

}  // namespace
}  // namespace bw::test
