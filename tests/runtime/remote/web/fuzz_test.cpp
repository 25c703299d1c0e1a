// Mutated handshakes, frames and HTTP requests: the server answers or closes, and serves the next one.
// BANDWAGON_WEB_FUZZ says how many, 10000 by default; README.md of runtime/remote/web has the command for
// 1000000 with sanitizers.
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/remote/web/server.hpp"
#include "tests/folder.hpp"
#include "tests/runtime/remote/web/raw_client.hpp"

namespace bw::test {
namespace {

int cases() {
  const char* text = std::getenv("BANDWAGON_WEB_FUZZ");
  return text != nullptr ? std::atoi(text) : 10000;
}

/// Answers everything, so that both directions have work.
class Echo : public web::SocketHandler {
 public:
  void on_open(web::ConnectionId id, const web::Opening&) override {
    ++opened;
    sender->send(id, web::text_frame("hello"), {});
  }
  void on_text(web::ConnectionId id, std::string_view text) override {
    ++heard;
    sender->send(id, web::text_frame(text), {});
  }
  void on_binary(web::ConnectionId id, std::span<const std::uint8_t> bytes) override {
    ++heard;
    sender->send(id, web::binary_frame({bytes.begin(), bytes.end()}),
                 {web::Keep::Rule::newest, bytes.size() % 3});
  }
  void on_close(web::ConnectionId) override { ++closed; }

  web::SocketSender* sender = nullptr;
  std::atomic<int> opened = 0;
  std::atomic<int> closed = 0;
  std::atomic<int> heard = 0;
};

std::vector<std::string> requests() {
  return {
      request_text("GET", "/"),
      request_text("GET", "/bags/a.mcap", "Range: bytes=1-2\r\nIf-Range: \"x\"\r\n"),
      request_text("HEAD", "/bags/%61.mcap", "If-None-Match: \"a\", W/\"b\"\r\n"),
      request_text("GET", "/bags/", "Origin: http://localhost:1\r\nCookie: a=b; c=d\r\n"),
      request_text("POST", "/login", "Origin: http://127.0.0.1\r\nTransfer-Encoding: chunked\r\n") +
          "5\r\ntoken\r\n0\r\n\r\n",
      request_text("POST", "/login", "Authorization: Basic YTpi\r\n", "token=%41+b&c"),
      handshake_text("Origin: http://localhost\r\n", "foxglove.sdk.v1, foxglove.websocket.v1"),
      handshake_text("Authorization: Bearer 0123\r\n", "foxglove.sdk.v1", "/?a=%41&token=%30%31&token"),
      request_text("GET", "/?token=0123456789abcdef0123456789abcdef&bag=a.mcap"),
      handshake_text("Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits\r\n"),
  };
}

std::vector<std::string> frames() {
  return {
      frame_text(0x81, "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":2}]}"),
      frame_text(0x82, std::string("\x01\x02\x00\x00\x00payload", 12)),
      frame_text(0x01, "a part ") + frame_text(0x80, "and the rest \xc3\xa4"),
      frame_text(0x89, "ping") + frame_text(0x8a, "pong"),
      frame_text(0x82, std::string(300, 'x')),
      frame_text(0x82, std::string(70000, 'y')),
      frame_text(0x88,
                 "\x03\xe8"
                 "done"),
  };
}

/// Bits turned, bytes set, cut out, doubled, put in, or the end cut off.
void mutate(std::string& text, std::mt19937& random) {
  const auto below = [&](std::size_t bound) { return bound == 0 ? 0 : random() % bound; };
  for (std::size_t times = below(6); times > 0 && !text.empty(); --times) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        text[at] = "\x00\x7f\xff\r\n :/%;,=\"\x80\x01"[below(16)];
        break;
      case 2:
        text.erase(at, 1 + below(20));
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
      case 4:
        text.insert(at, 1 + below(300), static_cast<char>(random()));
        break;
      default:
        text.resize(at);
        break;
    }
  }
}

class WebFuzz : public ::testing::Test {
 protected:
  WebFuzz()
      : server_(options(), {}, {"foxglove.sdk.v1", "foxglove.websocket.v1"},
                Logger([](LogLevel level, const std::string& text) {
                  EXPECT_LT(level, LogLevel::error) << text;
                })) {
    echo_.sender = &server_;
    server_.start(echo_);
  }
  ~WebFuzz() override {
    server_.stop();
    EXPECT_EQ(echo_.opened, echo_.closed);
  }

  web::ServerOptions options() const {
    web::ServerOptions result;
    result.port = 0;
    result.bag_folder = folder_ / "";
    result.limits.connections = 1000;
    result.limits.sockets = 1000;
    result.limits.handshakes_per_second = 1e5;
    result.limits.message_bytes = 100'000;
    return result;
  }

  Folder folder_;
  Echo echo_;
  web::Server server_;
  std::mt19937 random_{15};
};

// One in eight connections is reset before its answer; of the others each is answered or closed.
TEST_F(WebFuzz, HttpRequests) {
  const auto seeds = requests();
  int answered = 0;
  for (int i = 0; i < cases() / 2; ++i) {
    std::string text = seeds[random_() % seeds.size()];
    mutate(text, random_);
    RawClient client(server_.port());
    client.send(text);
    if (random_() % 8 != 0) {
      client.end_sending();
      answered += client.receive(false).status != 0 ? 1 : 0;
      ASSERT_TRUE(client.ends()) << text;
    }
    client.reset();
  }
  std::printf("%d of %d answered\n", answered, cases() / 2);
  EXPECT_GT(answered, cases() / 8);
  EXPECT_EQ(ask(server_.port(), "GET", "/").status, 200);
}

// Four frames a connection, so that some follow what is sound and some what is broken.
TEST_F(WebFuzz, Frames) {
  const auto seeds = frames();
  for (int i = 0; i < cases() / 8; ++i) {
    RawClient client = open_socket(server_.port());
    for (int k = 0; k < 4; ++k) {
      std::string text = seeds[random_() % seeds.size()];
      mutate(text, random_);
      client.send(text);
    }
    if (random_() % 8 != 0) {
      client.end_sending();
      ASSERT_TRUE(client.ends());
    }
    client.reset();
  }
  std::printf("%d of %d heard\n", echo_.heard.load(), cases() / 2);
  EXPECT_EQ(echo_.opened, cases() / 8);
  EXPECT_GT(echo_.heard, cases() / 40);
  RawClient sound = open_socket(server_.port());
  EXPECT_EQ(sound.receive_frame().payload, "hello");
  sound.send(frame_text(0x81, "still there"));
  EXPECT_EQ(sound.receive_frame().payload, "still there");
}

}  // namespace
}  // namespace bw::test
