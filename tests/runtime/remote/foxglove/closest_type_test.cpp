// Values of a format that knows one kind of number, as the type that a parameter has.
#include "runtime/remote/foxglove/closest_type.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace bw::foxglove {
namespace {

using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

TEST(ClosestType, NumbersBecomeWhatTheParameterIs) {
  EXPECT_EQ(closest_type(std::int64_t{1}, 0.5), ParameterValue(1.0));
  EXPECT_EQ(closest_type(2.0, std::int64_t{7}), ParameterValue(std::int64_t{2}));
  EXPECT_EQ(closest_type(Integers{1, 2}, Doubles{0.5}), ParameterValue(Doubles{1.0, 2.0}));
  EXPECT_EQ(closest_type(Doubles{3.0}, Integers{}), ParameterValue(Integers{3}));
  EXPECT_EQ(closest_type(Integers{0, 255}, std::vector<std::uint8_t>{}),
            ParameterValue(std::vector<std::uint8_t>{0, 255}));
  EXPECT_EQ(closest_type(Doubles{}, std::vector<std::string>{"a"}),
            ParameterValue(std::vector<std::string>{}));
}

// The node says what is wrong with it.
TEST(ClosestType, WhatWouldLoseSomethingStaysAsItIs) {
  EXPECT_EQ(closest_type(2.5, std::int64_t{7}), ParameterValue(2.5));
  EXPECT_EQ(closest_type(1e300, std::int64_t{7}), ParameterValue(1e300));
  EXPECT_EQ(closest_type(Doubles{0.5}, Integers{1}), ParameterValue(Doubles{0.5}));
  EXPECT_EQ(closest_type(Integers{256}, std::vector<std::uint8_t>{}), ParameterValue(Integers{256}));
  EXPECT_EQ(closest_type(std::string("1"), 0.5), ParameterValue(std::string("1")));
  EXPECT_EQ(closest_type(std::string(), Doubles{}), ParameterValue(std::string()));
  EXPECT_EQ(closest_type(Doubles{}, 0.5), ParameterValue(Doubles{}));
}

}  // namespace
}  // namespace bw::foxglove
