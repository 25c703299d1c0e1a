// Both ends of a ROS 2 service by the letter of what rmw_fastrtps does: two topics, the identities in the
// inline QoS, nothing in the payload.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "tests/interop/plain/node.hpp"

namespace plain {

/// Of pkg/srv/Name: the topics and types of service /a/s are rq/a/sRequest, pkg::srv::dds_::Name_Request_ and
/// so on.
struct ServiceType {
  std::string name;          ///< std_srvs/srv/Trigger
  std::string request_hash;  ///< RIHS01_...
  std::string response_hash;
};

std::string request_topic(const std::string& service);
std::string reply_topic(const std::string& service);
std::string request_type(const std::string& type);
std::string response_type(const std::string& type);

class Client {
 public:
  /// What the request says of whom to answer.
  enum class Identity {
    reply_reader,    ///< rmw_fastrtps
    request_writer,  ///< named outright
    unknown,         ///< nothing: old clients, and other vendors'
  };

  Client(Node& node, const std::string& service, const ServiceType& type,
         Identity identity = Identity::reply_reader, int depth = 10);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// As many request readers as reply writers in the graph, and as many of each connected, not none.
  bool is_ready() const;
  /// The request's sequence number.
  std::int64_t send(const Bytes& request);
  /// The reply to one request; nothing as long as there is none.
  std::optional<Bytes> take(std::int64_t sequence);
  /// Sends once ready and waits; nothing when no reply came in time.
  std::optional<Bytes> call(const Bytes& request, std::chrono::milliseconds limit = std::chrono::seconds(10));
  /// Replies to others that came here.
  int foreign_replies() const { return foreign_replies_; }

  dds::DataWriter& writer() { return *writer_; }
  dds::DataReader& reader() { return *reader_; }

 private:
  Node& node_;
  std::string service_;
  Identity identity_;
  dds::DataReader* reader_;
  dds::DataWriter* writer_;
  std::map<std::int64_t, Bytes> replies_;
  int foreign_replies_ = 0;
};

struct Request {
  rtps::SampleIdentity from;  ///< whom to answer
  rtps::GUID_t related;       ///< as it came
  rtps::GUID_t writer;
  Bytes bytes;
};

class Server {
 public:
  /// `without_reply_writer`: half of a server, until complete().
  Server(Node& node, const std::string& service, const ServiceType& type, bool without_reply_writer = false);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void complete();
  std::optional<Request> take();
  /// Waits until the client's reader is connected, 100 ms at most as rmw_fastrtps does; false when it is not:
  /// the reply is dropped.
  bool reply(const rtps::SampleIdentity& to, const Bytes& response);
  int connected_clients();
  int connected_writers() const;

 private:
  class Matches;
  Node& node_;
  EndOptions reply_end_;
  std::unique_ptr<Matches> matches_;
  dds::DataReader* reader_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace plain
