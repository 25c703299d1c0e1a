// Messages from text. Expected bytes are worked out by hand from the rules of plain CDR: each number at a
// multiple of its size, strings as length with NUL, characters, NUL.
#include "runtime/ros/message_from_yaml.hpp"

#include <array>

#include <gmock/gmock.h>

#include "runtime/parameters/config_error.hpp"
#include "runtime/parameters/yaml_file.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::array kOneOfEach = {
    FieldDescription{"truth", Kind::kBoolean}, FieldDescription{"octet", Kind::kByte},
    FieldDescription{"i8", Kind::kInt8},       FieldDescription{"u8", Kind::kUint8},
    FieldDescription{"i16", Kind::kInt16},     FieldDescription{"u16", Kind::kUint16},
    FieldDescription{"i32", Kind::kInt32},     FieldDescription{"u32", Kind::kUint32},
    FieldDescription{"i64", Kind::kInt64},     FieldDescription{"u64", Kind::kUint64},
    FieldDescription{"f32", Kind::kFloat32},   FieldDescription{"f64", Kind::kFloat64},
    FieldDescription{"text", Kind::kString}};
constexpr TypeDescription kAll{.ros_name = "test_msgs/msg/All", .fields = kOneOfEach};

constexpr std::array kOneOfEachShape = {
    FieldDescription{"three", Kind::kUint16, Shape::kArray, 3},
    FieldDescription{"two_at_most", Kind::kUint8, Shape::kSequence, 2},
    FieldDescription{"any", Kind::kFloat64, Shape::kSequence},
    FieldDescription{"texts", Kind::kString, Shape::kSequence},
    FieldDescription{.name = "short_text", .kind = Kind::kString, .string_capacity = 4},
};
constexpr TypeDescription kShapes{.ros_name = "test_msgs/msg/Shapes", .fields = kOneOfEachShape};

std::string hex(const TypeDescription& type, const std::string& text) {
  std::string digits;
  for (const std::uint8_t byte : message_from_yaml(type, parse_yaml(text, "request"))) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    digits.push_back(kDigits[byte >> 4U]);
    digits.push_back(kDigits[byte & 15U]);
  }
  return digits;
}

std::string hex(std::string_view type, const std::string& text) { return hex(*find_type(type), text); }

std::string without_spaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::string refusal(const TypeDescription& type, const std::string& text) {
  try {
    return "accepted: " + hex(type, text);
  } catch (const ConfigError& error) {
    return error.what();
  }
}

std::string refusal(std::string_view type, const std::string& text) {
  return refusal(*find_type(type), text);
}

TEST(MessageFromYaml, EachKindAtTheEndOfItsRange) {
  EXPECT_EQ(
      hex(kAll,
          "{truth: true, octet: 255, i8: -128, u8: 255, i16: -32768, u16: 65535, i32: -2147483648, u32: 4294967295,"
          " i64: -9223372036854775808, u64: 9223372036854775807, f32: 0.5, f64: -1.5, text: hi}"),
      without_spaces("00010000 01 ff 80 ff 0080 ffff 00000080 ffffffff 0000000000000080 ffffffffffffff7f "
                     "0000003f 00000000 000000000000f8bf 03000000 686900"));
}

TEST(MessageFromYaml, WhatIsNotGivenIsZero) {
  const std::string nothing = without_spaces(
      "00010000 00 00 00 00 0000 0000 00000000 00000000 0000000000000000 0000000000000000 "
      "00000000 00000000 0000000000000000 01000000 00");
  for (const char* text : {"{}", "", "{truth: null, text: null, f64: ~}"})
    EXPECT_EQ(hex(kAll, text), nothing) << text;
}

TEST(MessageFromYaml, JsonIsYaml) {
  EXPECT_EQ(hex(kAll, R"({"truth": true, "i16": -2, "f64": 1e0, "text": "a: {b}"})"),
            hex(kAll, "truth: true\ni16: -2\nf64: 1.0\ntext: 'a: {b}'\n"));
}

TEST(MessageFromYaml, ListsAndArrays) {
  // 3 numbers of 2 bytes; at 8 the count 2, at 16 the count 1, at 24 the double (3ff0...), then two texts and
  // a short one.
  EXPECT_EQ(
      hex(kShapes, "{three: [1, 2, 3], two_at_most: [4, 5], any: [1.0], texts: [a, ''], short_text: abcd}"),
      without_spaces("00010000 0100 0200 0300 0000 02000000 04 05 0000 01000000 00000000 000000000000f03f "
                     "02000000 02000000 6100 0000 01000000 00 000000 05000000 6162636400"));
}

TEST(MessageFromYaml, ListsThatAreNotGivenAreEmptyAndArraysZero) {
  EXPECT_EQ(hex(kShapes, "{}"),
            without_spaces("00010000 0000 0000 0000 0000 00000000 00000000 00000000 01000000 00"));
}

