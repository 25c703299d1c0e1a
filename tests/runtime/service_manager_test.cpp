// What a run tells the service manager that started it, on a socket of the test's own. The expected lines are
// sd_notify's protocol (systemd, man sd_notify(3)).
#include "runtime/host/service_manager.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "runtime/host/lane_watch.hpp"
#include "runtime/registry.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/runtime/test_graph.hpp"

namespace bw {
namespace {

using testing::ElementsAre;
using testing::MatchesRegex;

/// The manager's end, on an abstract socket that is gone with it.
class Manager {
 public:
  Manager() : name_("bandwagon-test-" + std::to_string(getpid())) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name_.data(), name_.size());
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name_.size());
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), length) != 0)
      throw std::runtime_error("the test's socket cannot be bound");
    setenv("NOTIFY_SOCKET", ("@" + name_).c_str(), 1);
  }
  ~Manager() {
    unsetenv("NOTIFY_SOCKET");
    close(socket_);
  }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  std::vector<std::string> heard() const {
    std::vector<std::string> all;
    std::array<char, 4096> text{};
    for (ssize_t size = 0; (size = recv(socket_, text.data(), text.size(), MSG_DONTWAIT)) >= 0;)
      all.emplace_back(text.data(), static_cast<std::size_t>(size));
    return all;
  }

 private:
  std::string name_;
  int socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

class Broken final : public Component {
 public:
  void configure(bw::Setup&) override {}
  void activate(const Tick&) override { throw std::runtime_error("no power"); }
};

TEST(ServiceManager, HearsThatAllIsUpWhatGoesWrongAndThatItEnds) {
  const Manager manager;
  TestGraph graph;
  graph.add({.name = "worried"}, [](bw::Setup& setup) {
    setup.every(Duration::milliseconds(100), "tick", [log = setup.log()](const Tick& tick) mutable {
      if (tick.sequence == 3) log.warn("the battery is low\nand the lamp too");
    });
  });
  graph.run(1.0);
  EXPECT_THAT(manager.heard(), ElementsAre(MatchesRegex("READY=1\nSTATUS=[0-9]+ nodes are up"),
                                           "STATUS=worried: the battery is low",
                                           "STOPPING=1\nX_BANDWAGON_OVER=1\nSTATUS=" + graph.end().reason));
}

TEST(ServiceManager, HearsNoReadinessOfWhatCannotComeUp) {
  register_component("service_manager_broken", [] { return std::make_unique<Broken>(); });
  Graph graph;
  graph.components = {{.name = "broken", .type = "service_manager_broken"}};
  const Manager manager;
  Host host(graph, {.clock = ClockMode::lockstep});
  EXPECT_FALSE(host.run(Duration::seconds(1.0)).ok);
  EXPECT_THAT(manager.heard(), ElementsAre("STATUS=broken: activate failed, now inactive: no power",
                                           "STOPPING=1\nSTATUS=broken cannot be activated: no power"));
}

// sd_watchdog_enabled(3): microseconds, and of the process that it names alone.
TEST(ServiceManager, TellsHowPatientItsManagerIs) {
  const Manager manager;
  setenv("WATCHDOG_USEC", "900000", 1);
  EXPECT_EQ(ServiceManager().watchdog(), Duration::milliseconds(900));
  setenv("WATCHDOG_PID", "1", 1);
  EXPECT_EQ(ServiceManager().watchdog(), Duration{});
  setenv("WATCHDOG_PID", std::to_string(getpid()).c_str(), 1);
  EXPECT_EQ(ServiceManager().watchdog(), Duration::milliseconds(900));
  for (const char* none : {"", "-5", "soon", "99999999999999999999"}) {
    setenv("WATCHDOG_USEC", none, 1);
    EXPECT_EQ(ServiceManager().watchdog(), Duration{}) << none;
  }
  unsetenv("WATCHDOG_PID");
  unsetenv("WATCHDOG_USEC");
}

