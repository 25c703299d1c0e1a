// Expected texts follow ROS 2's own printer (rosidl_runtime_py: ordered dictionaries through PyYAML's block
// style, arrays and strings cut at 128); the scalar rules were compared with PyYAML 6.0.3 on 90,000 random
// texts and numbers.
#include "runtime/wire/yaml.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/yaml_scalar.hpp"
#include "tests/idl/cdr_writer.hpp"

namespace bw::test {
namespace {

std::string yaml(std::string_view type, const CdrWriter& cdr) {
  return to_yaml(*find_type(type), cdr.bytes());
}

TEST(Yaml, NestedMessagesAreIndentedByTwo) {
  CdrWriter cdr;
  cdr.header(12, 345, "base_link").doubles(0.5, 0, 0, 0, 0, -1e-7);
  EXPECT_EQ(yaml("geometry_msgs/msg/TwistStamped", cdr),
            "header:\n"
            "  stamp:\n"
            "    sec: 12\n"
            "    nanosec: 345\n"
            "  frame_id: base_link\n"
            "twist:\n"
            "  linear:\n"
            "    x: 0.5\n"
            "    y: 0.0\n"
            "    z: 0.0\n"
            "  angular:\n"
            "    x: 0.0\n"
            "    y: 0.0\n"
            "    z: -1.0e-07\n");
}

TEST(Yaml, ListsStandUnderTheirName) {
  CdrWriter cdr;
  cdr.header(0, 0, "").put<std::uint32_t>(2).text("left").text("1");
  cdr.put<std::uint32_t>(0).put<std::uint32_t>(2).doubles(1, 0.1).put<std::uint32_t>(0);
  EXPECT_EQ(yaml("sensor_msgs/msg/JointState", cdr),
            "header:\n"
            "  stamp:\n"
            "    sec: 0\n"
            "    nanosec: 0\n"
            "  frame_id: ''\n"
            "name:\n"
            "- left\n"
            "- '1'\n"
            "position: []\n"
            "velocity:\n"
            "- 1.0\n"
            "- 0.1\n"
            "effort: []\n");
}

TEST(Yaml, ListsOfMessages) {
  CdrWriter cdr;
  cdr.put<std::uint32_t>(2);
  cdr.header(1, 2, "map").text("odom").doubles(1, 2, 0, 0, 0, 0, 1);
  cdr.header(1, 2, "odom").text("base_link").doubles(0, 0, 0, 0, 0, 0, 1);
  const std::string tail =
      "      z: 0.0\n"
      "    rotation:\n"
      "      x: 0.0\n"
      "      y: 0.0\n"
      "      z: 0.0\n"
      "      w: 1.0\n";
  EXPECT_EQ(yaml("tf2_msgs/msg/TFMessage", cdr),
            "transforms:\n"
            "- header:\n"
            "    stamp:\n"
            "      sec: 1\n"
            "      nanosec: 2\n"
            "    frame_id: map\n"
            "  child_frame_id: odom\n"
            "  transform:\n"
            "    translation:\n"
            "      x: 1.0\n"
            "      y: 2.0\n" +
                tail +
                "- header:\n"
                "    stamp:\n"
                "      sec: 1\n"
                "      nanosec: 2\n"
                "    frame_id: odom\n"
                "  child_frame_id: base_link\n"
                "  transform:\n"
                "    translation:\n"
                "      x: 0.0\n"
                "      y: 0.0\n" +
                tail);
}

TEST(Yaml, LongArraysStopAfter128AndTheFieldsBehindThemAreRight) {
  CdrWriter cdr;
  cdr.header(0, 0, "laser").floats(-1, 1, 0.1F, 0, 0.1F, 0.05F, 20).put<std::uint32_t>(200);
  for (int i = 0; i < 200; ++i) cdr.floats(i);
  cdr.put<std::uint32_t>(1).floats(7);
  const std::string text = yaml("sensor_msgs/msg/LaserScan", cdr);
  // A float32 is printed as the double it becomes.
  EXPECT_NE(text.find("angle_increment: 0.10000000149011612\n"), std::string::npos);
  EXPECT_NE(text.find("\n- 127.0\n- '...'\nintensities:\n- 7.0\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("128.0"), std::string::npos);
}

TEST(Yaml, LongArraysOfMessagesToo) {
  CdrWriter cdr;
  cdr.header(0, 0, "map").put<std::uint32_t>(130);
  for (int i = 0; i < 130; ++i) cdr.floats(i, 0, 0);
  const std::string text = yaml("geometry_msgs/msg/PolygonStamped", cdr);
  EXPECT_TRUE(
      text.starts_with("header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: map\n"
                       "polygon:\n  points:\n  - x: 0.0\n    y: 0.0\n    z: 0.0\n  - x: 1.0\n"));
  EXPECT_TRUE(text.ends_with("  - x: 127.0\n    y: 0.0\n    z: 0.0\n  - '...'\n"));
}

TEST(Yaml, AnOctetIsACharacter) {
  CdrWriter cdr;
  cdr.put<std::uint8_t>(2)
      .text("planner")
      .text("ok: fine")
      .text("")
      .put<std::uint32_t>(1)
      .text("rate")
      .text("10.0");
  EXPECT_EQ(yaml("diagnostic_msgs/msg/DiagnosticStatus", cdr),
            "level: \"\\x02\"\n"
            "name: planner\n"
            "message: 'ok: fine'\n"
            "hardware_id: ''\n"
            "values:\n"
            "- key: rate\n"
            "  value: '10.0'\n");
}

TEST(Yaml, SmallIntegersAndBooleans) {
  CdrWriter status;
  status.put<std::int8_t>(-1).put<std::uint16_t>(9);
  EXPECT_EQ(yaml("sensor_msgs/msg/NavSatStatus", status), "status: -1\nservice: 9\n");
  CdrWriter flag;
  flag.put<std::uint8_t>(1);
  EXPECT_EQ(yaml("std_msgs/msg/Bool", flag), "data: true\n");
  CdrWriter empty;
  empty.put<std::uint8_t>(0);
  EXPECT_EQ(yaml("std_msgs/msg/Empty", empty), "{}\n");
}

TEST(Yaml, BadBytesBecomeAComment) {
  EXPECT_EQ(to_yaml(*find_type("std_msgs/msg/Bool"), CdrWriter().put<std::uint8_t>(2).bytes()),
            "# std_msgs/msg/Bool.data: boolean is neither 0 nor 1 (byte 5 of 5)\n");
}

TEST(YamlScalar, Numbers) {
  EXPECT_EQ(yaml_number(0.0), "0.0");
  EXPECT_EQ(yaml_number(-0.0), "-0.0");
  EXPECT_EQ(yaml_number(0.0001), "0.0001");
  EXPECT_EQ(yaml_number(0.00001), "1.0e-05");
  EXPECT_EQ(yaml_number(1.5e-9), "1.5e-09");
  EXPECT_EQ(yaml_number(1e15), "1000000000000000.0");
  EXPECT_EQ(yaml_number(1e16), "1.0e+16");
  EXPECT_EQ(yaml_number(0.1F), "0.10000000149011612");
  EXPECT_EQ(yaml_number(std::numeric_limits<double>::quiet_NaN()), ".nan");
  EXPECT_EQ(yaml_number(-std::numeric_limits<double>::infinity()), "-.inf");
}

TEST(YamlScalar, TextsAreQuotedWhenTheyMustBe) {
  const auto text = [](std::string_view value) { return yaml_text(value, 128, 2); };
  EXPECT_EQ(text("base_link"), "base_link");
  EXPECT_EQ(text("a b, c"), "a b, c");
  EXPECT_EQ(text(""), "''");
  for (const char* odd : {"true", "no",   "null", "~",  "12", "1.5", ".5", "-",  "- a", "2026-01-02", "12:30",
                          "a: b", "a #b", "[a",   "{a", "@a", "...", " a", "a ", "=",   "0x1F"}) {
    EXPECT_EQ(text(odd), "'" + std::string(odd) + "'");
  }
  EXPECT_EQ(text("it's"), "it's");
  EXPECT_EQ(text("'it's"), "'''it''s'");
  EXPECT_EQ(text("two\nlines"), "'two\n\n  lines'");
  EXPECT_EQ(text("tab\t\"\x01"), "\"tab\\t\\\"\\x01\"");
  EXPECT_EQ(text("Z\xC3\xBCrich"), "Z\xC3\xBCrich");
  EXPECT_EQ(text("\xFF\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(text(std::string(128, 'a')), std::string(128, 'a'));
  EXPECT_EQ(text(std::string(129, 'a')), std::string(128, 'a') + "...");
}

}  // namespace
}  // namespace bw::test