TEST(MessageFromYaml, ATurnThatIsNotGivenIsNone) {
  // position x = 2 (4000...); of the orientation w = 1.
  EXPECT_EQ(hex("geometry_msgs/msg/Pose", "{position: {x: 2}}"),
            without_spaces("00010000 0000000000000040 0000000000000000 0000000000000000 "
                           "0000000000000000 0000000000000000 0000000000000000 000000000000f03f"));
}

TEST(MessageFromYaml, AnEmptyMessageIsOneZeroByteThatNobodyNames) {
  EXPECT_EQ(hex("std_srvs/srv/Trigger_Request", "{}"), "0001000000");
  EXPECT_THAT(refusal("std_srvs/srv/Trigger_Request", "{structure_needs_at_least_one_member: 1}"),
              HasSubstr("unknown field"));
}

TEST(MessageFromYaml, ListsOfMessages) {
  // One point (1, 2, 3) in floats: 3f800000, 40000000, 40400000.
  EXPECT_EQ(hex("geometry_msgs/msg/Polygon", "{points: [{x: 1, y: 2, z: 3}]}"),
            without_spaces("00010000 01000000 0000803f 00000040 00004040"));
}

struct Refused {
  std::string text;
  std::string rule;
};

class OutOfRange : public testing::TestWithParam<Refused> {};

TEST_P(OutOfRange, IsRefusedWithTheRule) {
  EXPECT_THAT(refusal(kAll, "{" + GetParam().text + "}"),
              AllOf(HasSubstr("request:1: "), HasSubstr(GetParam().rule)));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OutOfRange,
    testing::Values(Refused{"truth: maybe", "truth = maybe: must be true or false"},
                    Refused{"truth: 'true'", "must be true or false"},
                    Refused{"octet: 256", "octet = 256: must be a whole number from 0 to 255"},
                    Refused{"i8: -129", "must be a whole number from -128 to 127"},
                    Refused{"u8: -1", "must be a whole number from 0 to 255"},
                    Refused{"u8: 1.5", "must be a whole number from 0 to 255"},
                    Refused{"i16: 32768", "must be a whole number from -32768 to 32767"},
                    Refused{"u16: 65536", "must be a whole number from 0 to 65535"},
                    Refused{"i32: 2147483648", "must be a whole number from -2147483648 to 2147483647"},
                    Refused{"u32: -1", "must be a whole number from 0 to 4294967295"},
                    Refused{"u64: -1", "u64 = -1: must be a whole number from 0"},
                    Refused{"i64: 1.5", "must be a whole number"},
                    Refused{"f32: 1e39", "is too large for a float32"},
                    Refused{"f64: fast", "f64 = fast: must be a number"},
                    Refused{"f64: '1.0'", "must be a number"}, Refused{"f64: [1.0]", "must be a number"},
                    Refused{"f64: {x: 1}", "must be a number"}, Refused{"text: [a]", "must be a text"}));

TEST(MessageFromYaml, BoundsAreKept) {
  EXPECT_THAT(refusal(kShapes, "{three: [1, 2]}"), HasSubstr("three = a list: must have 3 elements, not 2"));
  EXPECT_THAT(refusal(kShapes, "{two_at_most: [1, 2, 3]}"), HasSubstr("must have at most 2 elements, not 3"));
  EXPECT_THAT(refusal(kShapes, "{short_text: abcde}"),
              HasSubstr("short_text = abcde: must have at most 4 bytes"));
  EXPECT_THAT(refusal(kShapes, "{any: 1.0}"), HasSubstr("any = 1.0: must be a list"));
}

TEST(MessageFromYaml, UnknownFieldsAreNamedWithTheNearest) {
  EXPECT_THAT(refusal("geometry_msgs/msg/PoseStamped", "{pose: {positon: {x: 1.0}}}"),
              HasSubstr("request:1: pose.positon: unknown field; did you mean 'position'?"));
  EXPECT_THAT(refusal("geometry_msgs/msg/PoseStamped", "{pose: 3}"),
              HasSubstr("pose = 3: must be a map of the fields of geometry_msgs/msg/Pose"));
  EXPECT_THAT(refusal("geometry_msgs/msg/Polygon", "{points: [{x: 1}, {width: 2}]}"),
              HasSubstr("points.1.width: unknown field; known: x, y, z"));
}

TEST(MessageFromYaml, AllMistakesAtOnceEachWithItsLine) {
  EXPECT_THAT(refusal(kAll, "u8: 300\ntruth: 2\nnobody: 1\n"),
              AllOf(HasSubstr("request:1: u8 = 300"), HasSubstr("request:2: truth = 2"),
                    HasSubstr("request:3: nobody")));
}

TEST(MessageFromYaml, WhatIsNoYamlIsRefused) {
  EXPECT_THROW(hex(kAll, "{truth: true"), ConfigError);
  EXPECT_THAT(refusal(kAll, "[1, 2]"), HasSubstr("must be a map of the fields of test_msgs/msg/All"));
}

}  // namespace
}  // namespace bw
