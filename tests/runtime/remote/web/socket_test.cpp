// The server by WebSocket.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/remote/web/raw_client.hpp"
#include "tests/runtime/remote/web/recording_handler.hpp"

namespace bw::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::uint8_t kText = 0x81;
constexpr std::uint8_t kBinary = 0x82;

TEST(Socket, EchoesTheSubprotocolThatWasAgreedOn) {
  RunningServer run;
  RawClient client(run.server.port());
  client.send(handshake_text("Origin: http://localhost:5173\r\n", "other, foxglove.websocket.v1",
                             "/?token=" + run.server.run_token()));
  const auto answer = client.receive();
  EXPECT_EQ(answer.status, 101);
  EXPECT_EQ(answer.headers.at("sec-websocket-protocol"), "foxglove.websocket.v1");
  EXPECT_EQ(answer.headers.at("sec-websocket-accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");  // RFC 6455, 1.3
  const web::ConnectionId id = run.handler.last();
  const auto opening = run.handler.open().at(id);
  EXPECT_EQ(opening.subprotocol, "foxglove.websocket.v1");
  EXPECT_EQ(opening.origin, "http://localhost:5173");
  EXPECT_EQ(opening.read_only, "");
  EXPECT_EQ(run.log_text().find(run.server.run_token()), std::string::npos);
  EXPECT_THAT(opening.peer, HasSubstr("127.0.0.1:"));

  RawClient both(run.server.port());  // as Lichtblick offers them: the server's first choice
  both.send(handshake_text("", "foxglove.websocket.v1,foxglove.sdk.v1"));
  EXPECT_EQ(both.receive().headers.at("sec-websocket-protocol"), "foxglove.sdk.v1");
}

TEST(Socket, RefusesHandshakesWithAReason) {
  RunningServer run;
  struct Refused {
    std::string request;
    int status;
    std::string reason;
  };
  const std::vector<Refused> all = {
      {handshake_text("", "chat"), 400, "foxglove.sdk.v1, foxglove.websocket.v1"},
      {handshake_text("", ""), 400, "foxglove.sdk.v1, foxglove.websocket.v1"},
      {handshake_text("Origin: https://evil.example\r\n"), 403, "--allow-origin"},
      {handshake_text("", "foxglove.sdk.v1", "/other"), 404, "at /"},
      {handshake_text("Content-Length: 5\r\n") + "12345", 400, "no body"},
      {handshake_text() + frame_text(kText, "early"), 400, "waits for its answer"},
      {request_text("POST", "/", "Upgrade: websocket\r\nConnection: Upgrade\r\n"), 400,
       "no WebSocket handshake"},
      {request_text("GET", "/", "Upgrade: websocket\r\n"), 400, "no WebSocket handshake"},
      {request_text(
           "GET", "/",
           "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n"),
       400, "Sec-WebSocket-Key"},
  };
  for (const Refused& one : all) {
    RawClient client(run.server.port());
    client.send(one.request);
    const auto answer = client.receive();
    EXPECT_EQ(answer.status, one.status) << one.request;
    EXPECT_THAT(answer.body, HasSubstr(one.reason)) << one.request;
  }
  EXPECT_TRUE(run.handler.open().empty());
  EXPECT_EQ(run.handler.closed(), 0);
}

TEST(Socket, HandsOnWhatItHears) {
  web::ServerOptions options;
  options.limits.close_time = 0.05;
  RunningServer run(options);
  RawClient client = open_socket(run.server.port());
  client.send(frame_text(kText, "{\"op\":1}"));
  client.send(frame_text(kBinary, std::string(70000, 'b')));
  client.send(frame_text(0x01, "three ") + frame_text(0x00, "parts ") + frame_text(0x89, "ping") +
              frame_text(0x80, "of text"));
  EXPECT_EQ(client.receive_frame().opcode, 10);  // pong, before anything else
  ASSERT_TRUE(eventually([&] { return run.handler.heard().size() == 3; }));
  EXPECT_THAT(run.handler.heard(), ElementsAre("text {\"op\":1}", "binary " + std::string(70000, 'b'),
                                               "text three parts of text"));
  client.send(frame_text(0x88, "\x03\xe8"));
  EXPECT_EQ(client.receive_frame().close_code(), 1000);
  EXPECT_TRUE(client.ends());
  EXPECT_TRUE(eventually([&] { return run.handler.closed() == 1; }));
}

TEST(Socket, SendsHeadAndBodyAsOneFrame) {
  RunningServer run;
  RawClient first = open_socket(run.server.port());
  const auto first_id = run.handler.last();
  RawClient second = open_socket(run.server.port());
  const auto second_id = run.handler.last(2);
  const auto body = std::make_shared<const web::Bytes>(100'000, 'x');
  const auto frame = [&](std::uint8_t subscription) {
    return web::Frame{.head = web::Head(std::vector<std::uint8_t>{1, subscription}), .body = body};
  };
  run.server.send(first_id, frame(7), {});
  run.server.send(second_id, frame(9), {});
  run.server.send(first_id, web::text_frame("then text"), {});
  run.server.send(first_id, web::binary_frame({}), {});
  const auto got = first.receive_frame();
  EXPECT_EQ(got.opcode, 2);
  EXPECT_TRUE(got.is_last);
  EXPECT_EQ(got.payload, "\x01\x07" + std::string(100'000, 'x'));
  EXPECT_EQ(second.receive_frame().payload, "\x01\x09" + std::string(100'000, 'x'));
  EXPECT_EQ(first.receive_frame().payload, "then text");
  EXPECT_EQ(first.receive_frame().payload, "");
}

TEST(Socket, ClosesWhoBreaksTheProtocol) {
  web::ServerOptions options;
  options.limits.message_bytes = 10000;
  options.limits.close_time = 0.05;
  RunningServer run(options);
  const std::string large_claim("\x82\xff\x00\x00\x00\x00\x40\x00\x00\x00mask", 14);  // 1 GB
  const std::string huge_claim("\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xffmask", 14);
  struct Broken {
    std::string what;
    std::string bytes;
    int code;
  };
  const std::vector<Broken> all = {
      {"opcode 3", frame_text(0x83, "x"), 1002},
      {"opcode 11", frame_text(0x8b, "x"), 1002},
      {"a reserved bit", frame_text(0xc1, "x"), 1002},
      {"not masked", std::string("\x81\x01x", 3), 1002},
      {"a continuation of nothing", frame_text(0x80, "x"), 1002},
      {"a message within a message", frame_text(0x01, "x") + frame_text(0x81, "y"), 1002},
      {"a fragmented ping", frame_text(0x09, "x"), 1002},
      {"a ping of 126 bytes", frame_text(0x89, std::string(126, 'x')), 1002},
      {"a length in more bytes than it needs", std::string("\x81\xfe\x00\x05maskxxxxx", 13), 1002},
      {"no UTF-8", frame_text(kText, "\xff\xfe"), 1007},
      {"a close frame of one byte", frame_text(0x88, "x"), 1002},
      {"a close code that is none", frame_text(0x88, "\x03\xec"), 1002},  // 1004
      {"a claim of 1 GB", large_claim, 1009},
      {"a claim of 2^63 bytes", huge_claim, 1009},
      {"many parts, too large together",
       frame_text(0x02, std::string(6000, 'x')) + frame_text(0x80, std::string(6000, 'x')), 1009},
  };
  for (const Broken& one : all) {
    RawClient client = open_socket(run.server.port());
    client.send(one.bytes);
    EXPECT_EQ(client.receive_frame().close_code(), one.code) << one.what;
    EXPECT_TRUE(client.ends()) << one.what;
  }
  EXPECT_TRUE(run.handler.heard().empty());
  EXPECT_TRUE(eventually([&] { return run.handler.open().empty(); }));
}

TEST(Socket, DropsWhoAnswersNoPing) {
  web::ServerOptions options;
  options.limits.idle_time = 0.2;
  RunningServer run(options);
  RawClient silent = open_socket(run.server.port());
  EXPECT_EQ(silent.receive_frame().opcode, 9);
  EXPECT_TRUE(silent.ends());
  EXPECT_TRUE(eventually([&] { return run.handler.closed() == 1; }));

  RawClient alive = open_socket(run.server.port());
  for (int pings = 0; pings < 5; ++pings) {  // half a second: more than twice as long as the other had
    ASSERT_EQ(alive.receive_frame().opcode, 9);
    alive.send(frame_text(0x8a, ""));
  }
}

TEST(Socket, ClosesWithCodeAndReasonAfterWhatIsQueued) {
  web::ServerOptions options;
  options.limits.close_time = 0.2;
  RunningServer run(options);
  RawClient client = open_socket(run.server.port());
  const auto id = run.handler.last();
  run.server.send(id, web::text_frame("last words"), {});
  run.server.close(id, 1008, "not like this");
  run.server.send(id, web::text_frame("too late"), {});
  EXPECT_EQ(client.receive_frame().payload, "last words");
  const auto closed = client.receive_frame();
  EXPECT_EQ(closed.close_code(), 1008);
  EXPECT_EQ(closed.payload.substr(2), "not like this");
  client.send(frame_text(kText, "ignored"));
  client.send(frame_text(0x88, "\x03\xf0"));
  EXPECT_TRUE(client.ends());
  EXPECT_TRUE(eventually([&] { return run.handler.closed() == 1; }));
  EXPECT_TRUE(run.handler.heard().empty());
  run.server.send(id, web::text_frame("nobody"), {});
  run.server.close(id, 1000, "");
}

TEST(Socket, DoesNotWaitForAClosingHandshake) {
  web::ServerOptions options;
  options.limits.close_time = 0.05;
  RunningServer run(options);
  RawClient client = open_socket(run.server.port());
  run.server.close(run.handler.last(), 1000, "");
  EXPECT_TRUE(eventually([&] { return run.handler.closed() == 1; }));
  EXPECT_TRUE(client.ends());
}

// A client that reads nothing has the newest of each stream and its latched frame when it reads at last; one
// beside it misses nothing.
TEST(Socket, ASlowClientLosesOlderFramesAndDelaysNobody) {
  web::ServerOptions options;
  options.limits.queued_bytes = 1 << 20;
  RunningServer run(options);
  RawClient slow = RawClient::that_reads_little(run.server.port());
  slow.send(handshake_text());
  ASSERT_EQ(slow.receive().status, 101);
  const auto slow_id = run.handler.last();
  RawClient quick = open_socket(run.server.port());
  const auto quick_id = run.handler.last(2);
  const auto body = std::make_shared<const web::Bytes>(50'000, 'x');
  const auto send = [&](web::ConnectionId id, std::uint8_t number, web::Keep keep) {
    run.server.send(id, {.head = web::Head(std::vector<std::uint8_t>{number}), .body = body}, keep);
  };
  const web::Keep data{web::Keep::Rule::newest, 1};
  for (std::uint8_t i = 0; i < 20; ++i) send(slow_id, 100, data);
  send(slow_id, 200, {web::Keep::Rule::latched, 2});
  for (std::uint8_t i = 1; i <= 100; ++i) {
    send(slow_id, i, data);
    send(quick_id, i, data);
    ASSERT_EQ(static_cast<std::uint8_t>(quick.receive_frame().payload.at(0)), i);
  }
  // 8 MB of 50 kB frames were offered; 1 MiB may wait, and the kernel takes some.
  std::vector<int> got;
  while (got.empty() || got.back() != 100 || std::count(got.begin(), got.end(), 200) == 0) {
    const auto frame = slow.receive_frame();
    ASSERT_EQ(frame.opcode, 2);
    got.push_back(static_cast<std::uint8_t>(frame.payload.at(0)));
  }
  EXPECT_LT(got.size(), 60U);
  EXPECT_EQ(std::count(got.begin(), got.end(), 200), 1);
}

TEST(Socket, WhoDoesNotReadAnswersIsClosed) {
  web::ServerOptions options;
  options.limits.control_bytes = 1 << 20;
  options.limits.close_time = 0.05;
  RunningServer run(options);
  RawClient client = RawClient::that_reads_little(run.server.port());
  client.send(handshake_text());
  ASSERT_EQ(client.receive().status, 101);
  const auto id = run.handler.last();
  for (int i = 0; i < 100; ++i) run.server.send(id, web::text_frame(std::string(100'000, 'a')), {});
  EXPECT_TRUE(eventually([&] { return run.handler.closed() == 1; }));
  EXPECT_TRUE(client.ends());
}

TEST(Socket, OnlySoManyAreOpenedAndOpen) {
  web::ServerOptions options;
  options.limits.sockets = 2;
  RunningServer run(options);
  RawClient first = open_socket(run.server.port());
  RawClient second = open_socket(run.server.port());
  RawClient third(run.server.port());
  third.send(handshake_text());
  EXPECT_EQ(third.receive().status, 503);

  options.limits.handshakes_per_second = 0.1;  // and a burst of one
  RunningServer slow(options);
  RawClient one = open_socket(slow.server.port());
  RawClient other(slow.server.port());
  other.send(handshake_text());
  const auto answer = other.receive();
  EXPECT_EQ(answer.status, 503);
  EXPECT_EQ(answer.headers.at("retry-after"), "1");
}

TEST(Socket, SendingIsForAnyThread) {
  RunningServer run;
  RawClient client = open_socket(run.server.port());
  const auto id = run.handler.last();
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 500; ++i)
        run.server.send(id, web::text_frame(std::to_string(t) + ' ' + std::to_string(i)), {});
    });
  }
  std::vector<int> next(4, 0);
  for (int i = 0; i < 2000; ++i) {
    const auto frame = client.receive_frame();
    ASSERT_EQ(frame.opcode, 1);
    const auto thread = static_cast<std::size_t>(frame.payload.at(0) - '0');
    EXPECT_EQ(frame.payload.substr(2), std::to_string(next.at(thread)++));
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(Socket, CallsArePostedToOneThread) {
  RunningServer run;
  std::atomic<int> calls = 0;
  std::thread::id posted;
  run.server.after(std::chrono::milliseconds(5), [&] {
    EXPECT_EQ(std::this_thread::get_id(), posted);
    ++calls;
  });
  run.server.post([&] {
    posted = std::this_thread::get_id();
    EXPECT_NE(posted, std::thread::id());
    ++calls;
  });
  run.server.post([] { throw std::runtime_error("a call that throws ends nothing"); });
  EXPECT_TRUE(eventually([&] { return calls == 2; }));
  EXPECT_THAT(run.log_text(), HasSubstr("a call that throws ends nothing"));
}

TEST(Socket, StoppingTellsEverybody) {
  RunningServer run;
  RawClient client = open_socket(run.server.port());
  RawClient silent = RawClient::that_reads_little(run.server.port());
  silent.send(handshake_text());
  silent.receive();
  run.handler.last(2);
  run.server.after(std::chrono::hours(1), [] {});
  run.server.stop();
  EXPECT_EQ(run.handler.closed(), 2);
  EXPECT_EQ(client.receive_frame().close_code(), 1001);
  EXPECT_TRUE(client.ends());
  run.server.stop();
}

}  // namespace
}  // namespace bw::test
