// The server by HTTP: pages, the folder of bags, and what is refused.
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "tests/folder.hpp"
#include "tests/runtime/remote/web/raw_client.hpp"
#include "tests/runtime/remote/web/recording_handler.hpp"

namespace bw::test {
namespace {

constexpr std::string_view kPage = "<!doctype html><title>a page</title>";

std::vector<std::uint8_t> gzip(std::string_view text) {
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::vector<std::uint8_t> out(text.size() + 100);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

web::Site small_site() {
  static const std::vector<std::uint8_t> page = gzip(kPage);
  return {.files = {{"/", "text/html; charset=utf-8", page, "\"abc\""}}};
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

TEST(Http, ServesThePageCompressedOrNot) {
  RunningServer run({}, small_site());
  const auto packed = ask(run.server.port(), "GET", "/", "Accept-Encoding: br, gzip\r\n");
  EXPECT_EQ(packed.status, 200);
  EXPECT_EQ(packed.headers.at("content-encoding"), "gzip");
  EXPECT_EQ(packed.headers.at("etag"), "\"abc\"");
  EXPECT_EQ(packed.headers.at("vary"), "Accept-Encoding");
  EXPECT_EQ(packed.headers.at("x-content-type-options"), "nosniff");
  EXPECT_EQ(packed.headers.at("referrer-policy"), "strict-origin");
  EXPECT_EQ(packed.headers.at("cache-control"), "private, no-cache");
  EXPECT_TRUE(
      packed.headers.at("content-security-policy").starts_with("default-src 'none'; script-src 'self';"));
  const auto compressed = gzip(kPage);
  EXPECT_EQ(packed.body, std::string(compressed.begin(), compressed.end()));

  const auto plain = ask(run.server.port(), "GET", "/", "Accept-Encoding: gzip;q=0\r\n");
  EXPECT_EQ(plain.status, 200);
  EXPECT_EQ(plain.headers.count("content-encoding"), 0U);
  EXPECT_EQ(plain.headers.at("etag"), "\"abc-plain\"");
  EXPECT_EQ(plain.body, kPage);

  const auto head = ask(run.server.port(), "HEAD", "/");
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), std::to_string(kPage.size()));

  const auto known =
      ask(run.server.port(), "GET", "/", "If-None-Match: \"x\", \"abc\"\r\nAccept-Encoding: gzip\r\n");
  EXPECT_EQ(known.status, 304);
  EXPECT_EQ(known.body, "");
}

/// While it lives this process may open one more file.
class OneDescriptor {
 public:
  OneDescriptor() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const int next = dup(0);
    close(next);
    const rlimit one{.rlim_cur = static_cast<rlim_t>(next) + 1, .rlim_max = before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &one);
  }
  ~OneDescriptor() { setrlimit(RLIMIT_NOFILE, &before_); }
  OneDescriptor(const OneDescriptor&) = delete;
  OneDescriptor& operator=(const OneDescriptor&) = delete;

