#include "components/model/speed_limit.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace bw {
namespace {

const Limits kRobot{.v_max = 0.8, .v_back_max = 0.2, .omega_max = 1.5};

TEST(SpeedLimit, LowersBothDirectionsAndNoTurnRate) {
  const Limits half = limited(kRobot, {.percentage = true, .value = 50.0});
  EXPECT_DOUBLE_EQ(half.v_max, 0.4);
  EXPECT_DOUBLE_EQ(half.v_back_max, 0.2);
  EXPECT_DOUBLE_EQ(half.omega_max, 1.5);
  const Limits slow = limited(kRobot, {.value = 0.1});
  EXPECT_DOUBLE_EQ(slow.v_max, 0.1);
  EXPECT_DOUBLE_EQ(slow.v_back_max, 0.1);
}

TEST(SpeedLimit, ZeroIsNoneAndTheRobotsOwnStay) {
  for (const SpeedLimit limit : {SpeedLimit{false, 0.0}, {true, 0.0}, {false, 3.0}, {true, 100.0}}) {
    EXPECT_DOUBLE_EQ(limited(kRobot, limit).v_max, 0.8);
    EXPECT_DOUBLE_EQ(limited(kRobot, limit).v_back_max, 0.2);
  }
}

TEST(SpeedLimit, IsAtLeastWhatPlannersPlanWith) {
  EXPECT_DOUBLE_EQ(limited(kRobot, {.value = 1e-9}).v_max, 0.01);
  EXPECT_DOUBLE_EQ(limited({.v_max = 0.8, .v_back_max = 0.0}, {.value = 1e-9}).v_back_max, 0.0);
}

TEST(SpeedLimit, RefusesWhatIsNone) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double value : {kInf, -kInf, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(fault_of(SpeedLimit{.value = value}), "it is not finite");
  EXPECT_EQ(fault_of(SpeedLimit{.value = -0.1}), "it is negative");
  EXPECT_EQ(fault_of(SpeedLimit{.percentage = true, .value = 100.5}), "it is more than 100 %");
  EXPECT_EQ(fault_of(SpeedLimit{.percentage = true, .value = 100.0}), "");
  EXPECT_EQ(fault_of(SpeedLimit{.value = 100.5}), "");
}

}  // namespace
}  // namespace bw
