// Every message type of the build: what an independent writer writes, the generated class reads and writes
// back.
#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"
#include "tests/idl/cdr_writer.hpp"
#include "tests/idl/every_message.hpp"

namespace bw::test {
namespace {

TEST(RoundTrip, EveryTypeKeepsItsBytes) {
  constexpr std::uint64_t kSeed = 20260;
  const auto messages = every_message();
  for (const auto& message : messages) {  // reused: old contents must not survive
    SCOPED_TRACE(message->type().ros_name);
    RandomPayload payload(kSeed, 4);
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 200; ++i) {
      const std::vector<std::uint8_t> golden = payload(message->type());
      std::string reason;
      ASSERT_TRUE(message->read(golden, &reason)) << reason << ", seed " << kSeed;
      message->write(bytes);
      ASSERT_EQ(bytes, golden) << "seed " << kSeed << ", round " << i;
    }
  }
  EXPECT_EQ(messages.size(), all_types().size() + other_layouts().size());
}

TEST(RoundTrip, BigEndianWritersAreUnderstood) {
  for (const auto& little : every_message()) {
    SCOPED_TRACE(little->type().ros_name);
    const auto big = little->fresh();
    std::string reason;
    EXPECT_TRUE(little->read(RandomPayload(7, 3)(little->type(), false), &reason)) << reason;
    EXPECT_TRUE(big->read(RandomPayload(7, 3)(little->type(), true), &reason)) << reason;
    EXPECT_TRUE(little->equals(*big));
  }
}

TEST(RoundTrip, EveryTruncationIsRefusedAndTrailingBytesAreNot) {
  for (const auto& message : every_message()) {
    const TypeDescription& type = message->type();
    SCOPED_TRACE(type.ros_name);
    std::vector<std::uint8_t> bytes = RandomPayload(11, 2)(type);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      ASSERT_FALSE(validate(type, std::span(bytes).first(size))) << size << " of " << bytes.size();
    }
    bytes.resize(bytes.size() + 3, 0xFF);
    EXPECT_TRUE(message->read(bytes, nullptr));
  }
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
