// A port with a guardian, on an emulated cable: whoever ends how, the device is told to stand. Expected bytes
// are those of guardian_protocol.hpp: the stop frame at once, and again while nobody has given the port up.
// Nothing is measured here but that it comes; how soon, tests/faults/kill_base.cpp tells.
#include "runtime/serial/guarded_port.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/runtime/serial/cable.hpp"

namespace bw::test {
namespace {

const std::string kStop = "S\n";

/// Process ids of the guardians that `parent` has started and that have not ended.
std::vector<pid_t> guardians_of(pid_t parent) {
  std::vector<pid_t> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    if (!std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c) != 0; })) continue;
    std::string words;
    std::getline(std::ifstream(entry.path() / "cmdline"), words);  // nothing of one that ends meanwhile
    const std::string wanted = std::string("bandwagon_port_guardian") + '\0' + std::to_string(parent) + '\0';
    if (words.starts_with(wanted)) found.push_back(std::stoi(name));
  }
  return found;
}

/// The one of this process, as soon as its name is there; -1: none.
pid_t own_guardian() {
  std::vector<pid_t> found;
  static_cast<void>(eventually([&] { return !(found = guardians_of(getpid())).empty(); }));
  return found.size() == 1 ? found.front() : -1;
}

struct Guarded {
  Folder folder;
  PseudoTerminal device{folder / "cable"};

  std::unique_ptr<GuardedPort> port(std::string guardian = {}) {
    device.update(now());
    return std::make_unique<GuardedPort>(
        std::make_unique<SerialPort>(PortOptions{.port = (folder / "cable").string(), .baud = 115'200}),
        bytes_of(kStop), std::move(guardian));
  }
  /// A process that opens the port and does `then` for ever.
  pid_t process(const std::function<void(GuardedPort&)>& then) {
    device.update(now());
    const pid_t child = fork();
    if (child != 0) return child;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const auto host = port();
    opens(*host);
    for (;;) {
      host->update(now());
      then(*host);
      poll(nullptr, 0, 5);  // the period of a driver's look at its port
    }
  }
  /// Bytes that the device heard, until `end` of them is `words`.
  bool hears(const std::string& words) {
    return eventually([&] {
      const auto bytes = device.read();
      heard.append(bytes.begin(), bytes.end());
      return heard.find(words) != std::string::npos;
    });
  }
  bool leaves_nobody(pid_t parent) {
    return eventually([&] { return guardians_of(parent).empty(); });
  }
  std::string heard;
};

const std::function<void(GuardedPort&)> kDrives = [](GuardedPort& port) { port.write(bytes_of("D\n")); };

void end(pid_t child) {
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

TEST(GuardedPort, CarriesBytesAndIsGivenUpWithAStop) {
  Guarded base;
  auto port = base.port();
  ASSERT_TRUE(opens(*port)) << port->update(now()).fault;
  EXPECT_NE(own_guardian(), -1);
  EXPECT_TRUE(port->write(bytes_of("go\n")));
  EXPECT_TRUE(base.hears("go\n"));
  base.device.write(bytes_of("counts"));
  EXPECT_EQ(reads(*port, 6), "counts");
  port.reset();
  EXPECT_TRUE(guardians_of(getpid()).empty()) << "it is waited for";
  EXPECT_TRUE(base.hears(kStop));
}

TEST(GuardedPort, AProcessThatIsKilledLeavesAStopAndNobody) {
  for (const int signal : {SIGKILL, SIGABRT, SIGSEGV}) {
    Guarded base;
    const pid_t child = base.process(kDrives);
    ASSERT_TRUE(base.hears("D\nD\n"));
    kill(child, signal);
    EXPECT_TRUE(base.hears(kStop + kStop + kStop)) << strsignal(signal);
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(base.leaves_nobody(child));
    EXPECT_EQ(base.heard.find('D', base.heard.find(kStop)), std::string::npos) << base.heard;
  }
}

TEST(GuardedPort, AProcessThatIsStoppedIsStoppedForUntilItOpensThePortAnew) {
  Guarded base;
  const pid_t child = base.process(kDrives);
  ASSERT_TRUE(base.hears("D\nD\n"));
  kill(child, SIGSTOP);
  ASSERT_TRUE(base.hears(kStop + kStop + kStop + kStop + kStop)) << "it goes on saying so";
  base.heard.clear();
  kill(child, SIGCONT);
  // It drives again only with another guardian: after a stop of its own.
  ASSERT_TRUE(base.hears("D\n"));
  EXPECT_GE(base.heard.find('D'), 2 * kStop.size()) << base.heard;
  EXPECT_TRUE(base.heard.starts_with(kStop) || base.heard.starts_with(kStop.substr(1))) << base.heard;
  end(child);
  EXPECT_TRUE(base.leaves_nobody(child));
}

TEST(GuardedPort, AGuardianThatIsKilledIsMissedAndTheProcessStopsTheBase) {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    Guarded base;
    auto port = base.port();
    ASSERT_TRUE(opens(*port));
    const pid_t guardian = own_guardian();
    ASSERT_NE(guardian, -1);
    kill(guardian, signal);
    EXPECT_TRUE(says(*port, "the guardian of " + (base.folder / "cable").string() + " is gone"));
    EXPECT_TRUE(base.hears(kStop));
    EXPECT_FALSE(port->write(bytes_of("go\n"))) << "not without a guardian";
    ASSERT_TRUE(opens(*port)) << "with another one";
    EXPECT_EQ(port->update(now()).openings, 2U);
    EXPECT_NE(own_guardian(), guardian);
    EXPECT_TRUE(port->write(bytes_of("go\n")));
  }
}

TEST(GuardedPort, CtrlCAndItsLikeAreNotForTheGuardian) {
  Guarded base;
  auto port = base.port();
  ASSERT_TRUE(opens(*port));
  const pid_t guardian = own_guardian();
  ASSERT_NE(guardian, -1);
  EXPECT_EQ(getsid(guardian), guardian) << "a session of its own: no signal of a terminal reaches it";
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGPIPE, SIGUSR1, SIGABRT})
    kill(guardian, signal);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(opens(*port));
  EXPECT_EQ(guardians_of(getpid()), std::vector<pid_t>{guardian});
}

