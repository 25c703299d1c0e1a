// What a run tells the service manager that started it, on a socket of the test's own. The expected lines are
// sd_notify's protocol (systemd, man sd_notify(3)).
#include "runtime/host/service_manager.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "runtime/registry.hpp"
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
  EXPECT_THAT(manager.heard(),
              ElementsAre(MatchesRegex("READY=1\nSTATUS=[0-9]+ nodes are up"),
                          "STATUS=worried: the battery is low", "STOPPING=1\nSTATUS=" + graph.end().reason));
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
