// In which format our nodes are announced, beside others on a domain. The formats' bytes are those of
// discovery_info_test.
#include "runtime/ros/node_announcement.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/ros/node_directory.hpp"
#include "tests/interop/eventually.hpp"

namespace bw {
namespace {

using test::eventually;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kHash = std::string("typehash=") + kDiscoveryTypeHash + ";";

dds::ParticipantOptions local() { return {.network = dds::Network::from_environment({})}; }

/// A process of ROS 2 as others see it: an end on the topic of nodes.
struct Other {
  explicit Other(const std::string& user_data)
      : writer(participant.create_writer({.topic = kDiscoveryTopic,
                                          .type = kDiscoveryType,
                                          .qos = Qos::latched(),
                                          .user_data = user_data})) {}

  void announce(const std::string& node) {
    writer->write(encode({.participant = participant.guid(),
                          .nodes = {{.node_namespace = "/", .name = node, .readers = {}, .writers = {}}}},
                         GidFormat::iron_and_later));
  }

  dds::Participant participant{local()};
  std::unique_ptr<dds::Writer> writer;
};

class Announcement : public testing::Test {
 protected:
  Announcement() { unsetenv("ROS_DISTRO"); }

  void announce(RosDistro distro, bool looks_around = true) {
    announcement = std::make_unique<NodeAnnouncement>(
        participant,
        AnnouncementOptions{
            .distro = distro, .looks_around = looks_around, .warn = [this](const std::string& text) {
              const std::lock_guard lock(mutex);
              warnings.push_back(text);
            }});
    announcement->add({.node_namespace = "/", .name = "base", .readers = {}, .writers = {}});
    announcement->publish();
  }
  bool decides(RosDistro distro) const {
    return eventually([&] { return announcement->distro().has_value(); }) && announcement->distro() == distro;
  }
  /// What a reader that is there gets.
  std::vector<std::uint8_t> bytes() {
    dds::Participant listener(local());
    Qos qos = Qos::latched();
    qos.depth = 100;  // of all writers together
    const auto reader = listener.create_reader({.topic = kDiscoveryTopic,
                                                .type = kDiscoveryType,
                                                .qos = qos,
                                                .user_data = discovery_reader_user_data()},
                                               [] {});
    dds::Sample sample;
    const auto is_ours = [&] {
      while (reader->take(sample)) {
        if (std::equal(sample.writer.begin(), sample.writer.begin() + 12, participant.guid().begin()))
          return true;
      }
      return false;
    };
    EXPECT_TRUE(eventually(is_ours));
    return sample.cdr;
  }
  std::vector<std::uint8_t> expected(GidFormat format) const {
    return encode({.participant = participant.guid(),
                   .nodes = {{.node_namespace = "/", .name = "base", .readers = {}, .writers = {}}}},
                  format);
  }
  std::vector<std::string> told() {
    const std::lock_guard lock(mutex);
    return warnings;
  }
  bool is_told(const std::string& text) {
    return eventually([&] {
      for (const std::string& warning : told()) {
        if (warning.find(text) != std::string::npos) return true;
      }
      return false;
    });
  }

