// Every message type of the build: what an independent writer writes, the generated class reads and writes
// back.
#include <gtest/gtest.h>

#include "all_messages.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::test {
namespace {

TEST(RoundTrip, EveryTypeKeepsItsBytes) {
  constexpr std::uint64_t kSeed = 20260;
  int types = 0;
  for_each_message([&]<class M>() {
    ++types;
    const TypeDescription& type = MessageTraits<M>::description();
    SCOPED_TRACE(type.ros_name);
    RandomPayload payload(kSeed, 4);
    M message;  // reused: old contents must not survive
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 200; ++i) {
      const std::vector<std::uint8_t> golden = payload(type);
      std::string reason;
      ASSERT_TRUE(deserialize(golden, message, &reason)) << reason << ", seed " << kSeed;
      serialize(message, bytes);
      ASSERT_EQ(bytes, golden) << "seed " << kSeed << ", round " << i;
    }
  });
  EXPECT_EQ(static_cast<std::size_t>(types), all_types().size() + other_layouts().size());
}

TEST(RoundTrip, BigEndianWritersAreUnderstood) {
  for_each_message([&]<class M>() {
    const TypeDescription& type = MessageTraits<M>::description();
    SCOPED_TRACE(type.ros_name);
    M little;
    M big;
    std::string reason;
    EXPECT_TRUE(deserialize(RandomPayload(7, 3)(type, false), little, &reason)) << reason;
    EXPECT_TRUE(deserialize(RandomPayload(7, 3)(type, true), big, &reason)) << reason;
    EXPECT_TRUE(little == big);
  });
}

TEST(RoundTrip, EveryTruncationIsRefusedAndTrailingBytesAreNot) {
  for_each_message([&]<class M>() {
    const TypeDescription& type = MessageTraits<M>::description();
    SCOPED_TRACE(type.ros_name);
    std::vector<std::uint8_t> bytes = RandomPayload(11, 2)(type);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      ASSERT_FALSE(validate(type, std::span(bytes).first(size))) << size << " of " << bytes.size();
    }
    bytes.resize(bytes.size() + 3, 0xFF);
    M message;
    EXPECT_TRUE(deserialize(bytes, message));
  });
}

TEST(Registry, FindsByEitherName) {
  const TypeDescription* odometry = find_type("nav_msgs/msg/Odometry");
  ASSERT_NE(odometry, nullptr);
  EXPECT_EQ(odometry, find_type("nav_msgs::msg::dds_::Odometry_"));
  EXPECT_EQ(odometry, &MessageTraits<nav_msgs::msg::Odometry>::description());
  ASSERT_EQ(odometry->fields.size(), 4U);
  EXPECT_EQ(odometry->fields[1].name, "child_frame_id");
  EXPECT_EQ(odometry->fields[2].message->ros_name, "geometry_msgs/msg/PoseWithCovariance");
  EXPECT_EQ(find_type("nav_msgs/msg/odometry"), nullptr);
  EXPECT_EQ(find_type(""), nullptr);
}

}  // namespace
}  // namespace bw::test
