#include "runtime/ros/distro_evidence.hpp"

#include <gtest/gtest.h>

#include "runtime/base/ros_distro.hpp"
#include "runtime/ros/discovery_info.hpp"

namespace bw {
namespace {

const std::string kHash = std::string("typehash=") + kDiscoveryTypeHash + ";";

/// An end of the participant whose prefix begins with `participant`.
dds::Endpoint end(std::uint8_t participant, const std::string& topic, const std::string& user_data) {
  static std::uint8_t count = 0;
  dds::Endpoint endpoint{.is_writer = true, .topic = topic, .user_data = user_data};
  endpoint.guid[0] = participant;
  endpoint.guid[15] = ++count;
  return endpoint;
}

TEST(DistroEvidence, AHashOnTheTopicOfNodesIsIronAndNoneIsHumble) {
  EXPECT_EQ(distro_evidence({}), (DistroEvidence{}));
  EXPECT_EQ(distro_evidence({end(1, kDiscoveryTopic, "")}), (DistroEvidence{.humble = true}));
  EXPECT_EQ(distro_evidence({end(1, kDiscoveryTopic, kHash)}), (DistroEvidence{.iron_and_later = true}));
  EXPECT_EQ(distro_evidence({end(1, kDiscoveryTopic, ""), end(2, kDiscoveryTopic, kHash)}),
            (DistroEvidence{.humble = true, .iron_and_later = true}));
}

// We send hashes of topics to Humble's processes as well: for them only the topic of nodes counts.
TEST(DistroEvidence, OtherEndsCountForWhoeverHasNoneThere) {
  const std::string hash = "typehash=RIHS01_00;";
  EXPECT_EQ(distro_evidence({end(1, "rt/odom", hash)}), (DistroEvidence{.iron_and_later = true}));
  EXPECT_EQ(distro_evidence({end(1, "rr/aReply", hash)}), (DistroEvidence{.iron_and_later = true}));
  EXPECT_EQ(distro_evidence({end(1, "rt/odom", hash), end(1, kDiscoveryTopic, "")}),
            (DistroEvidence{.humble = true}));
  EXPECT_EQ(distro_evidence({end(1, "rt/odom", "")}), (DistroEvidence{})) << "any DDS program";
  EXPECT_EQ(distro_evidence({end(1, "odom", hash)}), (DistroEvidence{})) << "no name of ROS 2";
}

TEST(DistroEvidence, WhoOnlyReadsThereMayBeAnyProgram) {
  dds::Endpoint reader = end(1, kDiscoveryTopic, "");
  reader.is_writer = false;
  EXPECT_EQ(distro_evidence({reader}), (DistroEvidence{}));
  reader.user_data = kHash;
  EXPECT_EQ(distro_evidence({reader}), (DistroEvidence{.iron_and_later = true}));
}

TEST(DistroEvidence, OwnEndsAndThoseThatReadBothCountForNothing) {
  EXPECT_EQ(distro_evidence({end(1, kDiscoveryTopic, discovery_reader_user_data()),
                             end(1, "rt/odom", "typehash=RIHS01_00;")}),
            (DistroEvidence{}));
  dds::Endpoint own = end(2, kDiscoveryTopic, "");
  own.is_local = true;
  EXPECT_EQ(distro_evidence({own}), (DistroEvidence{}));
}

TEST(RosDistro, NamesOfTheEnvironment) {
  EXPECT_EQ(distro_named("humble"), RosDistro::humble);
  EXPECT_EQ(distro_named("iron"), RosDistro::jazzy);
  EXPECT_EQ(distro_named("jazzy"), RosDistro::jazzy);
  EXPECT_EQ(distro_named("kilted"), RosDistro::kilted);
  EXPECT_EQ(distro_named("lyrical"), RosDistro::lyrical);
  EXPECT_EQ(distro_named("rolling"), RosDistro::lyrical);
  for (const char* unknown : {"", "auto", "noetic"})
    EXPECT_EQ(distro_named(unknown), std::nullopt) << unknown;
}

}  // namespace
}  // namespace bw
