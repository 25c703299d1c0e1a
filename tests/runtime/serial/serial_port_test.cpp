#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <random>

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/serial/port_holders.hpp"
#include "tests/runtime/serial/cable.hpp"
#include "tests/runtime/serial/machine.hpp"

namespace bw::test {
namespace {

std::size_t open_descriptors() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

TEST(SerialPort, CarriesEveryByteBothWays) {
  Cable cable;
  ASSERT_TRUE(cable.connects()) << cable.host.update(now()).fault;
  std::vector<std::uint8_t> all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  EXPECT_TRUE(cable.host.write(all));
  const std::string expected(all.begin(), all.end());
  EXPECT_EQ(reads(cable.device, 256), expected);
  EXPECT_TRUE(cable.device.write(all));
  EXPECT_EQ(reads(cable.host, 256), expected);
  EXPECT_TRUE(cable.host.read().empty()) << "an echo";
}

TEST(SerialPort, AnySpeedIsMadeAndNamedInItsOptions) {
  Folder folder;
  PseudoTerminal device(folder / "cable");
  device.update(now());
  for (const std::int64_t baud : {1'200, 9'600, 115'200, 256'000, 1'000'000, 3'999'999}) {
    SerialPort host({.port = (folder / "cable").string(), .baud = baud});
    EXPECT_TRUE(opens(host)) << baud << ": " << host.update(now()).fault;
  }
}

TEST(SerialPort, ACableThatIsPulledIsSeenByTheNextCallAndComesBack) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  EXPECT_EQ(cable.host.update(now()).openings, 1U);
  cable.device.pull();
  EXPECT_FALSE(cable.host.update(now()).is_open);  // the very next one
  EXPECT_THAT(cable.host.update(now()).fault, testing::HasSubstr("cable pulled"));
  EXPECT_FALSE(cable.host.write(bytes_of("x")));
  EXPECT_TRUE(cable.host.read().empty());
  EXPECT_TRUE(says(cable.host, "no such device: is it plugged in"));
  ASSERT_TRUE(cable.connects());
  EXPECT_EQ(cable.host.update(now()).openings, 2U);
  EXPECT_TRUE(cable.host.write(bytes_of("stop")));
  EXPECT_EQ(reads(cable.device, 4), "stop");
}

TEST(SerialPort, ACableThatIsPulledIsSeenByReadingAndByWriting) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  cable.device.pull();
  EXPECT_TRUE(cable.host.read().empty());
  EXPECT_FALSE(cable.host.write(bytes_of("x")));
  ASSERT_TRUE(cable.connects());
  cable.device.pull();
  EXPECT_FALSE(cable.host.write(bytes_of("x")));
  EXPECT_FALSE(cable.host.update(now()).is_open);
}

// By the component's clock: a second attempt is not begun before 0.5 s of it.
TEST(SerialPort, TriesAgainEveryHalfSecondOfItsClock) {
  Folder folder;
  SerialPort host({.port = (folder / "cable").string()});
  const Time start = Time::seconds(100.0);
  host.update(start);
  ASSERT_TRUE(eventually([&] { return host.update(start).fault.starts_with("no such device"); }));
  PseudoTerminal device(folder / "cable");
  device.update(start);
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(host.update(start + Duration::milliseconds(499)).is_open);
  EXPECT_TRUE(eventually([&] { return host.update(start + Duration::milliseconds(500)).is_open; }));
}

// An emulator starts beside its host: within the patience, 2 s here, its absence is no fault, and it is
// looked for every 50 ms.
TEST(SerialPort, WaitsWithPatienceForADeviceThatIsStarting) {
  Folder folder;
  const Time start = Time::seconds(100.0);
  SerialPort host({.port = (folder / "cable").string()}, "the emulator", Duration::seconds(2.0));
  EXPECT_TRUE(host.update(start).is_opening);
  ASSERT_TRUE(eventually([&] { return host.update(start).fault.starts_with("no such device"); }));
  EXPECT_TRUE(host.update(start).is_opening);
  PseudoTerminal device(folder / "cable");
  device.update(start);
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(host.update(start + Duration::milliseconds(49)).is_open);
  EXPECT_TRUE(eventually([&] { return host.update(start + Duration::milliseconds(50)).is_open; }));
  EXPECT_FALSE(host.update(start + Duration::milliseconds(50)).is_opening);
  device.pull();
  EXPECT_FALSE(host.update(start + Duration::milliseconds(60)).is_opening)
      << "a line that is lost is a fault";
}

