// Each sample once, and what is missing is counted.
#include "runtime/recording/record/writer_intake.hpp"

#include <gtest/gtest.h>

namespace bw::record {
namespace {

constexpr bool kOwn = true;
constexpr bool kOther = false;

TEST(WriterIntake, CountsTheGaps) {
  WriterIntake intake;
  EXPECT_TRUE(intake.accept(5, kOwn)) << "it was there before us";
  EXPECT_TRUE(intake.accept(6, kOwn));
  EXPECT_TRUE(intake.accept(10, kOwn));
  EXPECT_EQ(intake.lost(), 3U);  // 7, 8, 9
}

TEST(WriterIntake, TakesNoSampleTwice) {
  WriterIntake intake;
  EXPECT_TRUE(intake.accept(1, kOwn));
  EXPECT_FALSE(intake.accept(1, kOther));
  EXPECT_FALSE(intake.accept(2, kOther)) << "the own reader will bring it";
  EXPECT_TRUE(intake.accept(2, kOwn));
  EXPECT_EQ(intake.lost(), 0U);
}

TEST(WriterIntake, AnotherReaderCountsUntilTheOwnOneSpeaks) {
  // The writer is latched: a reader for best-effort writers heard 3 and 4 before there was one for it.
  WriterIntake intake;
  EXPECT_TRUE(intake.accept(3, kOther));
  EXPECT_TRUE(intake.accept(4, kOther));
  EXPECT_TRUE(intake.accept(1, kOwn)) << "what was latched comes now";
  EXPECT_TRUE(intake.accept(2, kOwn));
  EXPECT_FALSE(intake.accept(3, kOwn));
  EXPECT_FALSE(intake.accept(4, kOwn));
  EXPECT_FALSE(intake.accept(5, kOther));
  EXPECT_TRUE(intake.accept(5, kOwn));
  EXPECT_EQ(intake.lost(), 0U);
}

}  // namespace
}  // namespace bw::record