  dds::Participant participant{local()};
  std::mutex mutex;
  std::vector<std::string> warnings;
  std::unique_ptr<NodeAnnouncement> announcement;  ///< ends before what it uses
};

// Of the thread that looks around: its owner hears of it on a thread of the owner's, once.
TEST_F(Announcement, WhatItsThreadThrowsIsThrownToItsOwner) {
  announcement = std::make_unique<NodeAnnouncement>(
      participant, AnnouncementOptions{.distro = RosDistro::humble, .warn = [](const std::string& text) {
                                         throw std::runtime_error("cannot say: " + text);
                                       }});
  const Other other(kHash);
  std::string what;
  const auto is_thrown = [&] {
    try {
      announcement->rethrow();
    } catch (const std::runtime_error& error) {
      what = error.what();
    }
    return !what.empty();
  };
  ASSERT_TRUE(eventually(is_thrown));
  EXPECT_THAT(what, HasSubstr("cannot say: this domain has processes of ROS 2 Iron or later"));
  EXPECT_NO_THROW(announcement->rethrow());
}

TEST_F(Announcement, IsForJazzyWhereNobodyIs) {
  announce(RosDistro::automatic);
  EXPECT_EQ(announcement->distro(), std::nullopt);
  ASSERT_TRUE(decides(RosDistro::jazzy));
  EXPECT_EQ(bytes(), expected(GidFormat::iron_and_later));
  EXPECT_THAT(told(), ElementsAre());
}

TEST_F(Announcement, GoesByHumbleThatIsThere) {
  const Other humble("");
  announce(RosDistro::automatic);
  ASSERT_TRUE(decides(RosDistro::humble));
  EXPECT_EQ(bytes(), expected(GidFormat::humble));
  EXPECT_THAT(told(), ElementsAre());
}

TEST_F(Announcement, GoesByJazzyThatIsThere) {
  const Other jazzy(kHash);
  announce(RosDistro::automatic);
  EXPECT_TRUE(decides(RosDistro::jazzy));
  EXPECT_THAT(told(), ElementsAre());
}

// Humble's bytes harm nobody; Jazzy's can crash Humble's processes.
TEST_F(Announcement, IsForHumbleWhereBothAreAndSaysSo) {
  const Other humble("");
  const Other jazzy(kHash);
  announce(RosDistro::automatic);
  ASSERT_TRUE(decides(RosDistro::humble));
  EXPECT_TRUE(is_told("processes of ROS 2 Iron or later"));
}

TEST_F(Announcement, ALaterContradictionIsToldOnceAndNotFollowed) {
  announce(RosDistro::jazzy);
  EXPECT_EQ(announcement->distro(), RosDistro::jazzy);
  const Other humble("");
  ASSERT_TRUE(is_told("processes of ROS 2 Humble or earlier"));
  const Other second("");
  const auto is_seen = [&](const dds::Endpoint& end) { return end.guid == second.writer->guid(); };
  ASSERT_TRUE(eventually([&] { return std::ranges::any_of(participant.endpoints(), is_seen); }));
  EXPECT_EQ(announcement->distro(), RosDistro::jazzy);
  EXPECT_EQ(bytes(), expected(GidFormat::iron_and_later));
  EXPECT_EQ(told().size(), 1U);
}

TEST_F(Announcement, TheEnvironmentDecidesAtOnce) {
  setenv("ROS_DISTRO", "humble", 1);
  announce(RosDistro::automatic);
  EXPECT_EQ(announcement->distro(), RosDistro::humble);
  announce(RosDistro::kilted);  // the graph says
  EXPECT_EQ(announcement->distro(), RosDistro::kilted);
}

TEST_F(Announcement, WithoutLookingAroundItIsJazzyAtOnce) {
  const Other humble("");
  announce(RosDistro::automatic, false);
  EXPECT_EQ(announcement->distro(), RosDistro::jazzy);
  EXPECT_EQ(bytes(), expected(GidFormat::iron_and_later));
  EXPECT_THAT(told(), ElementsAre());
}

// Bytes that are none, that claim billions of nodes, or to come from somebody else; then a sound sample is
// still heard.
TEST(NodeDirectory, HostileBytesHarmNobody) {
  dds::Participant participant(local());
  NodeDirectory directory(participant);
  Other other(kHash);
  ASSERT_TRUE(eventually([&] { return other.writer->matched_readers() > 0; }));
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255);
  const std::vector<std::uint8_t> sound = encode(
      {.participant = participant.guid(),
       .nodes = {{.node_namespace = "/", .name = "base", .readers = {participant.guid()}, .writers = {}}}},
      GidFormat::humble);
  other.writer->write(sound);  // in our own name
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes = sound;
    bytes.resize(4 + random() % bytes.size());
    for (int changes = 0; changes < 4; ++changes)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(byte(random));
    if (i % 3 == 0 && bytes.size() >= 24) std::fill(bytes.begin() + 20, bytes.begin() + 24, 0xff);
    other.writer->write(bytes);
  }
  other.announce("base");
  ASSERT_TRUE(eventually([&] {
    directory.update();
    return directory.participants().size() == 1 && directory.participants()[0].nodes.size() == 1 &&
           full_name(directory.participants()[0].nodes[0]) == "/base";
  }));
  EXPECT_EQ(directory.participants()[0].participant, other.participant.guid());
}

// What is known of a participant goes with it.
TEST(NodeDirectory, ForgetsWhoIsGone) {
  dds::Participant participant(local());
  NodeDirectory directory(participant);
  Other stays(kHash);
  stays.announce("stays");
  for (int i = 0; i < 5; ++i) {
    Other guest(kHash);
    guest.announce("guest");
    ASSERT_TRUE(eventually([&] {
      directory.update();
      const auto& known = directory.participants();
      return std::ranges::any_of(known,
                                 [&](const auto& p) { return p.participant == guest.participant.guid(); });
    }));
  }
  ASSERT_TRUE(eventually([&] { return participant.remote_participants().size() == 1; }));
  stays.announce("stays");
  ASSERT_TRUE(eventually([&] { return directory.update(); }));
  directory.forget_the_gone();
  EXPECT_EQ(directory.participants().size(), 1U);
}

}  // namespace
}  // namespace bw