TEST(SerialPort, PatienceEnds) {
  Folder folder;
  const Time start = Time::seconds(100.0);
  SerialPort host({.port = (folder / "cable").string()}, "the emulator", Duration::seconds(2.0));
  EXPECT_TRUE(host.update(start).is_opening);
  EXPECT_TRUE(eventually([&] { return !host.update(start + Duration::seconds(2.0)).is_opening; }));
  SerialPort without({.port = (folder / "cable").string()});
  EXPECT_TRUE(without.update(start).is_opening) << "nothing was tried yet";
  EXPECT_TRUE(eventually([&] { return !without.update(start).is_opening; }));
}

TEST(SerialPort, AClockThatGoesBackKeepsNobodyWaiting) {
  Folder folder;
  SerialPort host({.port = (folder / "cable").string()});
  ASSERT_TRUE(eventually([&] { return host.update(Time::seconds(1e6)).fault.starts_with("no such"); }));
  PseudoTerminal device(folder / "cable");
  device.update({});
  EXPECT_TRUE(eventually([&] { return host.update(Time::seconds(1.0)).is_open; }));
}

TEST(SerialPort, GivenUpItSaysWhyAndComesBackAfterHalfASecond) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  const Time then = now();
  cable.host.close(then, "answers as another model");
  EXPECT_FALSE(cable.host.update(then).is_open);
  EXPECT_EQ(cable.host.update(then + Duration::milliseconds(499)).fault, "answers as another model");
  EXPECT_TRUE(eventually([&] { return cable.host.update(then + Duration::milliseconds(500)).is_open; }));
  EXPECT_EQ(cable.host.update(now()).openings, 2U);
}

TEST(SerialPort, ASecondOneOfThisProcessIsRefusedAndGetsItsTurn) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  SerialPort second({.port = (cable.folder / "cable").string()});
  EXPECT_TRUE(says(second, "owned by somebody else: in use by process " + std::to_string(getpid())));
  EXPECT_TRUE(cable.host.write(bytes_of("mine")));
  EXPECT_EQ(reads(cable.device, 4), "mine");
  cable.host.close(now() + Duration::seconds(3600), "given up");
  EXPECT_TRUE(opens(second)) << second.update(now()).fault;
}

// Two containers of one machine have a /dev/pts/0 each, of one device number; the kernel tells them apart by their file
// systems.
TEST(PortHolders, APseudoTerminalOfAnotherContainerIsAnotherOne) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  struct stat port {};
  ASSERT_EQ(stat((cable.folder / "cable").c_str(), &port), 0);
  ASSERT_EQ(holders_of(port).size(), 1U);
  EXPECT_EQ(holders_of(port)[0].pid, getpid());
  ++port.st_dev;
  EXPECT_TRUE(holders_of(port).empty());
}

/// A program that opens the line and knows of no locks, until it is told to end.
class ForeignProcess {
 public:
  explicit ForeignProcess(const std::string& line) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return;
    id_ = fork();
    if (id_ == 0) {
      const int descriptor = open(line.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
      static_cast<void>(!::write(pipe[1], descriptor < 0 ? "-" : "+", 1));
      for (;;) pause();
    }
    char answer = 0;
    static_cast<void>(!::read(pipe[0], &answer, 1));
    has_it_ = answer == '+';
    ::close(pipe[0]);
    ::close(pipe[1]);
  }
  ~ForeignProcess() { end(); }
  void end() {
    if (id_ <= 0) return;
    kill(id_, SIGKILL);
    waitpid(std::exchange(id_, -1), nullptr, 0);
  }
  pid_t id() const { return id_; }
  bool has_it() const { return has_it_; }

 private:
  pid_t id_ = -1;
  bool has_it_ = false;
};

