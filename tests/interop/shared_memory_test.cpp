// Fast DDS 2.9.1 aborts beside other releases that use its shared-memory transport: a running process of ours
// has none of it, and leaves nothing behind.
#include "tests/shared_memory.hpp"

#include <gmock/gmock.h>

#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

TEST(SharedMemory, ARunningProcessHasNoneAndLeavesNone) {
  RunningGraph graph;
  // It answers on the wire: all of its transports are up.
  const Outcome echo =
      run_to_end({BANDWAGON_PROGRAM, "topic", "echo", "--once", "/odom"}, std::chrono::seconds(60));
  ASSERT_EQ(echo.status, 0) << echo.err << graph.process().err();
  EXPECT_EQ(in_shared_memory(graph.process().id()), "");
  EXPECT_EQ(graph.stop(), 0);
  EXPECT_EQ(shared_ports_of(std::atoi(std::getenv("ROS_DOMAIN_ID"))), "");
}

}  // namespace
}  // namespace bw::test
