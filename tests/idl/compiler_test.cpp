#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idl/compiler/emit.hpp"
#include "idl/compiler/emit_class.hpp"
#include "idl/compiler/parser.hpp"
#include "idl/compiler/type_hash.hpp"

namespace bw::idl {
namespace {

using testing::HasSubstr;

std::string fault(const std::string& text) {
  try {
    static_cast<void>(link({parse(text, "a/msg/B.idl")}));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

std::string in_module(const std::string& definition) {
  return "module a { module msg {\n" + definition + "\n}; };";
}

TEST(IdlCompiler, ReadsEveryKindOfMember) {
  const File file = parse(R"(
    #include "c/msg/D.idl"  // where the nested type comes from
    /* two
       lines */
    module a { module msg {
      module B_Constants { const int8 LOW = -1; };
      struct B {
        octet byte_value;
        double fixed[36];
        sequence<uint16, 5> bounded;
        sequence<string<8>> texts;
        c::msg::D nested;
      };
    }; };)",
                          "a/msg/B.idl");
  EXPECT_EQ(file.includes, std::vector<std::string>{"c/msg/D.idl"});
  ASSERT_EQ(file.structs.size(), 1U);
  const Struct& type = file.structs[0];
  EXPECT_EQ(type.dds_name(), "a::msg::dds_::B_");
  ASSERT_EQ(type.members.size(), 5U);
  EXPECT_EQ(type.members[0].kind, Kind::kByte);
  EXPECT_EQ(type.members[1].shape, Shape::kArray);
  EXPECT_EQ(type.members[1].capacity, 36U);
  EXPECT_EQ(type.members[2].shape, Shape::kSequence);
  EXPECT_EQ(type.members[2].capacity, 5U);
  EXPECT_EQ(type.members[3].string_capacity, 8U);
  EXPECT_EQ(type.members[4].message, "c/msg/D");
  ASSERT_EQ(file.constants.size(), 1U);
  EXPECT_EQ(file.constants[0].name, "B_Constants");
  ASSERT_EQ(file.constants[0].values.size(), 1U);
  EXPECT_EQ(file.constants[0].values[0].kind, Kind::kInt8);
  EXPECT_EQ(file.constants[0].values[0].name, "LOW");
  EXPECT_EQ(file.constants[0].values[0].value, "-1");
}

// What the wire cannot show: the constants, and that only a class which owns memory has members to be compiled elsewhere.
TEST(IdlCompiler, WritesConstantsAndClasses) {
  const File file =
      parse(in_module("module B_Constants { const int8 LOW = -1; }; struct B { octet x; float y[2]; };"
                      "struct C { sequence<string> texts; };"),
            "a/msg/B.idl");
  const Types types = link({file});
  EXPECT_THAT(constants_definition(file.constants[0]), HasSubstr("inline constexpr std::int8_t LOW = -1;\n"));
  const std::string plain = class_definition(file.structs[0], types);
  EXPECT_THAT(plain, HasSubstr("  std::uint8_t x_{};\n  std::array<float, 2> y_{};\n"));
  EXPECT_THAT(plain, Not(HasSubstr("~B()")));
  EXPECT_EQ(special_members(file.structs[0], types), "");
  const std::string owner = class_definition(file.structs[1], types);
  EXPECT_THAT(owner, HasSubstr("  std::vector<std::string> texts_{};\n"));
  EXPECT_THAT(owner, HasSubstr("  ~C();\n"));
  EXPECT_THAT(special_members(file.structs[1], types), HasSubstr("C::~C() = default;\n"));
}

TEST(IdlCompiler, RefusesWithFileAndLine) {
  EXPECT_THAT(fault(in_module("struct B { };")), HasSubstr("a/msg/B.idl:2: expected a member"));
  EXPECT_THAT(fault(in_module("struct B {\n long x; };")),
              HasSubstr("a/msg/B.idl:3: expected '::', found 'x'"));
  EXPECT_THAT(fault(in_module("struct B { float x[0]; };")),
              HasSubstr("a/msg/B.idl:2: expected a positive number"));
  EXPECT_THAT(fault(in_module("@key struct B { float x; };")), HasSubstr("a/msg/B.idl:2: unexpected '@'"));
  EXPECT_THAT(fault(in_module("module B_Constants {\n const string NAME = x; };")),
              HasSubstr("a/msg/B.idl:3: expected a number's type before"));
  EXPECT_THAT(fault("module a {"), HasSubstr("found 'the end of the file'"));
  EXPECT_THAT(fault("/* for ever"), HasSubstr("a/msg/B.idl:1: comment without end"));
  EXPECT_THAT(fault("#pragma once"), HasSubstr("a/msg/B.idl:1: unknown directive"));
  EXPECT_THAT(fault("\n#ifndef GUARD"), HasSubstr("a/msg/B.idl:2: unknown directive"));
}

TEST(IdlCompiler, RefusesTypesThatDoNotFitTogether) {
  EXPECT_THAT(fault(in_module("struct B { a::msg::C c; };")), HasSubstr("B.c has unknown type a/msg/C"));
  EXPECT_THAT(fault(in_module("struct B { a::msg::B b; };")), HasSubstr("B.b has unknown type a/msg/B"));
  EXPECT_THAT(fault(in_module("struct B { float x; }; struct B { float x; };")),
              HasSubstr("a/msg/B is defined twice"));
  EXPECT_THAT(fault("#include \"a/msg/B.idl\"\n" + in_module("struct B { float x; };")),
              HasSubstr("includes itself"));
  EXPECT_THAT(fault("#include \"no.idl\"\n"), HasSubstr("no such file: no.idl"));
}

TEST(IdlCompiler, NamesHeadersAsRos2Does) {
  EXPECT_EQ(header_path("tf2_msgs/msg/TFMessage.idl"), "tf2_msgs/msg/tf_message.hpp");
  EXPECT_EQ(header_path("visualization_msgs/msg/UVCoordinate.idl"),
            "visualization_msgs/msg/uv_coordinate.hpp");
  EXPECT_EQ(header_path("geometry_msgs/msg/Point32.idl"), "geometry_msgs/msg/point32.hpp");
  EXPECT_EQ(header_path("geometry_msgs/msg/Pose2D.idl"), "geometry_msgs/msg/pose2_d.hpp");
  EXPECT_EQ(header_path("sensor_msgs/msg/NavSatFix.idl"), "sensor_msgs/msg/nav_sat_fix.hpp");
}

// The text that ROS 2 hashes, for a type small enough to write down.
TEST(IdlCompiler, WritesTheHashedTextToTheLetter) {
  const Types types = link({parse(in_module("struct B { sequence<uint8, 3> x; };"), "a/msg/B.idl")});
  EXPECT_EQ(
      type_description_json(types.at("a/msg/B"), types),
      R"({"type_description": {"type_name": "a/msg/B", "fields": [{"name": "x", "type": {"type_id": 99, )"
      R"("capacity": 3, "string_capacity": 0, "nested_type_name": ""}}]}, "referenced_type_descriptions": []})");
}

}  // namespace
}  // namespace bw::idl
