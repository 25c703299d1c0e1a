#include "components/slam/odometry_history.hpp"

#include <gtest/gtest.h>

namespace bw::slam {
namespace {

TEST(OdometryHistory, InterpolatesWithinWhatItKeepsAndNowhereElse) {
  OdometryHistory history;
  EXPECT_FALSE(history.at(Time::seconds(1.0)));
  for (int k = 0; k <= 100; ++k) EXPECT_TRUE(history.add(Time::seconds(0.1 * k), {0.1 * k, 0.0, 0.0}));
  EXPECT_TRUE(history.covers(Time::seconds(10.0)));
  EXPECT_FALSE(history.covers(Time::seconds(10.01)));
  EXPECT_TRUE(history.began_after(Time::seconds(4.9)));
  EXPECT_FALSE(history.began_after(Time::seconds(5.0)));
  EXPECT_FALSE(history.at(Time::seconds(4.9))) << "5 s are kept";
  EXPECT_FALSE(history.at(Time::seconds(10.01)));
  EXPECT_NEAR(history.at(Time::seconds(7.53))->x, 7.53, 1e-9);
  EXPECT_EQ(history.at(Time::seconds(10.0))->x, 10.0);
  history.add(Time::seconds(12.0), {12.0, 0.0, 0.0});
  EXPECT_FALSE(history.at(Time::seconds(11.0))) << "a gap of 2 s";
  EXPECT_FALSE(history.add(Time::seconds(1.0), {})) << "the clock went back";
  EXPECT_EQ(history.newest(), Time::seconds(1.0));
  EXPECT_FALSE(history.at(Time::seconds(12.0)));
}

}  // namespace
}  // namespace bw::slam
