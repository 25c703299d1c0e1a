// The line of text that a killed localization leaves for the next one.
#include "components/localization/adaptor/kept_pose_text.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace bw::localization {
namespace {

KeptPose kept() {
  KeptPose k{
      .time = Time::seconds(10.0), .X_OB = {1.0, 0.0, 0.0}, .X_MB = {5.0, 5.0, 0.5 * std::numbers::pi}};
  k.covariance << 0.01, 0.001, 0.0, 0.001, 0.02, 0.0, 0.0, 0.0, 0.0004;
  return k;
}

TEST(KeptPoseText, ReadsBackToTheBit) {
  const auto read = kept_pose(to_text(kept()));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->time, kept().time);
  EXPECT_EQ(read->X_OB, kept().X_OB);
  EXPECT_EQ(read->X_MB, kept().X_MB);
  EXPECT_EQ(read->covariance, kept().covariance);
}

TEST(KeptPoseText, WhatIsNoneIsNothing) {
  const std::string whole = to_text(kept());
  for (std::size_t end = whole.find(' '); end != std::string::npos; end = whole.find(' ', end + 1))
    EXPECT_FALSE(kept_pose(whole.substr(0, end))) << end;
  EXPECT_FALSE(kept_pose("nan nan nan nan nan nan nan nan nan nan nan nan nan"));
  EXPECT_FALSE(kept_pose("1 0 0 0 0 0 0 -1 0 0 1 0 1"));  // a negative variance
  EXPECT_FALSE(kept_pose("1 0 0 0 0 0 0 inf 0 0 1 0 1"));
}

}  // namespace
}  // namespace bw::localization
