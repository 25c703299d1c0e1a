#include "components/viewer/adaptor/page_server.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "components/viewer/adaptor/site.hpp"
#include "runtime/foxglove/server.hpp"
#include "runtime/web/server.hpp"

namespace bw::viewer {
namespace {

using std::chrono::steady_clock;

constexpr int kNiceness = 10;  // the robot goes first
constexpr std::chrono::milliseconds kTick{100};

web::Site site() {
  const auto files = page_files();
  return {.files = {files.begin(), files.end()}};
}

Time steady_now() {
  return {std::chrono::nanoseconds(steady_clock::now().time_since_epoch()).count()};
}

foxglove::ServerOptions protocol_options(const web::ServerOptions& options) {
  const bool is_open = !options.address.starts_with("127.") && options.address != "::1";
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {.session = fmt::format("{}-{}", getpid(), now.count()), .is_one_commander = is_open};
}

}  // namespace

/// In this order: each is used by those after it.
struct PageServer::Parts {
  Parts(const web::ServerOptions& options, foxglove::WireRobotOptions robot_options, Logger log)
      : web(options, site(), {"foxglove.sdk.v1", "foxglove.websocket.v1"}, std::move(log)),
        robot(std::move(robot_options), [this](std::function<void()> work) { web.post(std::move(work)); }),
        protocol(web, robot, protocol_options(options), steady_now) {
    web.post([] { static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness)); });
    web.start(protocol);
    tick();
  }
  ~Parts() { web.stop(); }

  void tick() {
    web.after(kTick, [this] {
      protocol.tick();
      tick();
    });
  }

  web::Server web;
  foxglove::WireRobot robot;
  foxglove::Server protocol;
};

PageServer::PageServer(const web::ServerOptions& options, foxglove::WireRobotOptions robot, Logger log)
    : parts_(std::make_unique<Parts>(options, std::move(robot), std::move(log))) {}

PageServer::~PageServer() = default;

std::string PageServer::address() const { return parts_->web.address(); }

std::string invitation(const std::string& address) {
  if (!page_files().empty()) return "Page: " + address;
  const std::string socket = "ws" + address.substr(address.find(':'));
  return "Page: left out of this program, which was built without Node.js (launch_scripts/setup.sh installs it)\n"
         "Foxglove and Lichtblick: " +
         socket;
}

}  // namespace bw::viewer