 private:
  rlimit before_{};
};

// The last descriptor is the client's end: who was connected is answered, it is told once, and who waits is answered
// when there is room again.
TEST(Http, WithoutAFreeDescriptorItSaysSoAndServesThoseWhoAreThere) {
  constexpr std::string_view kAsk = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
  constexpr std::string_view kSays = "no file descriptor is free: who connects waits until one is";
  RunningServer run({}, small_site());
  RawClient here(run.server.port());
  EXPECT_TRUE(here.send(kAsk));
  EXPECT_EQ(here.receive().status, 200);
  auto limit = std::make_unique<OneDescriptor>();
  RawClient waits(run.server.port());
  EXPECT_TRUE(waits.send(kAsk));
  EXPECT_TRUE(eventually([&] { return run.log_text().find(kSays) != std::string::npos; }));
  EXPECT_TRUE(here.send(kAsk));
  EXPECT_EQ(here.receive().status, 200);
  limit.reset();
  EXPECT_EQ(waits.receive().status, 200);
  EXPECT_EQ(run.log_text().find(kSays), run.log_text().rfind(kSays));
}

TEST(Http, SaysSoWhereItWasBuiltWithoutAPage) {
  RunningServer run;
  const auto answer = ask(run.server.port(), "GET", "/");
  EXPECT_EQ(answer.status, 200);
  EXPECT_THAT(answer.body, ::testing::HasSubstr("built without its page"));
}

TEST(Http, AnswersRequestAfterRequestOnOneConnection) {
  RunningServer run({}, small_site());
  RawClient client(run.server.port());
  for (int i = 0; i < 3; ++i) {
    client.send(request_text("GET", "/"));
    EXPECT_EQ(client.receive().body, kPage);
  }
  client.send(request_text("GET", "/") + request_text("GET", "/nothing"));
  EXPECT_EQ(client.receive().status, 200);
  EXPECT_EQ(client.receive().status, 404);
}

struct Refused {
  std::string request;
  int status;
  std::string reason;
};

TEST(Http, RefusesBadRequestsWithAReason) {
  Folder folder;
  write(folder / "a.mcap", "bag");
  RunningServer run({.bag_folder = folder / ""}, small_site());
  const std::string host = "Host: localhost\r\n\r\n";
  const std::vector<Refused> all = {
      {request_text("GET", "/nothing"), 404, "no such page"},
      {request_text("GET", "/bags/none.mcap"), 404, "no such file"},
      {request_text("DELETE", "/"), 405, "GET, HEAD"},
      {request_text("PUT", "/bags/a.mcap", "", "x"), 405, "GET, HEAD"},
      {request_text("OPTIONS", "/"), 405, "GET, HEAD"},
      {"BREW / HTTP/1.1\r\n" + host, 405, "GET, HEAD"},
      {"GET http://elsewhere/ HTTP/1.1\r\n" + host, 400, "begins with /"},
      {request_text("GET", "/bags/../secret"), 400, "no .."},
      {request_text("GET", "/bags/%2e%2e/secret"), 400, "no .."},
      {request_text("GET", "/bags/..%2fsecret"), 400, "no /"},
      {request_text("GET", "/bags/a%5c..%5cb"), 400, "no / and no \\"},
      {request_text("GET", "/bags/a%00.mcap"), 400, "control"},
      {request_text("GET", "/bags/%zz"), 400, "hexadecimal"},
      {request_text("GET", "/bags//a.mcap"), 400, "empty"},
      {"GET / HTTP/1.1\r\n\r\n", 400, "Host"},
      {"GET / HTTP/1.1\r\nHost: localhost\r\n" + host, 400, "Host"},
      {"\r\n\r\n", 400, "no HTTP"},
      {std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11) + "\r\n\r\n", 400, "no HTTP"},  // TLS
      {"GET / HTTP/3.7\r\n" + host, 400, "bad version"},
      {"GET / HTTP/1.1\r\nbad header\r\n" + host, 400, "no HTTP"},
      {request_text("GET", "/", "X: " + std::string(20000, 'x') + "\r\n"), 431, "header"},
      {request_text("POST", "/login", "", std::string(5000, 'x')), 413, "body"},
      {request_text("POST", "/login", "Content-Length: 1000000000000\r\n"), 413, "body"},
      {request_text("POST", "/login", "Content-Length: x\r\n"), 400, "no HTTP"},
  };
  for (const Refused& one : all) {
    RawClient client(run.server.port());
    client.send(one.request);
    const auto answer = client.receive();
    EXPECT_EQ(answer.status, one.status) << one.request.substr(0, 80);
    EXPECT_THAT(answer.body, ::testing::HasSubstr(one.reason)) << one.request.substr(0, 80);
    EXPECT_EQ(answer.headers.count("content-type"), 1U);
  }
  EXPECT_EQ(ask(run.server.port(), "GET", "/").status, 200);
  EXPECT_THAT(run.log_text(), ::testing::Not(::testing::HasSubstr("abcdefghijklmnop")));
}

TEST(Http, CutsOffWhoTakesLongForAHeader) {
  web::ServerOptions options;
  options.limits.header_time = 0.1;
  RunningServer run(options, small_site());
  RawClient silent(run.server.port());
  RawClient slow(run.server.port());
  slow.send("GET / HTTP/1.1\r\nHost: localhost\r\nX: ");
  RawClient slow_body(run.server.port());
  slow_body.send("POST /login HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10\r\n\r\ntok");
  EXPECT_TRUE(silent.ends());
  EXPECT_TRUE(slow.ends());
  EXPECT_TRUE(slow_body.ends());
}

