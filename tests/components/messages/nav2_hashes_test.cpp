// Hashes of every layout against those that rosidl gives for the distribution's own files, and what finds a
// layout by its hash.
#include "tests/components/messages/nav2_hashes.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "tests/components/messages/every_nav2_message.hpp"
#include "tests/idl/jazzy_hashes.hpp"

namespace bw::test {
namespace {

std::string expected_hash(RosDistro distro, std::string_view ros_name) {
  if (distro == RosDistro::jazzy) {
    for (const JazzyHash& row : kJazzyHashes) {
      if (row.ros_name == ros_name) return std::string("RIHS01_") + row.hash;
    }
  }
  for (const Nav2Hash& row : kNav2Hashes) {
    if (row.distro == distro && row.ros_name == ros_name) return std::string("RIHS01_") + row.hash;
  }
  return "no row";
}

template <class Nav2>
void expect_hashes(RosDistro distro) {
  const Messages messages = every_nav2_message<Nav2>();
  EXPECT_EQ(messages.size(), 10U * 5U + 4U * 2U);
  for (const auto& message : messages) {
    const TypeDescription& type = message->type();
    EXPECT_EQ(type.type_hash, expected_hash(distro, type.ros_name)) << type.ros_name;
  }
}

TEST(Nav2Hashes, OfHumble) { expect_hashes<HumbleNav2>(RosDistro::humble); }
TEST(Nav2Hashes, OfJazzy) { expect_hashes<JazzyNav2>(RosDistro::jazzy); }
TEST(Nav2HashesUnproved, OfKilted) { expect_hashes<KiltedNav2>(RosDistro::kilted); }
TEST(Nav2HashesUnproved, OfLyrical) { expect_hashes<LyricalNav2>(RosDistro::lyrical); }

// Messages that Jazzy does not have, with one layout wherever they are.
TEST(Nav2HashesUnproved, OfYoungerMessages) {
  int rows = 0;
  for (const Nav2Hash& row : kNav2Hashes) {
    if (!std::string_view(row.ros_name).starts_with("nav2_msgs/msg/")) continue;
    ++rows;
    const TypeDescription* type = find_type(row.ros_name);
    ASSERT_NE(type, nullptr) << row.ros_name;
    EXPECT_EQ(type->type_hash, std::string("RIHS01_") + row.hash) << row.ros_name;
  }
  EXPECT_EQ(rows, 3);
}

TEST(Nav2Registry, ANameAloneIsJazzys) {
  for (const auto& jazzys : every_nav2_message<JazzyNav2>()) {
    EXPECT_EQ(find_type(jazzys->type().ros_name), &jazzys->type());
    EXPECT_EQ(find_type(jazzys->type().dds_name, ""), &jazzys->type());
  }
}

TEST(Nav2Registry, AHashFindsItsLayout) {
  const Messages layouts[] = {every_nav2_message<HumbleNav2>(), every_nav2_message<JazzyNav2>(),
                              every_nav2_message<KiltedNav2>(), every_nav2_message<LyricalNav2>()};
  for (const Messages& messages : layouts) {
    for (const auto& message : messages) {
      const TypeDescription& type = message->type();
      for (const std::string_view name : {type.ros_name, type.dds_name}) {
        const TypeDescription* found = find_type(name, type.type_hash);
        ASSERT_NE(found, nullptr) << name;
        EXPECT_EQ(found->type_hash, type.type_hash) << name;
        EXPECT_EQ(found->ros_name, type.ros_name);
      }
    }
  }
  const std::string_view younger = MessageTraits<LyricalNav2::Spin::Goal>::type_hash;
  EXPECT_EQ(find_type("nav2_msgs/action/BackUp_Goal", younger), nullptr);
  EXPECT_EQ(find_type("nav2_msgs/action/Spin_Goal", "RIHS01_0"), nullptr);
}

TEST(Nav2Registry, OtherLayoutsAreOfNamesThatJazzyHas) {
  EXPECT_FALSE(other_layouts().empty());
  for (const TypeDescription* layout : other_layouts())
    EXPECT_NE(find_type(layout->ros_name), nullptr) << layout->ros_name;
}

}  // namespace
}  // namespace bw::test
