#include "components/slam/leave_out.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace bw::slam {
namespace {

// A person of 0.3 m radius 3 m ahead: what ends within 0.45 m of the middle says nothing, be it the legs or
// the wall close behind; what ends before, beyond or beside, and what met nothing, stays to the bit.
TEST(WithoutPeople, BeamsThatEndAtAPersonSayNothing) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const std::vector<float> ranges{2.5F, 2.6F, 3.0F, 3.4F, 3.5F, kInf};
  LaserSweep sweep;
  sweep.X_FL = {0.0, 0.0, 0.5};
  sweep.angle_min = -0.5;
  sweep.angle_increment = 1e-6;  // all straight ahead of F
  sweep.range_min = 0.05;
  sweep.range_max = 20.0;
  sweep.ranges = ranges;
  const std::vector<Disc> people{{{3.0, 0.0}, 0.3}};
  const std::vector<float> left = without_people(sweep, people);
  ASSERT_EQ(left.size(), 6U);
  for (const std::size_t i : {0U, 4U, 5U}) EXPECT_EQ(left[i], ranges[i]) << i;
  for (const std::size_t i : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(left[i])) << i;
  EXPECT_EQ(without_people(sweep, {}), ranges);
  sweep.angle_increment = 0.2;  // the third 0.4 rad to the left: 1.2 m beside
  EXPECT_EQ(without_people(sweep, people)[2], 3.0F);
}

}  // namespace
}  // namespace bw::slam
