#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idl/compiler/emit.hpp"
#include "idl/compiler/emit_class.hpp"
#include "idl/compiler/parser.hpp"
#include "idl/compiler/type_hash.hpp"

namespace bw::idl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault(const std::string& text, const std::string& path = "a/msg/B.idl") {
  try {
    static_cast<void>(link({parse(text, path)}));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

std::string in_module(const std::string& definition, const std::string& category = "msg") {
  return "module a { module " + category + " {\n" + definition + "\n}; };";
}

std::vector<std::string> names(const File& file) {
  std::vector<std::string> result;
  for (const Struct& type : file.structs) result.push_back(type.name);
  return result;
}

TEST(IdlCompiler, ReadsEveryKindOfMember) {
  const File file = parse(R"(
    #include "c/msg/D.idl"  // where the nested type comes from
    module a { module msg {
      module B_Constants { const int8 LOW = -1; };
      struct B {
        // two lines
        //   of comment
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
  EXPECT_EQ(type.members[0].comment, "two lines\nof comment\n");
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

// What the wire cannot show: the constants, and that only a class which owns memory has members to be
// compiled elsewhere.
TEST(IdlCompiler, WritesConstantsAndClasses) {
  const File file =
      parse(in_module("module B_Constants { const int8 LOW = -1; }; struct B { octet x; float y[2]; };"
                      "struct C { sequence<string> texts; };"),
            "test.idl");
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
  EXPECT_THAT(fault("/* */"), HasSubstr("a/msg/B.idl:1: unexpected '/'"));
  EXPECT_THAT(fault("#pragma once"), HasSubstr("a/msg/B.idl:1: unknown directive"));
  EXPECT_THAT(fault("\n#ifndef GUARD"), HasSubstr("a/msg/B.idl:2: unknown directive"));
}

TEST(IdlCompiler, RefusesTypesThatDoNotFitTogether) {
  EXPECT_THAT(fault(in_module("struct B { a::msg::C c; };")), HasSubstr("B.c has unknown type a/msg/C"));
  EXPECT_THAT(fault(in_module("struct B { a::msg::B b; };")), HasSubstr("B.b has unknown type a/msg/B"));
  EXPECT_THAT(fault(in_module("struct B { float x; }; struct B { float x; };"), "test.idl"),
              HasSubstr("a/msg/B is defined twice"));
  EXPECT_THAT(fault("#include \"a/msg/B.idl\"\n" + in_module("struct B { float x; };")),
              HasSubstr("includes itself"));
  EXPECT_THAT(fault("#include \"no.idl\"\n", "test.idl"), HasSubstr("no such file: no.idl"));
}

// The order and fields of rosidl: its hash test holds the fields, this what is made at all.
TEST(IdlCompiler, DerivesWhatCarriesACall) {
  const File service = parse(
      in_module("struct B_Request { float x; }; struct B_Response { float y; };", "srv"), "a/srv/B.idl");
  EXPECT_THAT(names(service), ElementsAre("B_Request", "B_Response", "B_Event"));
  EXPECT_THAT(service.includes, ElementsAre("service_msgs/msg/ServiceEventInfo.idl"));
  const File action = parse(
      in_module("struct B_Goal { float x; }; struct B_Result { float y; }; struct B_Feedback { float z; };",
                "action"),
      "a/action/B.idl");
  EXPECT_THAT(names(action), ElementsAre("B_Goal", "B_Result", "B_Feedback", "B_SendGoal_Request",
                                         "B_SendGoal_Response", "B_SendGoal_Event", "B_GetResult_Request",
                                         "B_GetResult_Response", "B_GetResult_Event", "B_FeedbackMessage"));
  EXPECT_THAT(action.includes,
              ElementsAre("unique_identifier_msgs/msg/UUID.idl", "builtin_interfaces/msg/Time.idl",
                          "service_msgs/msg/ServiceEventInfo.idl"));
  EXPECT_EQ(interface_definition(interface_of("a/msg/B.idl")), "");
}

// rosidl takes a file of two structs for a service.
TEST(IdlCompiler, RefusesAFileThatIsNotOneMessage) {
  EXPECT_EQ(fault(in_module("struct C { float x; };")),
            "a/msg/B.idl:2: expected struct a::msg::B, found a::msg::C");
  EXPECT_EQ(fault(in_module("struct B { float x; };\nstruct C { float x; };")),
            "a/msg/B.idl:3: expected no more structs, found a::msg::C");
  EXPECT_EQ(fault(in_module("")), "a/msg/B.idl:3: expected struct a::msg::B, found the end of the file");
}

TEST(IdlCompiler, RefusesServicesAndActionsThatAreNone) {
  const auto service = [](const std::string& definition) {
    return fault(in_module(definition, "srv"), "a/srv/B.idl");
  };
  const auto action = [](const std::string& text) {
    return fault(in_module(text, "action"), "a/action/B.idl");
  };
  const std::string request = "struct B_Request { float x; };\n";
  const std::string response = "struct B_Response { float y; };\n";
  EXPECT_EQ(service(request), "a/srv/B.idl:4: expected struct a::srv::B_Response, found the end of the file");
  EXPECT_EQ(service(response + request),
            "a/srv/B.idl:2: expected struct a::srv::B_Request, found a::srv::B_Response");
  EXPECT_EQ(service(request + response + "struct C { float x; };"),
            "a/srv/B.idl:4: expected no more structs, found a::srv::C");
  EXPECT_EQ(service(request + response + "module C_Request_Constants { };"),
            "a/srv/B.idl:4: C_Request_Constants belongs to no struct of this file");
  EXPECT_EQ(
      service("struct B_Request { };" + response),
      "a/srv/B.idl:2: expected a member (ROS 2 writes 'structure_needs_at_least_one_member') before, found ';'");
  EXPECT_EQ(service(request + response), "a/srv/B.idl: no such file: service_msgs/msg/ServiceEventInfo.idl");
  EXPECT_EQ(fault(in_module(request + response, "action"), "a/srv/B.idl"),
            "a/srv/B.idl:2: expected struct a::srv::B_Request, found a::action::B_Request");
  EXPECT_EQ(fault(in_module(request + response, "srv"), "c/srv/B.idl"),
            "c/srv/B.idl:2: expected struct c::srv::B_Request, found a::srv::B_Request");
  EXPECT_EQ(action("struct B_Goal { float x; };\nstruct B_Feedback { float x; };"),
            "a/action/B.idl:3: expected struct a::action::B_Result, found a::action::B_Feedback");
  EXPECT_EQ(action("struct B_SendGoal_Request { float x; };"),
            "a/action/B.idl:2: expected struct a::action::B_Goal, found a::action::B_SendGoal_Request");
  EXPECT_EQ(fault(in_module(request + response, "srv"), "a/srv/b.idl"),
            "a/srv/b.idl:1: expected a file's name in CamelCase");
}

// rosidl refuses these names, and whoever exports the message would learn it late.
TEST(IdlCompiler, RefusesNamesThatRos2Refuses) {
  const auto member = [](const std::string& name) {
    return fault(in_module("struct B { float " + name + "; };"));
  };
  const auto constant = [](const std::string& name) {
    return fault(in_module("module B_Constants { const int8 " + name + " = 1; }; struct B { float x; };"));
  };
  EXPECT_EQ(member("angleMin"), "a/msg/B.idl:2: expected a member's name in lower_case, found 'angleMin'");
  EXPECT_THAT(member("angle__min"), HasSubstr("lower_case"));
  EXPECT_THAT(member("angle_"), HasSubstr("lower_case"));
  EXPECT_THAT(member("1st"), HasSubstr("lower_case"));
  EXPECT_EQ(member("angle_045"), "accepted");
  EXPECT_EQ(constant("Low"), "a/msg/B.idl:2: expected a constant's name in UPPER_CASE, found 'Low'");
  EXPECT_THAT(constant("LOW_"), HasSubstr("UPPER_CASE"));
  EXPECT_EQ(constant("LOW_2"), "accepted");
  EXPECT_EQ(fault(in_module("struct laser_scan { float x; };")),
            "a/msg/B.idl:2: expected a struct's name in CamelCase, found 'laser_scan'");
  EXPECT_THAT(fault(in_module("struct Laser_Scan { float x; };")), HasSubstr("CamelCase"));
  EXPECT_THAT(fault("module A { };"),
              HasSubstr("a/msg/B.idl:1: expected a module's name in lower_case, found 'A'"));
}

TEST(IdlCompiler, NamesHeadersAsRos2Does) {
  EXPECT_EQ(header_path("tf2_msgs/msg/TFMessage.idl"), "tf2_msgs/msg/tf_message.hpp");
  EXPECT_EQ(header_path("visualization_msgs/msg/UVCoordinate.idl"),
            "visualization_msgs/msg/uv_coordinate.hpp");
  EXPECT_EQ(header_path("geometry_msgs/msg/Point32.idl"), "geometry_msgs/msg/point32.hpp");
  EXPECT_EQ(header_path("geometry_msgs/msg/Pose2D.idl"), "geometry_msgs/msg/pose2_d.hpp");
  EXPECT_EQ(header_path("sensor_msgs/msg/NavSatFix.idl"), "sensor_msgs/msg/nav_sat_fix.hpp");
}

// A layout of another distribution: the same names on the wire, a class and a header of its own.
TEST(IdlCompiler, KeepsLayoutsOfDistributionsApart) {
  const std::string path = "distros/humble/a/msg/B.idl";
  EXPECT_EQ(header_path(path), "humble/a/msg/b.hpp");
  const File base = parse(in_module("struct B { float x; };"), "a/msg/B.idl");
  const File user =
      parse("#include \"a/msg/B.idl\"\n" + in_module("struct C { a::msg::B b; };"), "a/msg/C.idl");
  const File own = parse(in_module("struct B { double x; };"), path);
  const File own_user = parse("#include \"" + path + "\"\n" + in_module("struct C { a::msg::B b; };"),
                              "distros/humble/a/msg/C.idl");
  EXPECT_EQ(own.structs[0].ros_name(), "a/msg/B");
  EXPECT_EQ(own.structs[0].dds_name(), "a::msg::dds_::B_");
  EXPECT_EQ(own.structs[0].cpp_name(), "humble::a::msg::B");
  const Types types = link({base, user, own, own_user});
  EXPECT_EQ(&nested(types, types.at("a/msg/C"), user.structs[0].members[0]), &types.at("a/msg/B"));
  EXPECT_EQ(&nested(types, types.at("humble/a/msg/C"), own_user.structs[0].members[0]),
            &types.at("humble/a/msg/B"));
  EXPECT_NE(type_hash(types.at("a/msg/C"), types), type_hash(types.at("humble/a/msg/C"), types));
  EXPECT_THAT(class_definition(own_user.structs[0], types), HasSubstr("namespace humble::a::msg {"));
  EXPECT_THAT(class_definition(own_user.structs[0], types), HasSubstr("::humble::a::msg::B b_{};"));
  EXPECT_THAT(class_definition(user.structs[0], types), HasSubstr("  a::msg::B b_{};"));
}

// Where a distribution has a layout of its own, its messages mean that one, not the base's.
TEST(IdlCompiler, RefusesTheBaseWhereADistributionHasItsOwn) {
  const std::string own = "distros/humble/a/msg/B.idl";
  const auto user = [&](const std::string& included) {
    return parse("#include \"" + included + "\"\n" + in_module("struct C { a::msg::B b; };"),
                 "distros/humble/a/msg/C.idl");
  };
  const File base = parse(in_module("struct B { float x; };"), "a/msg/B.idl");
  const File variant = parse(in_module("struct B { double x; };"), own);
  EXPECT_NO_THROW(static_cast<void>(link({base, variant, user(own)})));
  EXPECT_NO_THROW(static_cast<void>(link({base, user("a/msg/B.idl")})));
  try {
    static_cast<void>(link({base, variant, user("a/msg/B.idl")}));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "distros/humble/a/msg/C.idl: C.b has unknown type humble/a/msg/B (missing #include?)");
  }
}

// Through a message of the base a message would hold one type in two layouts.
TEST(IdlCompiler, RefusesTwoLayoutsInOneMessage) {
  const std::string own = "distros/humble/a/msg/B.idl";
  const Types types =
      link({parse(in_module("struct B { float x; };"), "a/msg/B.idl"),
            parse("#include \"a/msg/B.idl\"\n" + in_module("struct C { a::msg::B b; };"), "a/msg/C.idl"),
            parse(in_module("struct B { double x; };"), own),
            parse("#include \"" + own + "\"\n#include \"a/msg/C.idl\"\n" +
                      in_module("struct D { a::msg::B b; a::msg::C c; };"),
                  "distros/humble/a/msg/D.idl")});
  try {
    static_cast<void>(type_hash(types.at("humble/a/msg/D"), types));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "two layouts of a/msg/B in one message, one of them by a/msg/C");
  }
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
