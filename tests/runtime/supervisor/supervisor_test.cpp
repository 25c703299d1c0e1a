// The supervisor with processes that are there: what it hears, whom it believes, what it leaves behind. When it does
// what is supervised_process_test.cpp's matter; here nothing depends on how fast.
#include "runtime/supervisor/supervisor.hpp"

#include <atomic>
#include <csignal>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "runtime/host/service_manager.hpp"
#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using Words = std::vector<std::string>;

/// A child that does `first`, and `later` each time that it is started again.
SupervisedProgram program(const std::string& name, Words first, Words later = {"ready", "live"},
                          bool ends_last = false) {
  return {.name = name,
          .command =
              [=](int start) {
                Words words = start == 1 ? first : later;
                words.insert(words.begin(), SUPERVISED);
                return words;
              },
          .ends_last = ends_last};
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A supervisor on a thread of its own; its folder is a short one, as sockets want it.
class Supervised {
 public:
  explicit Supervised(const std::vector<SupervisedProgram>& programs, SupervisionLimits limits = {}) {
    std::filesystem::create_directories(logs);
    thread_ = std::thread([this, programs, limits] {
      status_ = supervise(SupervisorLock(socket),
                          {.programs = programs, .logs = logs, .limits = limits, .interrupted = [this] {
                             return interrupted.load();
                           }});
      is_over_ = true;
    });
  }
  ~Supervised() { end(); }
  Supervised(const Supervised&) = delete;
  Supervised& operator=(const Supervised&) = delete;

  int end() {
    interrupted = true;
    if (thread_.joinable()) thread_.join();
    return status_;
  }
  /// Its exit status, by its own decision.
  int decision() {
    EXPECT_TRUE(eventually([&] { return is_over_.load(); }));
    return end();
  }
  [[nodiscard]] std::string status() const {
    try {
      return ask_supervisor(socket, "status");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  [[nodiscard]] bool says(const std::string& pattern) const {
    const std::regex wanted(pattern);
    return eventually([&] { return std::regex_search(status(), wanted); });
  }
  /// 0: it has none.
  [[nodiscard]] pid_t id(const std::string& name) const {
    std::smatch found;
    const std::string text = status();
    return std::regex_search(text, found, std::regex(name + " .*pid (\\d+)")) ? std::stoi(found[1]) : 0;
  }

  Folder folder;
  std::filesystem::path logs = folder / "logs";
  std::filesystem::path socket = folder / "s";
  std::atomic<bool> interrupted = false;

 private:
  std::atomic<bool> is_over_ = false;
  int status_ = -1;
  std::thread thread_;
};

TEST(Supervisor, StartsAllAndEndsAllInOrder) {
  Supervised all({program("recorder", {"ready", "live"}, {}, true), program("base", {"ready", "live"}),
                  program("planning", {"ready", "live"})});
  for (const char* name : {"recorder", "base", "planning"})
    EXPECT_TRUE(all.says(std::string(name) + " +up .*up after \\d\\.\\d{3} s, says: up")) << all.status();
  EXPECT_EQ(all.end(), 0);
  const std::string manifest = content(all.logs / "manifest.yaml");
  EXPECT_THAT(manifest, AllOf(HasSubstr("base: exit status 0"), HasSubstr("planning: exit status 0")));
  EXPECT_GT(manifest.find("recorder: exit status 0"), manifest.find("base: exit status 0"));
  EXPECT_GT(manifest.find("recorder: exit status 0"), manifest.find("planning: exit status 0"));
  EXPECT_FALSE(std::filesystem::exists(all.socket));
}

TEST(Supervisor, AKilledProcessIsThereAgainAndTheOthersDoNotNotice) {
  Supervised all(
      {program("base", {"ready", "live"}), program("planning", {"ready", "=all is well", "live"})});
  ASSERT_TRUE(all.says("planning +up") && all.says("base +up"));
  const pid_t base = all.id("base");
  const pid_t planning = all.id("planning");
  kill(planning, SIGKILL);
  EXPECT_TRUE(all.says("planning +up .*starts 2")) << all.status();
  EXPECT_TRUE(all.says("was killed by signal 9 \\(Killed\\); last words: all is well")) << all.status();
  EXPECT_NE(all.id("planning"), planning);
  EXPECT_EQ(all.id("base"), base);
  EXPECT_EQ(all.end(), 0);
}

// SIGSTOP: it is not there any more, and does not end either.
TEST(Supervisor, AHungProcessIsKilledAndThereAgain) {
  Supervised all({program("planning", {"ready", "live"})});
  ASSERT_TRUE(all.says("planning +up"));
  kill(all.id("planning"), SIGSTOP);
  EXPECT_TRUE(all.says("planning +up .*starts 2")) << all.status();
  EXPECT_TRUE(all.says("before it: was killed by signal 9 \\(Killed\\): no sign of life for 0.9 s"))
      << all.status();
}

TEST(Supervisor, ACrashLoopEndsEverythingAndSaysWhy) {
  SupervisionLimits limits;
  limits.pause = Duration::milliseconds(1);
  Supervised all({program("base", {"ready", "live"}),
                  program("planning", {"=no such device", "3"}, {"=no such device", "3"})},
                 limits);
  EXPECT_EQ(all.decision(), 3);
  EXPECT_THAT(
      content(all.logs / "launch.log"),
      HasSubstr(
          "planning is given up: started again 5 times within 60 s, and ended with status 3; last words: "
          "no such device"));
  EXPECT_THAT(content(all.logs / "manifest.yaml"), HasSubstr("base: exit status 0"));
}

TEST(Supervisor, OneThatNeverSaysReadyIsGivenUp) {
  SupervisionLimits limits;
  limits.ready = Duration::milliseconds(100);
  limits.restarts = 1;
  Supervised all({program("laser", {"silent"}, {"silent"})}, limits);
  EXPECT_NE(all.decision(), 0);
  EXPECT_THAT(content(all.logs / "launch.log"), HasSubstr("did not say READY=1 within 0.1 s"));
}

TEST(Supervisor, OneThatIsAskedToEndAndDoesNotIsKilled) {
  SupervisionLimits limits;
  limits.stop = Duration::milliseconds(100);
  limits.watchdog = Duration::seconds(1000);
  Supervised all({program("deaf", {"ready", "deaf"})}, limits);
  ASSERT_TRUE(all.says("deaf +up"));
  EXPECT_EQ(all.end(), 128 + SIGKILL);
}

TEST(Supervisor, EndsWithTheFirstThatIsOver) {
  Supervised all({program("base", {"ready", "live"}), program("rest", {"ready", "over", "1"})});
  EXPECT_EQ(all.decision(), 1);
  EXPECT_THAT(content(all.logs / "launch.log"), HasSubstr("all processes end: rest is over"));
}

TEST(Supervisor, AWrongConfigurationEndsEverythingAtOnce) {
  Supervised all(
      {program("recorder", {"=drive.mcap exists", "2"}, {}, true), program("base", {"ready", "live"})});
  EXPECT_EQ(all.decision(), 2);
  EXPECT_THAT(content(all.logs / "launch.log"), HasSubstr("last words: drive.mcap exists"));
}

// The kernel says who writes. This test is none of its children: it is named, and changes nothing.
TEST(Supervisor, ForgedDatagramsAreNotBelieved) {
  Supervised all({program("laser", {"silent"})});
  ASSERT_TRUE(all.says("laser +starting"));
  setenv("NOTIFY_SOCKET", all.socket.c_str(), 1);
  const ServiceManager forger;
  unsetenv("NOTIFY_SOCKET");
  forger.ready("up, says somebody");
  forger.hangs("it hangs, says somebody");
  forger.stopping("it is over, says somebody", true);
  EXPECT_TRUE(all.says("laser +starting .*starts 1")) << all.status();
  EXPECT_THAT(content(all.logs / "launch.log"),
              HasSubstr("not believed: process " + std::to_string(getpid()) + " of user"));
  EXPECT_THAT(all.status(), Not(HasSubstr("says somebody")));
}

TEST(Supervisor, IsRefusedBesideAnother) {
  Supervised all({program("base", {"ready", "live"})});
  ASSERT_TRUE(all.says("base +up"));
  try {
    supervise(SupervisorLock(all.socket), {.programs = {program("base", {"ready", "live"})},
                                           .logs = all.logs,
                                           .limits = {},
                                           .interrupted = [] { return true; }});
    FAIL() << "two supervise one graph";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it is launched already, by process " + std::to_string(getpid())));
  }
  EXPECT_TRUE(all.says("base +up .*starts 1")) << all.status();
}

TEST(Supervisor, IsAskedToStartOneAgainAndToEnd) {
  Supervised all({program("base", {"ready", "live"}), program("planning", {"ready", "live"})});
  ASSERT_TRUE(all.says("planning +up") && all.says("base +up"));
  EXPECT_THROW(ask_supervisor(all.socket, "restart nobody"), std::runtime_error);
  EXPECT_THROW(ask_supervisor(all.socket, "dance"), std::runtime_error);
  ask_supervisor(all.socket, "restart planning");
  EXPECT_TRUE(all.says("planning +up .*starts 2")) << all.status();
  EXPECT_TRUE(all.says("base +up .*starts 1")) << all.status();
  ask_supervisor(all.socket, "stop");
  EXPECT_EQ(all.decision(), 0);
  EXPECT_THROW(ask_supervisor(all.socket, "status"), std::runtime_error);
}

// A log that is no file that can be written is as a full disk: said once, and nobody waits for it.
TEST(Supervisor, AFullLogDiskStopsNobody) {
  const Folder folder;
  std::filesystem::create_directories(folder / "logs");
  std::filesystem::create_symlink("/dev/full", folder / "logs" / "base.log");
  std::atomic<bool> enough = false;
  std::thread looking([&] {
    eventually(
        [&] { return content(folder / "logs" / "launch.log").find("base is up") != std::string::npos; });
    enough = true;
  });
  const int status = supervise(SupervisorLock(folder / "s"),
                               {.programs = {program("base", {"=one", "=two", "ready", "live"})},
                                .logs = folder / "logs",
                                .limits = {},
                                .interrupted = [&] { return enough.load(); }});
  looking.join();
  EXPECT_EQ(status, 0);
  EXPECT_THAT(content(folder / "logs" / "launch.log"),
              HasSubstr("base.log: No space left on device; what base prints"));
}

// As a file that a supervisor left that was killed: the next one takes the place.
TEST(Supervisor, ASocketThatWasLeftIsTakenOver) {
  const Folder folder;
  std::filesystem::create_directories(folder / "logs");
  std::ofstream(folder / "s") << "left";
  EXPECT_EQ(supervise(SupervisorLock(folder / "s"), {.programs = {program("base", {"ready", "over", "0"})},
                                                     .logs = folder / "logs",
                                                     .limits = {},
                                                     .interrupted = [] { return false; }}),
            0);
}

}  // namespace
}  // namespace bw::test
