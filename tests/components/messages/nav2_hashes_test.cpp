// Hashes of every layout against those that rosidl gives for the distribution's own files, and what finds a layout by its hash.
#include "tests/components/messages/nav2_hashes.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "tests/components/messages/every_nav2_type.hpp"
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
  int types = 0;
  every_nav2_type<Nav2, Nav2>([&]<class M, class>() {
    ++types;
    EXPECT_EQ(MessageTraits<M>::type_hash, expected_hash(distro, MessageTraits<M>::ros_name))
        << MessageTraits<M>::ros_name;
  });
  EXPECT_EQ(types, 10 * 5 + 4 * 2);
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
  every_nav2_type<LyricalNav2, JazzyNav2>([]<class Lyrical, class Jazzy>() {
    EXPECT_EQ(find_type(MessageTraits<Lyrical>::ros_name), &MessageTraits<Jazzy>::description());
    EXPECT_EQ(find_type(MessageTraits<Lyrical>::dds_name, ""), &MessageTraits<Jazzy>::description());
  });
}

TEST(Nav2Registry, AHashFindsItsLayout) {
  const auto check = []<class M, class>() {
    for (const std::string_view name : {MessageTraits<M>::ros_name, MessageTraits<M>::dds_name}) {
      const TypeDescription* type = find_type(name, MessageTraits<M>::type_hash);
      ASSERT_NE(type, nullptr) << name;
      EXPECT_EQ(type->type_hash, MessageTraits<M>::type_hash) << name;
      EXPECT_EQ(type->ros_name, MessageTraits<M>::ros_name);
    }
  };
  every_nav2_type<HumbleNav2, HumbleNav2>(check);
  every_nav2_type<JazzyNav2, JazzyNav2>(check);
  every_nav2_type<KiltedNav2, KiltedNav2>(check);
  every_nav2_type<LyricalNav2, LyricalNav2>(check);
  const auto lyricals = MessageTraits<LyricalNav2::Spin::Goal>::type_hash;
  EXPECT_EQ(find_type("nav2_msgs/action/BackUp_Goal", lyricals), nullptr);
  EXPECT_EQ(find_type("nav2_msgs/action/Spin_Goal", "RIHS01_0"), nullptr);
}

TEST(Nav2Registry, OtherLayoutsAreOfNamesThatJazzyHas) {
  EXPECT_FALSE(other_layouts().empty());
  for (const TypeDescription* layout : other_layouts())
    EXPECT_NE(find_type(layout->ros_name), nullptr) << layout->ros_name;
}

}  // namespace
}  // namespace bw::test
