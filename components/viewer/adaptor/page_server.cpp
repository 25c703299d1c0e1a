#include "components/viewer/adaptor/page_server.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include "components/viewer/adaptor/site.hpp"
#include "components/viewer/adaptor/help/help_pages.hpp"
#include "runtime/remote/foxglove/protocol.hpp"
#include "runtime/remote/foxglove/server.hpp"
#include "runtime/remote/web/server.hpp"

namespace bw::viewer {
namespace {

using std::chrono::steady_clock;

constexpr int kNiceness = 5;  // the robot goes first
constexpr std::chrono::milliseconds kTick{100};

web::Site site() {
  const auto page = page_files();
  if (page.empty()) return {};
  std::vector<web::SiteFile> files = help_site();
  files.insert(files.end(), page.begin(), page.end());
  return {.files = std::move(files)};
}

/// Threads inherit the name of the one that starts them: so the participant's are told from the robot's.
class NamedMeanwhile {
 public:
  explicit NamedMeanwhile(const char* name) {
    pthread_getname_np(pthread_self(), before_.data(), before_.size());
    pthread_setname_np(pthread_self(), name);
  }
  ~NamedMeanwhile() { pthread_setname_np(pthread_self(), before_.data()); }
  NamedMeanwhile(const NamedMeanwhile&) = delete;
  NamedMeanwhile& operator=(const NamedMeanwhile&) = delete;

 private:
  std::array<char, 16> before_ = {};  // what the kernel keeps of a name
};

Time steady_now() { return {std::chrono::nanoseconds(steady_clock::now().time_since_epoch()).count()}; }

foxglove::ServerOptions protocol_options(const web::ServerOptions& options) {
  const bool is_open = !options.address.starts_with("127.") && options.address != "::1";
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {.session = fmt::format("{}-{}", getpid(), now.count()), .is_one_commander = is_open};
}

}  // namespace

/// In this order: each is used by those after it.
struct PageServer::Parts {
  Parts(const web::ServerOptions& options, foxglove::WireRobotOptions robot_options, Logger log)
      : web(options, site(), {foxglove::kSubprotocols.begin(), foxglove::kSubprotocols.end()},
            std::move(log)),
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

PageServer::PageServer(const web::ServerOptions& options, foxglove::WireRobotOptions robot, Logger log) {
  const NamedMeanwhile name("viewer");
  parts_ = std::make_unique<Parts>(options, std::move(robot), std::move(log));
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  const std::string token = parts_->web.run_token();
  return parts_->web.address() + (token.empty() ? "" : "?token=" + token);
}

/// There is nobody to talk to.
struct NoRobot final : web::SocketHandler {
  explicit NoRobot(web::SocketSender& to) : sender(to) {}
  void on_open(web::ConnectionId id, const web::Opening&) override {
    constexpr std::uint16_t kPolicy = 1008;
    sender.close(id, kPolicy, "a recording is shown here, no robot");
  }
  void on_text(web::ConnectionId, std::string_view) override {}
  void on_binary(web::ConnectionId, std::span<const std::uint8_t>) override {}
  void on_close(web::ConnectionId) override {}

  web::SocketSender& sender;
};

struct RecordingServer::Parts {
  Parts(const web::ServerOptions& options, Logger log)
      : web(options, site(), {foxglove::kSubprotocols.begin(), foxglove::kSubprotocols.end()},
            std::move(log)),
        nobody(web) {
    web.start(nobody);
  }
  ~Parts() { web.stop(); }

  web::Server web;
  NoRobot nobody;
};

RecordingServer::RecordingServer(const web::ServerOptions& options, Logger log)
    : parts_(std::make_unique<Parts>(options, std::move(log))) {}

RecordingServer::~RecordingServer() = default;

std::string RecordingServer::address() const { return parts_->web.address(); }

std::string invitation(const std::string& address) {
  if (!page_files().empty()) return "Page: " + address;
  const std::string socket = "ws" + address.substr(address.find(':'));
  return "Page: left out of this program, which was built without Node.js (launch_scripts/setup.sh installs it)\n"
         "Foxglove and Lichtblick: " +
         socket;
}

}  // namespace bw::viewer
