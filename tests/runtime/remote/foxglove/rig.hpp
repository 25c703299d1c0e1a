// A server between a robot and sockets that are not there. What clients get is kept per client, and taken by
// the test.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runtime/remote/foxglove/server.hpp"
#include "tests/runtime/remote/foxglove/fake_robot.hpp"

namespace bw::foxglove::test {

using nlohmann::json;
using web::ConnectionId;
using web::Keep;

struct Sent {
  bool is_text = false;
  std::string bytes;  ///< head and body
  Keep keep;
};

class FakeSender final : public web::SocketSender {
 public:
  void send(ConnectionId id, web::Frame frame, Keep keep) override {
    Sent& sent = sent_[id].emplace_back();
    sent.is_text = frame.is_text;
    sent.keep = keep;
    sent.bytes.assign(frame.head.bytes().begin(), frame.head.bytes().end());
    if (frame.body != nullptr) sent.bytes.append(frame.body->begin(), frame.body->end());
  }
  void close(ConnectionId, std::uint16_t, const std::string&) override {
    ADD_FAILURE() << "the server closes a socket";
  }
  std::vector<Sent> take(ConnectionId id) { return std::exchange(sent_[id], {}); }

 private:
  std::map<ConnectionId, std::vector<Sent>> sent_;
};

/// `text` and little-endian numbers, one after the other.
class Packed {
 public:
  template <class Number>
  Packed& le(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes_ += static_cast<char>(value >> (8 * i));
    return *this;
  }
  Packed& text(std::string_view text) {
    bytes_ += text;
    return *this;
  }
  operator std::string() const { return bytes_; }  // NOLINT: that is what it is for

 private:
  std::string bytes_;
};

class Rig : public testing::Test {
 protected:
  void SetUp() override { start(); }

  void start(ServerOptions options = {}) {
    server_.reset();
    options.session = "run 1";
    server_ = std::make_unique<Server>(sender_, robot_, std::move(options), [this] { return now_; });
  }

  /// What it got at the beginning is forgotten, unless the test takes it by itself.
  void open(ConnectionId id, bool may_command = true, std::string_view subprotocol = kSdkV1) {
    server_->on_open(id, {.subprotocol = std::string(subprotocol),
                          .peer = "127.0.0.1:" + std::to_string(50000 + id),
                          .origin = "",
                          .read_only = may_command ? "" : "commands need a token"});
  }
  void opened(ConnectionId id, bool may_command = true, std::string_view subprotocol = kSdkV1) {
    open(id, may_command, subprotocol);
    sender_.take(id);
  }

  void text(ConnectionId id, const json& op) { server_->on_text(id, op.dump()); }
  void binary(ConnectionId id, const std::string& bytes) {
    server_->on_binary(id, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  void subscribe(ConnectionId id, std::uint32_t subscription, std::uint32_t channel) {
    text(id, {{"op", "subscribe"}, {"subscriptions", {{{"id", subscription}, {"channelId", channel}}}}});
  }

  /// Everything that came since the last call; all of it must be texts.
  std::vector<json> texts(ConnectionId id) {
    std::vector<json> ops;
    for (const Sent& sent : sender_.take(id)) {
      EXPECT_TRUE(sent.is_text) << testing::PrintToString(sent.bytes);
      if (sent.is_text) ops.push_back(json::parse(sent.bytes));
    }
    return ops;
  }
  /// The only thing that came, a text.
  json only_text(ConnectionId id) {
    const std::vector<json> ops = texts(id);
    EXPECT_EQ(ops.size(), 1U) << json(ops).dump();
    return ops.empty() ? json::object() : ops.front();
  }
  /// The only thing that came: a status of this level whose message contains this.
  void expect_status(ConnectionId id, int level, const std::string& part) {
    const json op = only_text(id);
    EXPECT_EQ(op.value("op", ""), "status") << op.dump();
    EXPECT_EQ(op.value("level", -1), level) << op.dump();
    EXPECT_NE(op.value("message", "").find(part), std::string::npos) << op.dump();
  }
  std::vector<std::string> payloads(ConnectionId id) {
    std::vector<std::string> all;
    for (Sent& sent : sender_.take(id)) all.push_back(std::move(sent.bytes));
    return all;
  }

  void pass(Duration time) { now_ = now_ + time; }

  FakeRobot robot_;
  FakeSender sender_;
  Time now_;  ///< of the server's clock
  std::unique_ptr<Server> server_;
};

inline std::string message_bytes(std::uint32_t subscription, Time time, std::string_view payload) {
  return Packed()
      .le(std::uint8_t{1})
      .le(subscription)
      .le(static_cast<std::uint64_t>(time.nanoseconds))
      .text(payload);
}

}  // namespace bw::foxglove::test