TEST(Http, ListsAndServesTheFolderOfBags) {
  Folder folder;
  write(folder / "a.mcap", "0123456789");
  write(folder / "run/run_0.mcap", "x");
  write(folder / "with space.mcap", "spaced");
  write(folder / "notes.txt", "not a recording");
  write(folder / ".hidden", "secret");
  RunningServer run({.bag_folder = folder / ""});
  const auto port = run.server.port();
  const auto list = nlohmann::json::parse(ask(port, "GET", "/bags/").body);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0]["path"], "a.mcap");
  EXPECT_EQ(list[0]["size"], 10);
  EXPECT_GT(list[0]["modified"], 1e9);
  EXPECT_EQ(list[1]["path"], "run/run_0.mcap");
  EXPECT_EQ(ask(port, "GET", "/bags/run/run_0.mcap").body, "x");
  EXPECT_EQ(ask(port, "GET", "/bags/with%20space.mcap").body, "spaced");
  EXPECT_EQ(ask(port, "GET", "/bags/.hidden").status, 404);
  EXPECT_EQ(ask(port, "GET", "/bags/notes.txt").status, 404);

  const auto whole = ask(port, "GET", "/bags/a.mcap");
  EXPECT_EQ(whole.body, "0123456789");
  EXPECT_EQ(whole.headers.at("accept-ranges"), "bytes");
  EXPECT_EQ(whole.headers.at("content-type"), "application/octet-stream");
  const std::string etag = whole.headers.at("etag");
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap", "If-None-Match: " + etag + "\r\n").status, 304);
  EXPECT_EQ(ask(port, "HEAD", "/bags/a.mcap").headers.at("content-length"), "10");

  const auto part = ask(port, "GET", "/bags/a.mcap", "Range: bytes=2-4\r\n");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.body, "234");
  EXPECT_EQ(part.headers.at("content-range"), "bytes 2-4/10");
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap", "Range: bytes=8-\r\n").body, "89");
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap", "Range: bytes=-3\r\n").body, "789");
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap", "Range: bytes=2-4\r\nIf-Range: " + etag + "\r\n").body, "234");
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap", "Range: bytes=2-4\r\nIf-Range: \"old\"\r\n").body, "0123456789");
  const auto beyond = ask(port, "GET", "/bags/a.mcap", "Range: bytes=10-\r\n");
  EXPECT_EQ(beyond.status, 416);
  EXPECT_EQ(beyond.headers.at("content-range"), "bytes */10");
}

TEST(Http, ServesALargeFileWithoutTakingItIntoMemory) {
  Folder folder;
  std::ofstream(folder / "large.mcap") << "begin";
  std::filesystem::resize_file(folder / "large.mcap", std::uint64_t{64} << 30);  // sparse
  RunningServer run({.bag_folder = folder / ""});
  RawClient client(run.server.port());
  client.send(request_text("GET", "/bags/large.mcap", "Range: bytes=68719476000-\r\n"));
  EXPECT_EQ(client.receive().body, std::string(736, '\0'));
  client.send(request_text("GET", "/bags/large.mcap"));
  EXPECT_EQ(client.receive(false).headers.at("content-length"), "68719476736");
}

TEST(Http, NothingOutsideOfTheFolderIsServed) {
  Folder folder;
  write(folder / "secret", "secret");
  write(folder / "elsewhere/b.mcap", "secret");
  write(folder / "bags/a.mcap", "bag");
  std::filesystem::create_symlink(folder / "secret", folder / "bags/link.mcap");
  std::filesystem::create_symlink("a.mcap", folder / "bags/inner.mcap");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "bags/elsewhere");
  std::filesystem::create_hard_link(folder / "bags/a.mcap", folder / "bags/same.mcap");
  ASSERT_EQ(mkfifo((folder / "bags/fifo.mcap").c_str(), 0600), 0);
  RunningServer run({.bag_folder = folder / "bags"});
  const auto port = run.server.port();
  EXPECT_EQ(nlohmann::json::parse(ask(port, "GET", "/bags/").body).size(), 2U);  // a.mcap, same.mcap
  EXPECT_EQ(ask(port, "GET", "/bags/link.mcap").status, 403);
  EXPECT_EQ(ask(port, "GET", "/bags/inner.mcap").status, 403);
  EXPECT_EQ(ask(port, "GET", "/bags/elsewhere/b.mcap").status, 403);
  EXPECT_EQ(ask(port, "GET", "/bags/fifo.mcap").status, 403);
  EXPECT_EQ(ask(port, "GET", "/bags/a.mcap/b").status, 404);
  EXPECT_EQ(ask(port, "GET", "/bags/same.mcap").body, "bag");
}