TEST(SerialPort, AStrangerWhoCameFirstIsNamed) {
  Folder folder;
  PseudoTerminal device(folder / "cable");
  device.update(now());
  ForeignProcess foreign((folder / "cable").string());
  ASSERT_TRUE(foreign.has_it());
  SerialPort host({.port = (folder / "cable").string()});
  EXPECT_TRUE(says(host, "in use by process " + std::to_string(foreign.id())));
  foreign.end();
  EXPECT_TRUE(opens(host)) << host.update(now()).fault;
}

// What has to happen in a process that is not root's. True when it held there.
template <class Check>
bool holds_without_rights(Check check) {
  const pid_t child = fork();
  if (child == 0) _exit((geteuid() != 0 || (setgid(65'534) == 0 && setuid(65'534) == 0)) && check() ? 0 : 1);
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Root makes it a line of Debian's group dialout, without nobody in it. Everybody else has no lines but its
// own, which are terminals of the group tty, and is kept from them as their owner.
TEST(SerialPort, WithoutPermissionItSaysWhichGroupToJoin) {
  const bool is_root = geteuid() == 0;
  std::array<char, 64> name{};
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(grantpt(master) == 0 && unlockpt(master) == 0 && ptsname_r(master, name.data(), 64) == 0);
  ASSERT_TRUE(!is_root || chown(name.data(), 0, 20) == 0);
  ASSERT_EQ(chmod(name.data(), is_root ? 0660 : 0060), 0);
  const std::string group = is_root ? "dialout" : "tty";
  const std::string user = is_root ? "nobody" : getpwuid(geteuid())->pw_name;
  EXPECT_TRUE(holds_without_rights([&] {
    SerialPort host({.port = name.data()});
    return says(host, "permission denied: the group " + group + " may: `sudo usermod -aG " + group + " " +
                          user + "`");
  }));
  ASSERT_EQ(chmod(name.data(), is_root ? 0600 : 0000), 0);
  EXPECT_TRUE(holds_without_rights([&] {
    SerialPort host({.port = name.data()});
    return says(host, "config/udev/99-bandwagon.rules");
  }));
  ::close(master);
}

TEST(SerialPort, WhatIsNoSerialLineIsRefusedAsWhatItIs) {
  Folder folder;
  std::ofstream(folder / "file") << "text";
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {(folder / "file").string(), "is a file, no serial line"},
      {(folder / "pipe").string(), "is a file, no serial line"},
      {(folder / ".").string(), "is a folder, no serial line"},
      {(folder / "nothing").string(), "no such device"},
      {"/dev/null", "is not a serial line"},
      {"", "no such device"},
      {"usb:", "no USB adapter"},
      {"usb:NOBODY-HAS-THIS", "no USB adapter with the serial number NOBODY-HAS-THIS"}};
  for (const auto& [port, words] : cases) {
    SerialPort host({.port = port});
    EXPECT_TRUE(says(host, words)) << port << ": " << host.update(now()).fault;
    EXPECT_FALSE(host.update(now()).is_open);
  }
  EXPECT_EQ(std::filesystem::file_size(folder / "file"), 4U);
}

// An adapter that hangs while it is looked up: its sysfs file is a pipe, whose reader waits until somebody
// opens the other end.
TEST(SerialPort, ADeviceThatHangsHoldsNobodyUp) {
  Machine machine;
  machine.add_ftdi("ttyUSB0", "1-1", "HANGS");
  const fs::path product = machine.folders.sys / "devices" / "pci0000:00" / "usb1" / "1-1" / "product";
  fs::remove(product);
  ASSERT_EQ(mkfifo(product.c_str(), 0600), 0);
  SerialPort host({.port = "usb:HANGS"}, {}, {}, machine.folders);
  host.update(now());
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(host.update(now()).is_open);
    EXPECT_TRUE(host.read().empty());
    EXPECT_FALSE(host.write(bytes_of("x")));
    host.close(now(), "another model");
  }
  // Succeeds only when the reader is in there: so all those calls returned beside it.
  int writer = -1;
  EXPECT_TRUE(eventually([&] { return (writer = open(product.c_str(), O_WRONLY | O_NONBLOCK)) >= 0; }));
  EXPECT_EQ(host.update(now()).fault, "another model");
  ::close(writer);
  EXPECT_TRUE(says(host, "is a file, no serial line"));
}