/// A manager with a patience of 0.8 s: a lane passes each 0.2 s, and may stay away for 0.6 s.
struct Watched {
  Watched() { setenv("WATCHDOG_USEC", "800000", 1); }
  ~Watched() { unsetenv("WATCHDOG_USEC"); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;
  Manager manager;
};

Duration at(std::int64_t ms) { return Duration::milliseconds(1000 + ms); }

TEST(LaneWatch, SaysThatItLivesWhileEveryLanePasses) {
  const Watched watched;
  const ServiceManager service;
  LaneWatch watch(service);
  EXPECT_EQ(watch.period(), Duration::milliseconds(200));
  LaneWatch::Lane& base = watch.add("base", {}, at(0));
  LaneWatch::Lane& planner = watch.add("planner", {}, at(0));
  for (int ms = 0; ms < 1000; ms += 10) watch.pass(ms % 100 == 0 ? planner : base, at(ms));
  EXPECT_THAT(watched.manager.heard(), testing::AllOf(testing::SizeIs(5), testing::Each("WATCHDOG=1")));
}

TEST(LaneWatch, NamesTheLaneThatDoesNotComeBackOnceAndSaysNothingAfterIt) {
  const Watched watched;
  const ServiceManager service;
  LaneWatch watch(service);
  LaneWatch::Lane& base = watch.add("base", {}, at(0));
  watch.add("planner", {}, at(0));
  for (int ms = 200; ms <= 2000; ms += 200) watch.pass(base, at(ms));
  EXPECT_THAT(watched.manager.heard(),
              ElementsAre("WATCHDOG=1", "WATCHDOG=1", "WATCHDOG=1",
                          "WATCHDOG=trigger\nSTATUS=lane planner has not come back for 0.80 s"));
}

TEST(LaneWatch, ALaneMayTakeAsLongAsItSaysItself) {
  const Watched watched;
  const ServiceManager service;
  LaneWatch watch(service);
  LaneWatch::Lane& base = watch.add("base", {}, at(0));
  watch.add("maps", Duration::milliseconds(2000), at(0));
  for (int ms = 200; ms <= 2200; ms += 200) watch.pass(base, at(ms));
  const auto heard = watched.manager.heard();
  ASSERT_EQ(heard.size(), 11U);
  EXPECT_EQ(heard[9], "WATCHDOG=1");
  EXPECT_EQ(heard[10], "WATCHDOG=trigger\nSTATUS=lane maps has not come back for 2.20 s");
}

TEST(LaneWatch, NobodyIsToldWhereNobodyWatches) {
  const Manager manager;
  const ServiceManager service;
  LaneWatch watch(service);
  EXPECT_EQ(watch.period(), LaneWatch::kForever);
  watch.pass(watch.add("base", {}, at(0)), at(5000));
  EXPECT_THAT(manager.heard(), testing::IsEmpty());
}

// In real time, as the lanes are: one that has nothing to do passes too, and one that never comes back is named by the
// others.
TEST(LaneWatch, OfAHostIsHeardUntilOneLaneHangs) {
  const Watched watched;
  Graph graph;
  std::atomic<bool> hangs = false;
  std::atomic<bool> over = false;
  register_component("service_manager_busy", [&] {
    return std::make_unique<Scripted>([&](bw::Setup& setup) {
      setup.every(Duration::milliseconds(10), "tick", [&](const Tick&) {
        while (hangs && !over) std::this_thread::yield();
      });
    });
  });
  graph.components = {{.name = "busy", .type = "service_manager_busy", .lane = "busy"}};
  Host host(graph, {});
  std::thread run([&] { host.run({}); });
  const auto hears = [&](const std::string& text) {
    return bw::test::eventually([&] {
      const auto heard = watched.manager.heard();
      return std::ranges::any_of(heard, [&](const std::string& line) { return line.starts_with(text); });
    });
  };
  EXPECT_TRUE(hears("READY=1"));
  EXPECT_TRUE(hears("WATCHDOG=1"));
  EXPECT_TRUE(hears("WATCHDOG=1"));
  hangs = true;
  EXPECT_TRUE(hears("WATCHDOG=trigger\nSTATUS=lane busy has not come back for"));
  over = true;
  host.finish({.ok = true, .reason = "enough"}, true);
  run.join();
}

TEST(ServiceManager, NobodyIsToldWithoutOne) {
  unsetenv("NOTIFY_SOCKET");
  const ServiceManager none;
  none.ready("to nobody");
  setenv("NOTIFY_SOCKET", "no/absolute/path", 1);
  const ServiceManager strange;
  strange.ready("to nobody");
  unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace bw
