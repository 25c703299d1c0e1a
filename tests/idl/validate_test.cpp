#include "runtime/wire/validate.hpp"

#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "std_msgs/msg/header.hpp"
#include "std_msgs/msg/string.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::test {
namespace {

std::string fault(std::string_view type, const std::vector<std::uint8_t>& bytes) {
  std::string error;
  EXPECT_FALSE(validate(*find_type(type), bytes, &error));
  return error;
}

TEST(Validate, RefusesOtherEncapsulations) {
  // PL_CDR, XCDR2 and CORBA-looking headers; too short for any.
  for (const std::vector<std::uint8_t>& bytes :
       {std::vector<std::uint8_t>{0, 3, 0, 0, 1}, {0, 7, 0, 0, 1}, {1, 1, 0, 0, 1}, {0, 1, 0}, {}}) {
    EXPECT_EQ(fault("std_msgs/msg/Bool", bytes),
              "std_msgs/msg/Bool: not plain CDR (encapsulation 00 00 or 00 01)");
  }
  EXPECT_TRUE(validate(*find_type("std_msgs/msg/Bool"),
                       std::vector<std::uint8_t>{0, 1, 0, 3, 1}));  // options are free
}

TEST(Validate, NamesTheFieldAndThePlace) {
  CdrWriter cdr;
  cdr.put<std::int32_t>(1).put<std::uint32_t>(2).put<std::uint32_t>(0xFFFFFFFF);
  EXPECT_EQ(fault("nav_msgs/msg/Odometry", cdr.bytes()),
            "std_msgs/msg/Header.frame_id: string runs past the end or lacks its NUL (byte 16 of 16)");
}

TEST(Validate, RefusesLengthsBeyondTheBytes) {
  // 0x20000000 doubles are 4 GiB: the product must not wrap.
  for (const std::uint32_t count : {2U, 0x20000000U, 0x80000000U, 0xFFFFFFFFU}) {
    CdrWriter cdr;
    cdr.header(0, 0, "").put<std::uint32_t>(0).put(count).doubles(1);
    EXPECT_EQ(fault("sensor_msgs/msg/JointState", cdr.bytes()).substr(0, 51),
              "sensor_msgs/msg/JointState.position: runs past the ");
  }
  CdrWriter nested;
  nested.put<std::uint32_t>(0xFFFFFFFF).header(0, 0, "map");
  EXPECT_EQ(fault("tf2_msgs/msg/TFMessage", nested.bytes()).substr(0, 47),
            "geometry_msgs/msg/TransformStamped.child_frame_");
}

TEST(Validate, RefusesAStringWithoutNul) {
  std::vector<std::uint8_t> bytes = CdrWriter().text("hello").bytes();
  bytes.back() = 'x';
  EXPECT_NE(fault("std_msgs/msg/String", bytes).find("NUL"), std::string::npos);
}

TEST(Validate, ReadsTheNullStringOfSomeWritersAsEmpty) {
  std_msgs::msg::String message;
  message.data("old");
  EXPECT_TRUE(deserialize(CdrWriter().put<std::uint32_t>(0).bytes(), message));
  EXPECT_EQ(message.data(), "");
}

TEST(Validate, HoldsBounds) {
  constexpr FieldDescription kFields[] = {{"name", Kind::kString, Shape::kSingle, 0, 4, nullptr},
                                          {"values", Kind::kUint8, Shape::kSequence, 2, 0, nullptr}};
  const TypeDescription type{"test/msg/Bounded", "test::msg::dds_::Bounded_", "", kFields};
  const auto bytes = [](const char* name, std::uint32_t count) {
    CdrWriter cdr;
    cdr.text(name).put(count);
    for (std::uint32_t i = 0; i < count; ++i) cdr.put<std::uint8_t>(1);
    return cdr.bytes();
  };
  EXPECT_TRUE(validate(type, bytes("abcd", 2)));
  EXPECT_FALSE(validate(type, bytes("abcde", 2)));
  EXPECT_FALSE(validate(type, bytes("abcd", 3)));
}

TEST(MessageSize, EndsWhereTheMessageEnds) {
  // 4 bytes of encapsulation, 4 of length, "ab" and its NUL.
  std::vector<std::uint8_t> bytes = CdrWriter().text("ab").bytes();
  const TypeDescription& type = *find_type("std_msgs/msg/String");
  EXPECT_EQ(message_size(type, bytes), 11U);
  bytes.resize(16);  // DDS pads
  EXPECT_EQ(message_size(type, bytes), 11U);
  bytes.resize(10);
  EXPECT_FALSE(message_size(type, bytes));
}

TEST(Deserialize, SaysWhyWithoutThrowing) {
  std_msgs::msg::Header header;
  std::string reason;
  EXPECT_FALSE(deserialize(std::vector<std::uint8_t>{0, 1, 0, 0, 1, 2}, header, &reason));
  EXPECT_EQ(reason, "builtin_interfaces/msg/Time.sec: runs past the end (byte 4 of 6)");
}

}  // namespace
}  // namespace bw::test