TEST(SerialPort, BurstsArriveWholeAndInOrder) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  std::mt19937 random(5);
  std::string sent;
  std::string got;
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint8_t> burst(1 + random() % 3000);
    for (auto& byte : burst) byte = static_cast<std::uint8_t>(random());
    if (cable.device.write(burst)) sent.append(burst.begin(), burst.end());
    got += reads(cable.host, sent.size() - got.size());
  }
  EXPECT_TRUE(got == sent) << got.size() << " of " << sent.size();
  EXPECT_GT(sent.size(), 300'000U);
}

// A tty holds some kilobytes; then a write must fail and return, and work again when there is room.
TEST(SerialPort, AFullLineRefusesAndGoesOnWhenItIsRead) {
  Cable cable;
  ASSERT_TRUE(cable.connects());
  const std::vector<std::uint8_t> block(1000, 0x55);
  int taken = 0;
  while (taken < 1000 && cable.host.write(block)) ++taken;
  EXPECT_LT(taken, 1000);
  EXPECT_FALSE(cable.host.write(block));
  EXPECT_TRUE(cable.host.update(now()).is_open) << "a full line is no fault of the cable";
  EXPECT_GE(reads(cable.device, static_cast<std::size_t>(taken) * 1000).size(),
            static_cast<std::size_t>(taken) * 1000);
  EXPECT_TRUE(eventually([&] { return cable.host.write(block); }));
  int from_device = 0;
  while (from_device < 1000 && cable.device.write(block)) ++from_device;
  EXPECT_LT(from_device, 1000);
}

TEST(SerialPort, WhatWasWrittenLastStillArrivesWhenItEnds) {
  Folder folder;
  PseudoTerminal device(folder / "cable");
  device.update(now());
  {
    SerialPort host({.port = (folder / "cable").string()});
    ASSERT_TRUE(opens(host));
    EXPECT_TRUE(host.write(bytes_of("STOP 0\r")));
  }
  EXPECT_EQ(reads(device, 7), "STOP 0\r");
}

TEST(SerialPort, WhatWasSaidBeforeItOpenedIsForNobody) {
  Folder folder;
  PseudoTerminal device(folder / "cable");
  device.update(now());
  EXPECT_TRUE(device.write(bytes_of("nobody listens")));
  SerialPort host({.port = (folder / "cable").string()});
  ASSERT_TRUE(opens(host));
  EXPECT_TRUE(host.read().empty());
  EXPECT_FALSE(host.set_dtr(false) && host.set_dtr(true) && !host.update(now()).is_open);
}

TEST(SerialPort, AThousandRandomOpeningsLeaveNothingBehind) {
  Folder folder;
  std::mt19937 random(11);
  const std::size_t before = open_descriptors();
  int opened = 0;
  for (int i = 0; i < 1000; ++i) {
    PseudoTerminal device(folder / "cable");
    if (random() % 8 != 0) device.update(now());
    SerialPort host({.port = (folder / "cable").string()});
    const auto steps = static_cast<int>(random() % 12);
    for (int k = 0; k < steps; ++k) {
      switch (random() % 6) {
        case 0:
          host.close(now(), "given up");
          break;
        case 1:
          device.pull();
          break;
        case 2:
          device.update(now());
          break;
        case 3:
          static_cast<void>(host.write(bytes_of("abc")));
          break;
        case 4:
          static_cast<void>(host.read());
          break;
        default:
          opened += host.update(now() + Duration::milliseconds(1000 * k)).is_open ? 1 : 0;
          std::this_thread::yield();
      }
    }
    // At times of which each is a new attempt's.
    if (i % 10 == 0 && device.update(now()).is_open) {
      opened +=
          eventually([&, k = 20]() mutable { return host.update(now() + Duration::seconds(++k)).is_open; });
    }
  }
  EXPECT_GE(opened, 100);
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

}  // namespace
}  // namespace bw::test
