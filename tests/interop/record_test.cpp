// `bandwagon record` beside writers of others: what they sent is what the bag holds, byte by byte, whatever
// they offer and whether the type is known or not.
#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <gmock/gmock.h>
#include <rosgraph_msgs/msg/clock.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "runtime/ros/node_announcement.hpp"
#include "runtime/stamps.hpp"
#include "tests/interop/bags_on_the_wire.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;
using testing::Not;

Bytes scan(std::int64_t stamp_ns, std::size_t beams) {
  sensor_msgs::msg::LaserScan message;
  message.header().stamp(to_stamp({stamp_ns}));
  message.ranges().assign(beams, 1.5F);
  Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

const bag::BagTopic& topic_of(const bag::Bag& recording, std::string_view name) {
  const auto found = std::ranges::find(recording.topics(), name, &bag::BagTopic::name);
  if (found == recording.topics().end()) throw std::runtime_error("the bag has no " + std::string(name));
  return *found;
}

std::vector<Recorded> of_topic(const std::string& topic, const std::vector<Bytes>& all) {
  std::vector<Recorded> out;
  for (const Bytes& cdr : all) out.push_back({topic, cdr});
  return out;
}

TEST(Record, EverySampleIsInTheBagAsItWasSent) {
  const Folder folder;
  Running recorder({"record", "--all", "--exclude", "^/not", "--out", folder / "all"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  // All of this appears while it records.
  dds::Participant participant(local());
  NodeAnnouncement talker(participant, "talker", RosDistro::jazzy);
  const auto open = [&](const dds::EndpointOptions& options) {
    auto writer = participant.create_writer(options);
    talker.add(*writer);
    return writer;
  };
  const std::string other_hash = "RIHS01_" + std::string(64, 'f');
  const auto chatter = open(endpoint("/chatter", "std_msgs/msg/String", Qos::standard(100), kStringHash));
  const auto laser = open(endpoint("/scan", "sensor_msgs/msg/LaserScan", Qos::sensor()));
  const auto odd = open(endpoint("/odd", "odd_msgs/msg/Thing", Qos::standard(100), "RIHS01_77"));
  const auto foreign = open(endpoint("/foreign", "std_msgs/msg/String", Qos::standard(100), other_hash));
  const auto hidden = open(endpoint("/a/_hidden", "std_msgs/msg/String", Qos::standard(), kStringHash));
  const auto excluded = open(endpoint("/not_this", "std_msgs/msg/String", Qos::standard(), kStringHash));
  talker.publish();
  for (const auto* writer : {&chatter, &laser, &odd, &foreign}) ASSERT_TRUE(is_matched(**writer));

  std::vector<Bytes> chatter_sent, laser_sent, odd_sent, foreign_sent;
  constexpr std::int64_t kStamp = 1'000'000'007;
  for (std::size_t i = 0; i < 50; ++i) {
    chatter_sent.push_back(text(std::string(i, 'c')));  // lengths that DDS pads
    laser_sent.push_back(scan(kStamp + static_cast<std::int64_t>(i), i));
    odd_sent.push_back(unknown(4 * i, static_cast<std::uint8_t>(i)));
    foreign_sent.push_back(text(std::string(4 * i + 3, 'f')));  // and ones that it does not
    laser->write(laser_sent.back());
    odd->write(odd_sent.back());
    foreign->write(foreign_sent.back());
    hidden->write(chatter_sent.back());
    excluded->write(chatter_sent.back());
    chatter->write(chatter_sent.back());
  }
  for (const auto* writer : {&odd, &foreign, &chatter})
    ASSERT_TRUE((*writer)->wait_until_received(Duration::milliseconds(10'000)));
  const Outcome outcome = recorder.stop();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("4 topics | 200 messages"));
  EXPECT_THAT(outcome.out, HasSubstr("dropped 0 | lost 0"));

  const auto path = folder / "all";
  EXPECT_EQ(messages_of(path, "/chatter"), of_topic("/chatter", chatter_sent));
  EXPECT_EQ(messages_of(path, "/scan"), of_topic("/scan", laser_sent));
  EXPECT_EQ(messages_of(path, "/odd"), of_topic("/odd", odd_sent));
  EXPECT_EQ(messages_of(path, "/foreign"), of_topic("/foreign", foreign_sent));
  EXPECT_EQ(messages_of(path).size(), 200U) << "nothing hidden, nothing excluded, nothing of its own";

  const auto recording = bag::open_bag(path);
  const bag::BagTopic& known = topic_of(*recording, "/chatter");
  EXPECT_EQ(known.writer, "talker");
  EXPECT_EQ(known.schema_encoding, "ros2msg");
  EXPECT_THAT(known.schema_text, HasSubstr("string data"));
  EXPECT_EQ(known.type_hash, kStringHash);
  const bag::BagTopic& unknown_type = topic_of(*recording, "/odd");
  EXPECT_EQ(unknown_type.type, "odd_msgs/msg/Thing");
  EXPECT_EQ(unknown_type.schema_encoding, "unknown");
  EXPECT_EQ(unknown_type.schema_text, "");
  EXPECT_EQ(unknown_type.type_hash, "RIHS01_77");
  // Packages change between distributions: a String of another hash is not ours.
  EXPECT_EQ(topic_of(*recording, "/foreign").schema_encoding, "unknown");
  EXPECT_EQ(topic_of(*recording, "/foreign").type_hash, other_hash);
  const auto offered = bag::from_qos_text(topic_of(*recording, "/scan").offered_qos_profiles);
  ASSERT_EQ(offered.size(), 1U);
  EXPECT_EQ(offered.front().reliability, Reliability::best_effort);

  bag::BagMessage m;
  std::int64_t stamp = kStamp;
  const auto all = recording->messages({});
  while (all->next(m) == bag::Step::message) {
    const std::string& name = recording->topics()[m.topic].name;
    if (name == "/scan") {
      EXPECT_EQ(m.publish_time.nanoseconds, stamp++) << "its own stamp";
    } else {
      // When it was sent, by the clock of the system, and it came after that.
      EXPECT_LE(m.publish_time, m.log_time);
      EXPECT_GT(m.publish_time, m.log_time - Duration::milliseconds(60'000));
    }
  }
  const auto metadata = recording->metadata().at("bandwagon");
  for (const char* key : {"version", "build_id", "cpu", "host"}) EXPECT_NE(metadata.at(key), "") << key;
}

TEST(Record, ANodeBringsItsTopicsAlone) {
  const Folder folder;
  Running recorder({"record", "--node", "talker", "--out", folder / "one.mcap"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  dds::Participant participant(local());
  NodeAnnouncement talker(participant, "talker", RosDistro::jazzy);
  NodeAnnouncement other(participant, "other", RosDistro::jazzy);
  const auto wanted =
      participant.create_writer(endpoint("/wanted", "std_msgs/msg/String", Qos::latched(), kStringHash));
  const auto heard =
      participant.create_writer(endpoint("/heard", "std_msgs/msg/String", Qos::latched(), kStringHash));
  const auto unwanted =
      participant.create_writer(endpoint("/x", "std_msgs/msg/String", Qos::latched(), kStringHash));
  const auto ear =
      participant.create_reader(endpoint("/heard", "std_msgs/msg/String", Qos::latched()), [] {});
  for (const auto* writer : {&wanted, &heard, &unwanted}) (*writer)->write(text("hello"));
  talker.add(*wanted);
  talker.add(*ear);
  talker.publish();
  ASSERT_TRUE(is_matched(*wanted));
  ASSERT_TRUE(eventually([&] { return heard->matched_readers() > 1; })) << "the own reader and the recorder";
  for (const auto* writer : {&wanted, &heard})
    ASSERT_TRUE((*writer)->wait_until_received(Duration::milliseconds(10'000)));
  EXPECT_EQ(recorder.stop().status, 0);
  EXPECT_THAT(
      messages_of(folder / "one.mcap"),
      testing::UnorderedElementsAre(Recorded{"/wanted", text("hello")}, Recorded{"/heard", text("hello")}));
}

TEST(Record, ReadersFitEachWritersOffer) {
  const Folder folder;
  dds::Participant participant(local());
  Qos latched = Qos::latched();
  latched.depth = 100;
  const auto map = participant.create_writer(endpoint("/map", "odd_msgs/msg/Map", Qos::latched()));
  const auto strong = participant.create_writer(endpoint("/mixed", "odd_msgs/msg/Thing", latched));
  std::vector<Recorded> sent;
  const auto say = [&](dds::Writer& writer, const std::string& topic, std::size_t size, std::uint8_t first) {
    sent.push_back({topic, unknown(size, first)});
    writer.write(sent.back().cdr);
  };
  // A latched map of 6 MB, in about 100 fragments, and a history of three: before anybody records.
  say(*map, "/map", 6'000'000, 0);
  for (std::uint8_t i = 0; i < 3; ++i) say(*strong, "/mixed", 8, i);
  Running recorder({"record", "map", "mixed", "--out", folder / "offers"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  ASSERT_TRUE(is_matched(*strong));
  ASSERT_TRUE(is_matched(*map));
  const auto weak = participant.create_writer(
      endpoint("/mixed", "odd_msgs/msg/Thing", {.reliability = Reliability::best_effort, .depth = 100}));
  ASSERT_TRUE(is_matched(*weak)) << "a reliable reader alone would never match it";
  ASSERT_TRUE(eventually([&] { return strong->matched_readers() == 2; }))
      << "both readers hear the strong one";
  for (std::uint8_t i = 10; i < 20; ++i) {
    say(*weak, "/mixed", 8, i);
    say(*strong, "/mixed", 8, static_cast<std::uint8_t>(100 + i));
  }
  ASSERT_TRUE(map->wait_until_received(Duration::milliseconds(10'000)));
  ASSERT_TRUE(strong->wait_until_received(Duration::milliseconds(10'000)));
  const Outcome outcome = recorder.stop();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("lost 0"));
  EXPECT_THAT(messages_of(folder / "offers"), testing::UnorderedElementsAreArray(sent)) << "each once";
}

/// T is stopped.
char state_of(const Process& process) {
  std::ifstream file("/proc/" + std::to_string(process.id()) + "/stat");
  std::string id, name, state;
  file >> id >> name >> state;
  return state.empty() ? '?' : state.front();
}

TEST(Record, WhatIsLostOnTheWireIsCounted) {
  const Folder folder;
  dds::Participant participant(local());
  const auto writer = participant.create_writer(endpoint("/load", "odd_msgs/msg/Thing", Qos::standard(1)));
  Running recorder({"record", "/load", "--out", folder / "load.mcap"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  ASSERT_TRUE(is_matched(*writer));
  writer->write(unknown(100'000, 0));
  ASSERT_TRUE(writer->wait_until_received(Duration::milliseconds(10'000)));
  // The recorder stands still while 20 MB are written, five times of what its sockets hold; the writer keeps
  // the last one only.
  recorder.process().signal(SIGSTOP);
  ASSERT_TRUE(eventually([&] { return state_of(recorder.process()) == 'T'; }));
  for (std::uint8_t i = 1; i <= 200; ++i) writer->write(unknown(100'000, i));
  recorder.process().signal(SIGCONT);
  ASSERT_TRUE(writer->wait_until_received(Duration::milliseconds(10'000)));
  const Outcome outcome = recorder.stop();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::uint64_t recorded = messages_of(folder / "load.mcap").size();
  const auto metadata = bag::open_bag(folder / "load.mcap")->metadata();
  ASSERT_TRUE(metadata.contains("lost")) << recorded << " of 201 messages are there: " << outcome.out;
  EXPECT_EQ(recorded + std::stoull(metadata.at("lost").at("/load")), 201U);
  EXPECT_THAT(outcome.out, HasSubstr("messages of /load were sent and did not arrive"));
}

TEST(Record, ATypeOfAnotherDdsIsRecordedAndPlayedByItsBytes) {
  const Folder folder;
  {
    Running recorder({"record", "/readings", "--out", folder / "first"});
    ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
    const Outcome sender = run_to_end({CYCLONE_SENDER}, std::chrono::seconds(60));
    ASSERT_EQ(sender.status, 0) << sender.err;
    EXPECT_EQ(recorder.stop().status, 0);
  }
  const std::vector<Recorded> first = messages_of(folder / "first");
  ASSERT_EQ(first.size(), 10U);
  // Number 7: encapsulation, number, length of "reading 7" with its NUL, the text, two bytes of padding, 21
  // bytes from 7 on.
  const Bytes& cdr = first[7].cdr;
  ASSERT_GE(cdr.size(), 4U + 4 + 4 + 10 + 2 + 4 + 21);
  EXPECT_EQ(cdr[4], 7);
  EXPECT_EQ(std::string(cdr.begin() + 12, cdr.begin() + 21), "reading 7");
  EXPECT_EQ(cdr[24], 21);
  EXPECT_EQ(cdr[28], 7);
  EXPECT_EQ(cdr[48], 27);
  EXPECT_GT(first[9].cdr.size(), 3'000'000U);
  const Outcome echo = bandwagon({"topic", "echo", "--bag", folder / "first", "/readings"});
  EXPECT_EQ(echo.status, 2);
  EXPECT_THAT(echo.err, HasSubstr("no description of odd_msgs/msg/Reading is built in"));

  Running recorder({"record", "/readings", "--out", folder / "second"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  const Outcome player = bandwagon({"replay", folder / "first", "--wait-for", "/readings"});
  EXPECT_EQ(player.status, 0) << player.err;
  EXPECT_EQ(recorder.stop().status, 0);
  EXPECT_EQ(messages_of(folder / "second"), first);
  const auto second = bag::open_bag(folder / "second");
  EXPECT_EQ(topic_of(*second, "/readings").type, "odd_msgs/msg/Reading");
  EXPECT_EQ(topic_of(*second, "/readings").schema_encoding, "unknown");
  EXPECT_EQ(topic_of(*second, "/readings").writer, "bandwagon_player");
}

TEST(Record, WithSimTimeTheBagHasTheTimesOfTheClock) {
  const Folder folder;
  Running recorder({"record", "/text", "--use-sim-time", "--out", folder / "sim.mcap"});
  ASSERT_TRUE(recorder.is_there()) << recorder.process().err();
  dds::Participant participant(local());
  const auto clock =
      participant.create_writer(endpoint("/clock", "rosgraph_msgs/msg/Clock", Qos::standard(100)));
  const auto texts =
      participant.create_writer(endpoint("/text", "std_msgs/msg/String", Qos::latched(), kStringHash));
  const auto tick = [&](std::int64_t seconds) {
    rosgraph_msgs::msg::Clock message;
    message.clock(to_stamp({seconds * 1'000'000'000}));
    Bytes cdr;
    serialize(message, cdr);
    clock->write(cdr);
  };
  ASSERT_TRUE(is_matched(*clock));
  EXPECT_EQ(texts->matched_readers(), 0) << "nothing is recorded before there is a time";
  texts->write(text("from before"));
  tick(100);
  ASSERT_TRUE(is_matched(*texts));
  // The recorder may be told of the text before it has looked at the clock; 100 s is the least that it knows
  // then.
  ASSERT_TRUE(texts->wait_until_received(Duration::milliseconds(10'000)));
  tick(250);
  texts->write(text("now"));
  ASSERT_TRUE(texts->wait_until_received(Duration::milliseconds(10'000)));
  EXPECT_EQ(recorder.stop().status, 0);
  const auto recording = bag::open_bag(folder / "sim.mcap");
  std::vector<std::int64_t> seconds;
  const auto messages = recording->messages({});
  for (bag::BagMessage m; messages->next(m) == bag::Step::message;) {
    EXPECT_EQ(m.publish_time, m.log_time) << "a text has no stamp of its own";
    seconds.push_back(m.log_time.nanoseconds / 1'000'000'000);
  }
  EXPECT_THAT(seconds, testing::ElementsAre(100, 250));
  EXPECT_EQ(recording->metadata().at("bandwagon").at("clock"), "topic");
}

TEST(Record, TellsTheDiagnosticsHowItIsDoing) {
  const Folder folder;
  dds::Participant participant(local());
  const auto reader = participant.create_reader(
      endpoint("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", Qos::standard()), [] {});
  const auto texts =
      participant.create_writer(endpoint("/text", "std_msgs/msg/String", Qos::latched(), kStringHash));
  texts->write(text("hello"));
  Running recorder({"record", "/text", "--out", folder / "a.mcap"});
  std::map<std::string, std::string> values;
  EXPECT_TRUE(eventually([&] {
    diagnostic_msgs::msg::DiagnosticArray message;
    for (dds::Sample sample; reader->take(sample);) {
      if (!deserialize(sample.cdr, message)) continue;
      EXPECT_EQ(message.status().at(0).name(), "bandwagon_recorder");
      EXPECT_EQ(message.status().at(0).level(), 0);
      for (const auto& pair : message.status().at(0).values()) values[pair.key()] = pair.value();
    }
    return values["messages"] == "1";
  }));
  const Outcome nodes = bandwagon({"node", "list"});
  EXPECT_THAT(nodes.out, HasSubstr("/bandwagon_recorder\n"));
  EXPECT_EQ(recorder.stop().status, 0);
}

TEST(Record, WhatMakesNoSenseIsRefused) {
  const Folder folder;
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why) {
    arguments.insert(arguments.begin(), "record");
    const Outcome outcome = bandwagon(arguments);
    EXPECT_EQ(outcome.status, 2) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
  };
  refused({}, "name topics, --node or --all");
  refused({"--all", "--split-duration", "soon", "--out", folder / "a"}, "must be a duration");
  refused({"--all", "--exclude", "("}, "is no regular expression");
  refused({"--all", "--split-size", "1MB", "--out", folder / "a.mcap"}, "is one file");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "")) << "nothing was begun";
}

}  // namespace
}  // namespace bw::test
