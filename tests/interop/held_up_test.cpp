// An emulated robot whose process is held up now and then, as by a busy machine: nothing is wrong with the
// wheels, and nobody may say so.
#include <chrono>
#include <csignal>

#include <gmock/gmock.h>

#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;

class HeldUp : public testing::TestWithParam<const char*> {};

// Six metres in 12 s and more; held up for a third of a second from the fifth second on, six times. Wheels
// that stall, run away or contradict a command are latched until release_stop. That it is not heard meanwhile
// interrupts the goal, which would need one too: here it may go on by itself.
TEST_P(HeldUp, IsNoFaultOfTheWheels) {
  const Folder folder;
  const std::string root = BANDWAGON_SOURCE_DIR;
  Process robot({BANDWAGON_PROGRAM, "run", root + "/config/graphs/hallway.yaml", "--emulate", "--for", "60",
                 "--set", "robot=" + root + "/config/robots/" + GetParam() + ".yaml", "--set",
                 "navigator.goal.x=7.0", "--set", "world.people.social.walkers=[]", "--set",
                 "robot_base.restart.link=by_itself", "--set", "robot_base.restart.device=by_itself",
                 "--json", folder / "card.json"});
  ASSERT_FALSE(robot.wait(milliseconds(5000))) << robot.err();
  for (int i = 0; i < 6; ++i) {
    robot.signal(SIGSTOP);
    ASSERT_FALSE(robot.wait(milliseconds(330)));
    robot.signal(SIGCONT);
    ASSERT_FALSE(robot.wait(milliseconds(900))) << robot.err();
  }
  const std::optional<int> status = robot.wait(milliseconds(60000));
  EXPECT_EQ(status, 0) << robot.err();
  EXPECT_THAT(robot.err(), Not(HasSubstr("until release_stop")));
}

INSTANTIATE_TEST_SUITE_P(Bases, HeldUp, testing::Values("kobuki", "eddie"));

}  // namespace
}  // namespace bw::test
