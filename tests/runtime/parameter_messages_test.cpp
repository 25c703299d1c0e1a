// Parameters on the wire, and which names a listing gives. Expected names follow rclcpp's rule: a prefix
// stands for itself and what is below it, depth counts parts below the prefix.
#include "runtime/ros/parameter_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::string> kNames = {"rate",   "teb.time", "teb.weights.wall", "teb.weights.time",
                                         "tebbed", "hrvo.time"};

std::vector<std::string> names(const std::vector<std::string>& prefixes, std::uint64_t depth) {
  return list_names(kNames, prefixes, depth).names();
}

TEST(ListNames, GivesWhatLiesBelowThePrefixes) {
  EXPECT_EQ(names({}, 0), kNames);
  EXPECT_THAT(names({"teb"}, 0), ElementsAre("teb.time", "teb.weights.wall", "teb.weights.time"));
  EXPECT_THAT(names({"rate"}, 0), ElementsAre("rate"));
  EXPECT_THAT(names({"teb.weights", "hrvo"}, 0),
              ElementsAre("teb.weights.wall", "teb.weights.time", "hrvo.time"));
  EXPECT_THAT(names({"te", "", "teb."}, 0), IsEmpty());
}

TEST(ListNames, CountsDepthBelowThePrefix) {
  EXPECT_THAT(names({}, 1), ElementsAre("rate", "tebbed"));
  EXPECT_THAT(names({}, 2), ElementsAre("rate", "teb.time", "tebbed", "hrvo.time"));
  EXPECT_THAT(names({"teb"}, 1), ElementsAre("teb.time"));
  EXPECT_THAT(names({"teb"}, 2), ElementsAre("teb.time", "teb.weights.wall", "teb.weights.time"));
}

TEST(ListNames, NamesEachSectionOnce) {
  EXPECT_THAT(list_names(kNames, {}, 0).prefixes(), ElementsAre("teb", "teb.weights", "hrvo"));
}

TEST(ParameterMessages, CarryEveryType) {
  using Integers = std::vector<std::int64_t>;
  const std::vector<ParameterValue> values = {std::monostate{},
                                              true,
                                              std::int64_t{-3},
                                              0.25,
                                              "text",
                                              std::vector<std::uint8_t>{0, 255},
                                              std::vector<bool>{true, false},
                                              Integers{1, -2},
                                              std::vector<double>{0.5},
                                              std::vector<std::string>{"a", ""}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const rcl_interfaces::msg::ParameterValue message = to_message(values[i]);
    EXPECT_EQ(message.type(), i);
    EXPECT_EQ(from_message(message), values[i]);
  }
  rcl_interfaces::msg::ParameterValue unknown;
  unknown.type(10);
  EXPECT_EQ(from_message(unknown), ParameterValue());
}

TEST(ParameterMessages, DescribeRanges) {
  const auto message = to_message("rate", {.type = ParameterType::floating_point,
                                           .description = "cycles [Hz]",
                                           .additional_constraints = "must be at least 1 Hz",
                                           .read_only = true,
                                           .double_range = DoubleRange{1.0, 2.0},
                                           .integer_range = std::nullopt});
  EXPECT_EQ(message.name(), "rate");
  EXPECT_EQ(message.type(), 3);
  EXPECT_EQ(message.description(), "cycles [Hz]");
  EXPECT_EQ(message.additional_constraints(), "must be at least 1 Hz");
  EXPECT_TRUE(message.read_only());
  EXPECT_FALSE(message.dynamic_typing());
  ASSERT_EQ(message.floating_point_range().size(), 1U);
  EXPECT_EQ(message.floating_point_range()[0].from_value(), 1.0);
  EXPECT_EQ(message.floating_point_range()[0].to_value(), 2.0);
  EXPECT_EQ(message.floating_point_range()[0].step(), 0.0);
  EXPECT_TRUE(message.integer_range().empty());
}

}  // namespace
}  // namespace bw
