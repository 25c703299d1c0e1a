// Goals by `ros2 topic pub --once`: the participant that sends one leaves a tenth of a second later, and the
// goal counts.
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

/// A navigator whose neighbours are elsewhere: it takes goals and says so in its log.
constexpr const char* kGraph = R"(components:
  navigator:
    inputs:
      goal_pose: {external: true}
      cancel_goal: {external: true}
      odometry/filtered: {external: true}
      plan_result: {external: true}
      follow_status: {external: true}
)";

/// Participants for each kind of tool; both kinds send at the same time.
int goals() {
  const char* asked = std::getenv("BANDWAGON_GOALS_BY_ONCE");
  return (asked != nullptr ? std::atoi(asked) : 16) / 2;
}

bool was_taken(const std::string& log, int x) {
  return log.find(": to (" + std::to_string(x) + ".00, ") != std::string::npos;
}

TEST(GoalsByOnce, AreAllTaken) {
  const std::string graph = (std::filesystem::temp_directory_path() / "goal_once.yaml").string();
  std::ofstream(graph) << kGraph;
  Process taker({BANDWAGON_PROGRAM, "run", graph});
  // Who comes while it starts may know its readers before it is known itself. Fast DDS 3 hands out what it has to say of
  // its writers a tenth of a second after it was asked, and the tool is gone by then.
  const auto is_up = [] {
    Process asked({BANDWAGON_PROGRAM, "lifecycle", "get", "navigator"});
    return asked.wait(std::chrono::seconds(20)) == 0 && asked.out() == "active [3]\n";
  };
  ASSERT_TRUE(eventually(is_up)) << taker.err();
  const int count = goals();
  Process humble({GOAL_ONCE, "humble", "1", std::to_string(count)});
  Process jazzy({GOAL_ONCE, "jazzy", std::to_string(count + 1), std::to_string(count)});
  const auto limit = std::chrono::seconds(30 + 5 * count);
  ASSERT_EQ(humble.wait(limit), 0) << humble.err();
  ASSERT_EQ(jazzy.wait(limit), 0) << jazzy.err();
  int taken = 0;
  const auto count_taken = [&] {
    const std::string log = taker.err();
    taken = 0;
    for (int x = 1; x <= 2 * count; ++x) taken += was_taken(log, x) ? 1 : 0;
    return taken == 2 * count;
  };
  EXPECT_EQ(humble.out().find("unmatched"), std::string::npos) << humble.out();
  EXPECT_EQ(jazzy.out().find("unmatched"), std::string::npos) << jazzy.out();
  EXPECT_TRUE(eventually(count_taken)) << taken << " of " << 2 * count << "\n" << taker.err();
  taker.signal(SIGINT);
  EXPECT_EQ(taker.wait(std::chrono::seconds(20)), 0) << taker.err();
}

}  // namespace
}  // namespace bw::test