TEST(GuardedPort, WithoutAGuardianItIsNotOpen) {
  Guarded base;
  auto port = base.port("/no/such/guardian");
  EXPECT_TRUE(says(*port, "its guardian /no/such/guardian cannot be started: No such file"));
  EXPECT_FALSE(port->write(bytes_of("go\n")));
}

// Another process that hangs from then on tells the time: its guardian says the fourth stop 150 ms after it
// has found the hang.
TEST(GuardedPort, WhoRestsIsNotTakenForHung) {
  Guarded base, other;
  const pid_t hung = other.process(kDrives);  // forked before this process has threads
  ASSERT_TRUE(other.hears("D\n"));
  auto port = base.port();
  ASSERT_TRUE(opens(*port));
  port->update(now());
  port->rest();
  kill(hung, SIGSTOP);
  ASSERT_TRUE(other.hears(kStop + kStop + kStop + kStop));
  end(hung);
  EXPECT_TRUE(port->update(now()).is_open);
  EXPECT_EQ(port->update(now()).openings, 1U);
  EXPECT_TRUE(port->write(bytes_of("go\n")));
  EXPECT_TRUE(base.hears("go\n"));
  EXPECT_EQ(base.heard, "go\n");
}

TEST(GuardedPort, AProcessKilledWhileItStartsLeavesNobody) {
  for (int i = 0; i < 21; ++i) {
    Guarded base;
    const pid_t child = base.process(kDrives);
    // At once, when its guardian is there, at its first bytes.
    const bool has_come = i % 3 == 0 || (i % 3 == 1 ? eventually([&] { return !guardians_of(child).empty(); })
                                                    : base.hears("D"));
    EXPECT_TRUE(has_come);
    end(child);
    EXPECT_TRUE(base.leaves_nobody(child)) << "try " << i;
  }
}

}  // namespace
}  // namespace bw::test
