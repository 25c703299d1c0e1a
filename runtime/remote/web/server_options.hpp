// What a server of web pages and sockets may be told. Read with the parameters of the component it belongs
// to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/base/field.hpp"

namespace bw::web {

/// What a client may take of the server. Defaults are for a robot on which people look with a few browsers.
struct Limits {
  /// open at a time, HTTP and sockets; more are closed at once (set by code alone)
  int connections = 256;
  /// WebSockets among them; more are refused with 503 (set by code alone)
  int sockets = 160;
  double handshakes_per_second =
      100;  ///< of WebSockets, after a burst of twice as many; more are refused with 503
  double header_time =
      10;  ///< from the connection, or the answer before, to the end of a request's header [s]
  /// a socket from which nothing comes, not even the answer to a ping, is closed [s] (set by code alone)
  double idle_time = 90;
  /// the same while it takes none of what is sent to it [s] (set by code alone)
  double stalled_time = 300;
  /// for a socket's closing words and what is queued before them [s] (set by code alone)
  double close_time = 2;
  /// of a request: more is 431 (set by code alone)
  int header_bytes = 16 << 10;
  /// of a request: more is 413 (set by code alone)
  int body_bytes = 4 << 10;
  /// of a message from a socket: more closes it with code 1009 (set by code alone)
  int message_bytes = 4 << 20;
  /// of data for one socket, before older frames are left out (set by code alone)
  int queued_bytes = 8 << 20;
  /// the same (set by code alone)
  int queued_frames = 1024;
  /// of answers and announcements for one socket, before it is closed (set by code alone)
  int control_bytes = 16 << 20;
  /// the same (set by code alone)
  int control_frames = 4096;
  int login_attempts = 5;  ///< wrong tokens of one address within a minute, before it is told 429

  template <class Visitor>
  void fields(Visitor& v) {
    v("login_attempts", login_attempts,
      {.min = 1, .max = 1000, .doc = "wrong tokens of one address within a minute"});
    v.retired({"connections", "sockets", "message_bytes", "queued_bytes"},
              "a constant of server_options.hpp");
  }
};

struct ServerOptions {
  std::string address = "127.0.0.1";    ///< of this machine, as a number
  int port = 8765;                      ///< 0: any free one
  /// this many ports are tried, from `port` on (set by code alone)
  int port_tries = 20;
  std::vector<std::string> host_names;  ///< by which clients call this machine, beside numbers; for --listen
  std::vector<std::string>
      allow_origins;       ///< pages of elsewhere that may do what others may: https://app.foxglove.dev
  std::string token_file;  ///< its token is needed for everything; empty: on loopback reading is free, and
                           ///< commands need the run's own; needed where the address is not a loopback one
  bool allow_commands =
      false;               ///< of clients of an address that is not a loopback one; there the token is enough
  std::string bag_folder;  ///< served below /bags/; empty: none
  Limits limits;

  template <class Visitor>
  void fields(Visitor& v) {
    v("address", address, {.doc = "where to listen; not a loopback one: token_file is needed"});
    v("port", port, {.min = 0, .max = 65535, .first = true, .doc = "0: any free one"});
    v("host_names", host_names, {.doc = "names of this machine that clients may use, beside addresses"});
    v("allow_origins", allow_origins, {.doc = "pages of elsewhere that may connect"});
    v("token_file", token_file,
      {.path = true,
       .doc = "holds the token that is needed for reading too; none: each run has one for commands"});
    v("allow_commands", allow_commands, {.doc = "clients of other machines may command"});
    v("bag_folder", bag_folder, {.path = true, .doc = "recordings that the page may open"});
    v("limits", limits, {.doc = "what a client may take"});
    v.retired({"port_tries"}, "a constant of server_options.hpp");
  }
};

}  // namespace bw::web
