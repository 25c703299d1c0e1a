// Many clients of one viewer, some of which do not read and some of which come and go. What is asserted here
// are counts; times are the business of viewer_load.sh.
#include "tests/page/load/load.hpp"

#include <csignal>
#include <cstdlib>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

double setting(const char* name, double otherwise) {
  const char* value = std::getenv(name);
  return value ? std::stod(value) : otherwise;
}

/// The port of the address that the program prints.
std::uint16_t port_of(const Process& robot) {
  std::smatch found;
  std::string said;
  eventually([&] {
    said = robot.out() + robot.err();
    return std::regex_search(said, found, std::regex("(?:http|ws)://127\\.0\\.0\\.1:([0-9]+)"));
  });
  return found.empty() ? 0 : static_cast<std::uint16_t>(std::stoi(found[1]));
}

// 80 of 100 clients read, 20 take a byte a second, 10 more open and close 50 times a second. At least 95 % of
// what is published must reach each that reads (row 26), and the robot may take 256 MB for all of them.
TEST(ViewerLoad, WhoReadsGetsEverythingWhateverOthersDo) {
  Process robot({BANDWAGON_PROGRAM, "run", std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml",
                 "--seed", "7", "--page=0", "--stay", "--set", "robot.limits.v_max=0.3"});
  LoadOptions load{
      .port = port_of(robot), .seconds = setting("BANDWAGON_LOAD_SECONDS", 5), .robot = robot.id()};
  ASSERT_NE(load.port, 0) << robot.err();
  const LoadResult result = put_load(load);
  robot.signal(SIGINT);
  EXPECT_TRUE(robot.wait(std::chrono::seconds(20))) << robot.err();

  for (const TopicLoad& topic : result.topics) {
    EXPECT_GT(topic.published, 0U) << topic.topic;
    EXPECT_GE(topic.worst_share, 0.95) << topic.topic << ", of " << topic.published;
  }
  EXPECT_EQ(result.healthy_closed, 0);
  EXPECT_GT(result.flaps, 10U);
  EXPECT_LE(result.memory_mb, 256);
}

}  // namespace
}  // namespace bw::test
