// foxglove_robot [OPTION...]: serves a robot that echoes to Foxglove's clients, until standard input ends.
// The first line that it prints is its address; then what the robot hears. Each line of standard input is an
// order of JSON (echo_robot.hpp).
//   one_commander    one client commands at a time
//   look_only        nobody may command
//   short_turn       a commander's turn ends 0.3 s after its last command
#include <chrono>
#include <iostream>
#include <string>

#include "runtime/remote/foxglove/server.hpp"
#include "runtime/remote/web/server.hpp"
#include "tests/interop/foxglove_client/echo_robot.hpp"

namespace bw::foxglove::test {
namespace {

/// Lets pass what the protocol says, but for permission to command.
class Gate final : public web::SocketHandler {
 public:
  Gate(Server& server, bool may_command) : server_(server), may_command_(may_command) {}
  void on_open(web::ConnectionId id, const web::Opening& opening) override {
    web::Opening changed = opening;
    if (!may_command_) changed.read_only = "nobody may command";
    server_.on_open(id, changed);
  }
  void on_text(web::ConnectionId id, std::string_view text) override { server_.on_text(id, text); }
  void on_binary(web::ConnectionId id, std::span<const std::uint8_t> bytes) override {
    server_.on_binary(id, bytes);
  }
  void on_close(web::ConnectionId id) override { server_.on_close(id); }

 private:
  Server& server_;
  bool may_command_;
};

Time steady_now() {
  return {std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

void keep_ticking(web::Loop& loop, Server& server) {
  loop.after(std::chrono::milliseconds(100), [&loop, &server] {
    server.tick();
    keep_ticking(loop, server);
  });
}

void serve(const std::string& option) {
  web::ServerOptions options;
  options.port = 0;
  web::Server web(options, {}, {kSubprotocols.begin(), kSubprotocols.end()}, Logger());
  EchoRobot robot;
  ServerOptions protocol;
  protocol.session = "session 1";
  protocol.is_one_commander = option == "one_commander";
  if (option == "short_turn") protocol.commander_release = Duration::milliseconds(300);
  protocol.assets = [](const std::string& uri) -> std::variant<Bytes, std::string> {
    if (uri == "package://robot/robot.urdf") return Bytes{'<', 'r', '/', '>'};
    return "there is no " + uri;
  };
  Server server(web, robot, std::move(protocol), steady_now);
  Gate gate(server, option != "look_only");
  web.start(gate);
  keep_ticking(web, server);
  std::cout << web.address() << "?token=" << web.run_token() << std::endl;
  for (std::string line; std::getline(std::cin, line);)
    web.post([&robot, order = json::parse(line)] { robot.obey(order); });
  web.stop();
}

}  // namespace
}  // namespace bw::foxglove::test

int main(int argc, char** argv) {
  bw::foxglove::test::serve(argc > 1 ? argv[1] : "");
  return 0;
}
