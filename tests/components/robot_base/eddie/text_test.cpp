// Numbers by hand: 0x10000 - 113 = FF8F, 0x100000000 - 1000 = FFFFFC18.
#include "components/robot_base/eddie/text.hpp"

#include <limits>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::eddie {
namespace {

using testing::ElementsAre;

TEST(EddieText, NumbersAreHexadecimalOf16Bits) {
  EXPECT_EQ(command("VER"), "VER\r");
  EXPECT_EQ(command("STOP", {0}), "STOP 0\r");
  EXPECT_EQ(command("GOSPD", {100, -113}), "GOSPD 64 FF8F\r");
  EXPECT_EQ(command("GOSPD", {32'767, -32'768}), "GOSPD 7FFF 8000\r");
  EXPECT_EQ(command("ACC", {0x7FF}), "ACC 7FF\r");
}

TEST(EddieText, WordsAreTheNearestThatFit) {
  EXPECT_EQ(to_word(0.6), 1);
  EXPECT_EQ(to_word(-1.4), -1);
  EXPECT_EQ(to_word(1e9), 32'767);
  EXPECT_EQ(to_word(-1e9), -32'768);
  EXPECT_EQ(to_word(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(EddieText, DistancesAreOf32Bits) {
  const auto some = distances_of("000000FF FFFFFC18");
  ASSERT_TRUE(some);
  EXPECT_EQ(some->left, 255);
  EXPECT_EQ(some->right, -1000);
  EXPECT_EQ(distances_of("7FFFFFFF 80000000")->left, std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(distances_of("000000FF FFFFFC18 ")->right, -1000);
  EXPECT_EQ(distances_of("7fffffff 80000000")->right, std::numeric_limits<std::int32_t>::min());
  for (const char* wrong :
       {"", "000000FF", "000000FF FFFFFC1", "000000FF  FFFFFC18", "000000FF FFFFFC18 00000000",
        "000000FG FFFFFC18", "-00000FF FFFFFC18", "0x0000FF FFFFFC18", "ERROR"})
    EXPECT_FALSE(distances_of(wrong)) << wrong;
}

TEST(EddieText, ValuesOfThreeDigits) {
  EXPECT_THAT(numbers_of("00A CC6 000", 3).value(), ElementsAre(10U, 3270U, 0U));
  EXPECT_THAT(numbers_of("", 3).value(), ElementsAre());
  EXPECT_FALSE(numbers_of("00A CC 000", 3));
}

TEST(EddieText, ErrorsHaveTheirReason) {
  EXPECT_EQ(error_of("ERROR - Too few parameters"), "Too few parameters");
  EXPECT_EQ(error_of("ERROR"), "");
  EXPECT_FALSE(error_of("0014"));
}

TEST(EddieText, EveryWordComesBack) {
  for (int value = -32'768; value < 32'768; ++value) {
    const std::string text = command("GOSPD", {value});
    const auto read = static_cast<std::int16_t>(std::stoi(text.substr(6), nullptr, 16));
    ASSERT_EQ(read, value);
  }
}

}  // namespace
}  // namespace bw::eddie
