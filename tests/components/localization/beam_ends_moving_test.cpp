#include <gtest/gtest.h>

#include "components/localization/laser/beam_ends.hpp"
#include "components/model/sweep_motion.hpp"
#include "tests/components/model/moving_sweep.hpp"

namespace bw::localization {
namespace {

// The robot rotates while the sweep is taken; ends are wanted where base_link is in its middle, from which
// the wall is at x = 2.5.
TEST(BeamEndsMoving, EndsAreOfTheTimeOfTheSweep) {
  test::MovingSweep moving{.twist = {0.4, 1.5}};
  LaserSweep sweep = moving.scan();
  const std::vector<Pose2> poses =
      beam_poses(sweep, moving.X_BL, [&](Time time) { return moving.X_OB(time); });
  sweep.beam_poses = poses;
  const BeamEnds ends = beam_ends(sweep, 60);
  ASSERT_GT(ends.size(), 20U);
  for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends.x[i], 2.5, 1e-5) << i;
  sweep.beam_poses = {};
  float farthest = 0.0F;
  for (const float x : beam_ends(sweep, 60).x) farthest = std::max(farthest, std::abs(x - 2.5F));
  EXPECT_GT(farthest, 0.2F);
}

}  // namespace
}  // namespace bw::localization
