// Standard input that never waits for longer than asked, on a terminal and on a pipe. Expected: what a person
// types comes as it is; an empty terminal gives nothing, at once, and is not over; a closed one is over.
#include "runtime/cli/standard_input.hpp"

#include <array>
#include <cstdio>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

namespace bw::cli {
namespace {

/// Stdin is `descriptor` as long as this lives.
class AsStdin {
 public:
  explicit AsStdin(int descriptor) : before_(dup(STDIN_FILENO)) { dup2(descriptor, STDIN_FILENO); }
  ~AsStdin() {
    dup2(before_, STDIN_FILENO);
    close(before_);
  }
  AsStdin(const AsStdin&) = delete;
  AsStdin& operator=(const AsStdin&) = delete;

 private:
  int before_;
};

struct Terminal {
  Terminal() { EXPECT_EQ(openpty(&master, &slave, nullptr, nullptr, nullptr), 0); }
  ~Terminal() {
    close(slave);
    close(master);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  void type(std::string_view keys) const {
    ASSERT_EQ(write(master, keys.data(), keys.size()), std::ssize(keys));
  }

  int master = -1, slave = -1;
};

constexpr Duration kLong = Duration::milliseconds(20'000);

// Ctrl-C between poll() and read() throws the typed line away: a read that blocks then never sees that it was
// interrupted.
TEST(StandardInput, DoesNotWaitForALineThatWasThrownAway) {
  const Terminal terminal;
  const AsStdin as(terminal.slave);
  StandardInput input;
  terminal.type("y\n");
  tcflush(terminal.slave, TCIFLUSH);  // as the terminal does for Ctrl-C
  EXPECT_EQ(input.take(), std::nullopt);
  EXPECT_FALSE(input.is_over());
  terminal.type("n\n");
  EXPECT_EQ(input.wait(kLong), "n\n");
}

TEST(StandardInput, LeavesTheTerminalOfTheShellAsItWas) {
  const Terminal terminal;
  const AsStdin as(terminal.slave);
  const StandardInput input;
  EXPECT_EQ(fcntl(STDIN_FILENO, F_GETFL) & O_NONBLOCK, 0);
}

TEST(StandardInput, IsOverWhenItsPipeIs) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const AsStdin as(ends[0]);
  close(ends[0]);
  StandardInput input;
  EXPECT_EQ(input.take(), std::nullopt);
  EXPECT_FALSE(input.is_over());
  ASSERT_EQ(write(ends[1], "last", 4), 4);
  close(ends[1]);
  EXPECT_EQ(input.wait(kLong), "last");
  EXPECT_EQ(input.wait(kLong), std::nullopt);
  EXPECT_TRUE(input.is_over());
}

// A script that has read the first line of its input itself, and leaves the rest to the program.
TEST(StandardInput, GoesOnInAFileWhereOthersStopped) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  std::fputs("first\nsecond\n", file);
  std::fflush(file);
  const AsStdin as(fileno(file));
  lseek(STDIN_FILENO, 6, SEEK_SET);
  StandardInput input;
  EXPECT_EQ(input.wait(kLong), "second\n");
  EXPECT_EQ(input.wait(kLong), std::nullopt);
  EXPECT_TRUE(input.is_over());
  std::fclose(file);
}

}  // namespace
}  // namespace bw::cli