TEST(Http, PagesOfElsewhereAreRefused) {
  RunningServer run({.allow_origins = {"https://app.foxglove.dev"}}, small_site());
  const auto port = run.server.port();
  EXPECT_EQ(ask(port, "GET", "/", "Origin: https://evil.example\r\n").status, 403);
  EXPECT_EQ(ask(port, "POST", "/", "Origin: https://evil.example\r\n", "x").status, 403);
  EXPECT_EQ(ask(port, "POST", "/login", "Origin: https://evil.example\r\n", "token=x").status, 403);
  EXPECT_EQ(ask(port, "GET", "/", "Origin: null\r\n").status, 403);
  EXPECT_EQ(ask(port, "GET", "/", "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n").status, 403);
  const auto named = ask(port, "GET", "/", "Origin: https://app.foxglove.dev\r\n");
  EXPECT_EQ(named.status, 200);
  EXPECT_EQ(named.headers.at("access-control-allow-origin"), "https://app.foxglove.dev");
  const auto local = ask(port, "GET", "/", "Origin: http://localhost:8080\r\n");
  EXPECT_EQ(local.headers.at("access-control-allow-origin"), "http://localhost:8080");
  const auto own = ask(port, "GET", "/", "Origin: http://127.0.0.1\r\n");
  EXPECT_EQ(own.headers.count("access-control-allow-origin"), 0U);
  const auto preflight = ask(port, "OPTIONS", "/bags/a.mcap",
                             "Origin: https://app.foxglove.dev\r\nAccess-Control-Request-Method: GET\r\n");
  EXPECT_EQ(preflight.status, 204);
  EXPECT_EQ(preflight.headers.at("access-control-allow-methods"), "GET, HEAD");
  RawClient rebound(port);
  rebound.send("GET / HTTP/1.1\r\nHost: evil.example:" + std::to_string(port) + "\r\n\r\n");
  EXPECT_EQ(rebound.receive().status, 403);
}

TEST(Http, TakesTheNextPortWhereOneIsTaken) {
  RunningServer first;
  web::Server second({.port = first.server.port()}, {}, {"a"}, Logger());
  EXPECT_GT(second.port(), first.server.port());
  EXPECT_LE(second.port(), first.server.port() + 19);
  EXPECT_EQ(second.address(), "http://127.0.0.1:" + std::to_string(second.port()) + "/");
  EXPECT_THROW(web::Server({.port = first.server.port(), .port_tries = 1}, {}, {"a"}, Logger()),
               std::runtime_error);
}

TEST(Http, ListensBeyondTheMachineOnlyWithAToken) {
  try {
    web::Server server({.address = "0.0.0.0", .port = 0}, {}, {"a"}, Logger());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "address: 0.0.0.0 can be reached from other machines: a token_file is needed");
  }
  EXPECT_THROW(web::Server({.address = "robot"}, {}, {"a"}, Logger()), std::runtime_error);
  EXPECT_THROW(web::Server({.port = 0, .bag_folder = "/no/such/folder"}, {}, {"a"}, Logger()),
               std::runtime_error);
}

TEST(Http, OnlySoManyConnectionsAreOpen) {
  web::ServerOptions options;
  options.limits.connections = 2;
  RunningServer run(options, small_site());
  RawClient first(run.server.port());
  first.send(request_text("GET", "/"));
  EXPECT_EQ(first.receive().status, 200);
  {
    RawClient second(run.server.port());
    second.send(request_text("GET", "/"));
    EXPECT_EQ(second.receive().status, 200);
    EXPECT_TRUE(RawClient(run.server.port()).ends());
  }
  EXPECT_TRUE(eventually([&] { return ask(run.server.port(), "GET", "/").status == 200; }));
}

}  // namespace
}  // namespace bw::test
