// An independent DDS hears our odometry and drives our robot: Eclipse Cyclone DDS, C, its own code generator,
// the same IDL.
#include <gmock/gmock.h>

#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

TEST(Cyclone, HearsOdometryAndDrivesOverCmdVel) {
  RunningGraph graph;
  const Outcome driver = run_to_end({CYCLONE_DRIVER}, std::chrono::seconds(120));
  // The driver itself demands 0.5 m of odometry and then a standing robot.
  EXPECT_EQ(driver.status, 0) << driver.out << driver.err << graph.process().err();
  EXPECT_THAT(driver.out, HasSubstr("participant: / enclave=/;")) << "as rmw_fastrtps announces itself";
  EXPECT_THAT(driver.out, HasSubstr("odometry: odom to base_link"));
  // 720 beams by default; the wall of drive.yaml stands 8 m ahead, the range noise is centimetres.
  EXPECT_THAT(driver.out, testing::ContainsRegex("scan: 720 ranges, (7\\.9|8\\.0)[0-9] m ahead"));
  // 40 m / 0.05 m in both directions, in many fragments, latched before the driver came.
  EXPECT_THAT(driver.out, HasSubstr("map: 800 x 800 cells, 640000 bytes, with walls"));
  EXPECT_EQ(graph.stop(), 0) << graph.process().err();
}

}  // namespace
}  // namespace bw::test
