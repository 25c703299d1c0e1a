// Values of parameters: there and back, and what is refused.
#include "runtime/remote/foxglove/parameter_json.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/base64.hpp"

namespace bw::foxglove {
namespace {

using nlohmann::json;

ParameterValue back(const ParameterValue& value) {
  const json written = json::parse(parameter_json({"/a.b", value}).dump());
  EXPECT_EQ(written.at("name"), "/a.b");
  if (!written.contains("value")) return {};
  const auto type =
      written.contains("type") ? std::optional(written.at("type").get<std::string>()) : std::nullopt;
  const auto read = parameter_value_of(written.at("value"), type);
  EXPECT_TRUE(std::holds_alternative<ParameterValue>(read)) << written.dump();
  return std::holds_alternative<ParameterValue>(read) ? std::get<ParameterValue>(read) : ParameterValue();
}

TEST(ParameterJson, EveryTypeComesBack) {
  const std::vector<ParameterValue> values = {{},
                                              true,
                                              std::int64_t{-3},
                                              std::numeric_limits<std::int64_t>::max(),
                                              std::numeric_limits<std::int64_t>::min(),
                                              1.0,
                                              -0.1,
                                              std::string("text \"quoted\""),
                                              std::vector<std::uint8_t>{0, 255, 16},
                                              std::vector<bool>{true, false},
                                              std::vector<std::int64_t>{1, 2},
                                              std::vector<double>{1.0, 2.5},
                                              std::vector<std::string>{"a", ""}};
  for (const ParameterValue& value : values) EXPECT_EQ(back(value), value) << to_yaml_text(value);
}

TEST(ParameterJson, TypesStandWhereJsonWouldLoseThem) {
  EXPECT_EQ(parameter_json({"a", 3.0}).dump(), R"({"name":"a","value":3.0,"type":"float64"})");
  EXPECT_EQ(parameter_json({"a", std::vector<double>{1.0}}).dump(),
            R"({"name":"a","value":[1.0],"type":"float64_array"})");
  EXPECT_EQ(parameter_json({"a", std::vector<std::uint8_t>{16, 32, 48}}).dump(),
            R"({"name":"a","value":"ECAw","type":"byte_array"})");
  EXPECT_EQ(parameter_json({"a", std::int64_t{3}}).dump(), R"({"name":"a","value":3})");
}

TEST(ParameterJson, WhatJsonDoesNotHaveIsAString) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parameter_json({"a", kInfinity}).dump(), R"({"name":"a","value":"inf"})");
  EXPECT_EQ(parameter_json({"a", std::vector<double>{1.0, -kInfinity, std::nan("")}}).dump(),
            R"({"name":"a","value":[1.0,"-inf","nan"]})");
}

TEST(ParameterJson, NumbersOfJavaScript) {
  const auto read = [](const char* text, std::optional<std::string> type = std::nullopt) {
    return std::get<ParameterValue>(parameter_value_of(json::parse(text), type));
  };
  EXPECT_EQ(read("[1, 2.5]"), ParameterValue((std::vector<double>{1.0, 2.5})));
  EXPECT_EQ(read("[1, 2]", "float64_array"), ParameterValue((std::vector<double>{1.0, 2.0})));
  EXPECT_EQ(read("3", "float64"), ParameterValue(3.0));
  EXPECT_EQ(read("[]"), ParameterValue(std::vector<std::string>{}));
  EXPECT_EQ(read("[]", "float64_array"), ParameterValue(std::vector<double>{}));
  EXPECT_EQ(read("18446744073709551615"), ParameterValue(18446744073709551615.0));
}

TEST(ParameterJson, RulesAreTold) {
  const auto rule = [](const char* text, std::optional<std::string> type = std::nullopt) {
    const auto read = parameter_value_of(json::parse(text), type);
    const auto* broken = std::get_if<BrokenRule>(&read);
    return broken == nullptr ? std::string() : std::string(broken->text);
  };
  EXPECT_EQ(rule("{}"), "must be a number, boolean, string or an array of these");
  EXPECT_EQ(rule("[1, \"a\"]"), "must be an array of one kind: numbers, booleans or strings");
  EXPECT_EQ(rule("[[1]]"), "must be an array of one kind: numbers, booleans or strings");
  EXPECT_EQ(rule("[null]"), "must be an array of one kind: numbers, booleans or strings");
  EXPECT_EQ(rule("\"1\"", "float64"), "must be a number, as its type float64 says");
  EXPECT_EQ(rule("[1]", "float64"), "must be a number, as its type float64 says");
  EXPECT_EQ(rule("1", "float64_array"), "must be an array of numbers, as its type float64_array says");
  EXPECT_EQ(rule("[true]", "float64_array"), "must be an array of numbers, as its type float64_array says");
  EXPECT_EQ(rule("7", "byte_array"), "must be a string in base64, as its type byte_array says");
  EXPECT_EQ(rule("\"a\"", "byte_array"), "must be a string in base64, as its type byte_array says");
  EXPECT_EQ(rule("7", "int"), "has a type that is none of byte_array, float64, float64_array");
}

// RFC 4648, section 10, and what is not canonical.
TEST(Base64, VectorsOfTheStandard) {
  const std::vector<std::pair<std::string, std::string>> vectors = {{"", ""},
                                                                    {"f", "Zg=="},
                                                                    {"fo", "Zm8="},
                                                                    {"foo", "Zm9v"},
                                                                    {"foob", "Zm9vYg=="},
                                                                    {"fooba", "Zm9vYmE="},
                                                                    {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : vectors) {
    const std::vector<std::uint8_t> bytes(plain.begin(), plain.end());
    EXPECT_EQ(to_base64(bytes), coded);
    EXPECT_EQ(from_base64(coded), bytes);
  }
  for (const char* bad : {"Z", "Zg", "Zg=", "Z===", "Zh==", "Zm9=", "Zm 9", "=Zm9", "Zg==Zg==", "Zm-_"})
    EXPECT_EQ(from_base64(bad), std::nullopt) << bad;
}

}  // namespace
}  // namespace bw::foxglove
