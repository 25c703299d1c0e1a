// The page and Foxglove on one port, fed by what a participant of its own sees of a domain.
#pragma once

#include <memory>
#include <string>

#include "runtime/logger.hpp"
#include "runtime/remote/foxglove/wire_robot.hpp"
#include "runtime/remote/web/server_options.hpp"

namespace bw::viewer {

class PageServer {
 public:
  /// Serves from now on, on a thread of its own with a lower priority than the robot's. Throws as web::Server
  /// and foxglove::WireRobot do.
  PageServer(const web::ServerOptions& options, foxglove::WireRobotOptions robot, Logger log);
  /// Sockets are told that it goes.
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// http://127.0.0.1:8765/?token=...: with the run's token, which commands need. Without one where a token_file holds it.
  std::string address() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The page and a folder of recordings, without a robot.
class RecordingServer {
 public:
  /// Throws as web::Server does.
  RecordingServer(const web::ServerOptions& options, Logger log);
  ~RecordingServer();
  RecordingServer(const RecordingServer&) = delete;
  RecordingServer& operator=(const RecordingServer&) = delete;

  std::string address() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// What people are told: the address of the page, or where Foxglove finds what this program has of it. One or
/// two lines without an end of line.
std::string invitation(const std::string& address);

}  // namespace bw::viewer
