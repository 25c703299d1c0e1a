#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

#include "runtime/serial/emulator_path.hpp"
#include "tests/runtime/serial/cable.hpp"

namespace bw::test {
namespace {

TEST(PseudoTerminal, LeavesNoLinkBehind) {
  Folder folder;
  {
    PseudoTerminal device(folder / "cable");
    EXPECT_TRUE(device.update(now()).is_open);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "cable"));
    EXPECT_EQ(device.update(now()).openings, 1U);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(PseudoTerminal, GoesOnWhileNobodyListens) {
  Folder folder;
  PseudoTerminal device(folder / "cable");
  device.update(now());
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(device.write(std::vector<std::uint8_t>(1000, 1)));
  EXPECT_TRUE(device.read().empty());
  EXPECT_TRUE(device.update(now()).is_open);
}

TEST(PseudoTerminal, ASecondEmulatorOfTheNameIsRefusedAndLeavesTheFirstAlone) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  {
    PseudoTerminal second(cable.folder / "cable");
    EXPECT_FALSE(second.update(now()).is_open);
    EXPECT_THAT(second.update(now()).fault, testing::HasSubstr("belongs to another emulator"));
  }
  EXPECT_TRUE(cable.host.write(bytes_of("hello")));
  EXPECT_EQ(reads(cable.device, 5), "hello");
  EXPECT_TRUE(std::filesystem::exists(cable.folder / "cable"));
}

// A killed emulator cannot remove its link. Whatever terminal has its number by then, the link leads nowhere.
TEST(PseudoTerminal, TheLinkOfAKilledEmulatorLeadsNowhereAndIsTakenOver) {
  Folder folder;
  const pid_t child = fork();
  if (child == 0) {
    PseudoTerminal device(folder / "cable");
    _exit(device.update(now()).is_open ? 0 : 1);  // without destructors, as by SIGKILL
  }
  int status = 1;
  waitpid(child, &status, 0);
  ASSERT_EQ(WEXITSTATUS(status), 0);
  ASSERT_TRUE(std::filesystem::is_symlink(folder / "cable"));
  EXPECT_FALSE(std::filesystem::exists(folder / "cable"));
  SerialPort host({.port = (folder / "cable").string()});
  EXPECT_TRUE(says(host, "no such device"));
  PseudoTerminal device(folder / "cable");
  EXPECT_TRUE(device.update(now()).is_open);
  EXPECT_TRUE(opens(host));
}

TEST(PseudoTerminal, AFolderThatIsNotThereIsSaid) {
  Folder folder;
  PseudoTerminal device(folder / "nowhere" / "cable");
  EXPECT_FALSE(device.update(now()).is_open);
  EXPECT_THAT(device.update(now()).fault, testing::HasSubstr("cannot make"));
}

TEST(EmulatorPath, DiffersByNameAndDomain) {
  EXPECT_NE(emulator_path("base", 1), emulator_path("base", 2));
  EXPECT_NE(emulator_path("base", 1), emulator_path("laser", 1));
  EXPECT_EQ(emulator_path("base", 1), emulator_path("base", 1));
}

}  // namespace
}  // namespace bw::test
