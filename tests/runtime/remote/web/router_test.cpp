// Who is let in to what, on a loopback address and on another, with and without the token: each operation,
// each way.
#include "runtime/remote/web/router.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/folder.hpp"

namespace bw::web {
namespace {

using ::testing::HasSubstr;

constexpr const char* kToken = "a token of 16 or more characters has none of these spaces";
constexpr const char* kSecret = "correct-horse-battery";

class RouterTest : public ::testing::Test {
 protected:
  RouterTest() {
    std::filesystem::create_directories(folder_ / "bags");
    std::ofstream(folder_ / "bags/a.mcap") << "bag";
    std::ofstream(folder_ / "token") << kSecret << '\n';
    chmod((folder_ / "token").c_str(), 0600);
  }

  Router router(bool is_loopback, bool allow_commands = false) const {
    return router(is_loopback, !is_loopback, allow_commands);
  }
  Router router(bool is_loopback, bool has_token_file, bool allow_commands) const {
    ServerOptions options;
    options.bag_folder = folder_ / "bags";
    options.allow_commands = allow_commands;
    options.allow_origins = {"https://app.foxglove.dev"};
    if (has_token_file) options.token_file = folder_ / "token";
    Router result(options, is_loopback, {}, {"foxglove.sdk.v1"});
    result.set_port(8765);
    return result;
  }

  static Request request(const std::string& method, const std::string& target,
                         std::vector<std::pair<std::string, std::string>> headers = {}) {
    headers.emplace_back("Host", "10.0.0.5:8765");
    headers.emplace_back("Sec-WebSocket-Protocol", "foxglove.sdk.v1");
    return {
        .method = method, .target = target, .headers = std::move(headers), .address = "10.0.0.9", .now = 1};
  }

  test::Folder folder_;
};

int status_of(const std::variant<Admission, Reply>& admitted) {
  const auto* refused = std::get_if<Reply>(&admitted);
  return refused ? refused->status : 101;
}

/// Why it may not command; of a socket that is let in.
std::string read_only(const std::variant<Admission, Reply>& admitted) {
  const auto* let_in = std::get_if<Admission>(&admitted);
  return let_in ? let_in->read_only : "not let in";
}

Request on_loopback(const std::string& method, const std::string& target,
                    std::vector<std::pair<std::string, std::string>> headers = {}) {
  headers.emplace_back("Host", "localhost:8765");
  headers.emplace_back("Sec-WebSocket-Protocol", "foxglove.sdk.v1");
  return {
      .method = method, .target = target, .headers = std::move(headers), .address = "127.0.0.1", .now = 1};
}

std::string token_of_run() { return Router({}, true, {}, {}).run_token(); }

/// A browser's login: the cookie as it sends it back.
std::string log_in(Router& router, Request login) {
  login.headers.emplace_back("Origin", "http://10.0.0.5:8765");
  login.body = std::string("token=") + kSecret;
  const Reply reply = router.answer(login);
  EXPECT_EQ(reply.status, 303);
  for (const auto& [name, value] : reply.headers) {
    if (name != "Set-Cookie") continue;
    EXPECT_TRUE(value.ends_with("; Path=/; HttpOnly; SameSite=Strict")) << value;
    return value.substr(0, value.find(';'));
  }
  ADD_FAILURE() << "no cookie";
  return {};
}

// Every operation that reads, with everything that is no right token.
TEST_F(RouterTest, WithoutTheTokenNothingIsRead) {
  const std::vector<std::pair<std::string, std::string>> credentials = {
      {"X-None", ""},
      {"Authorization", ""},
      {"Authorization", "Bearer"},
      {"Authorization", "Bearer wrong"},
      {"Authorization", std::string("Bearer ") + kSecret + "x"},
      {"Authorization", std::string("Token ") + kSecret},
      {"Authorization", "Basic cm9ib3Q6d3Jvbmc="},
      {"Cookie", "bandwagon_8765="},
      {"Cookie", "bandwagon_8765=00000000000000000000000000000000"},
      {"Cookie", std::string("bandwagon_8765=") + kSecret},
      {"Cookie", std::string("token=") + kSecret},
  };
  for (const auto& credential : credentials) {
    for (const std::string method : {"GET", "HEAD", "POST", "PUT", "OPTIONS"}) {
      for (const std::string target :
           {"/", "/app.js", "/bags/", "/bags/a.mcap", "/bags/none", "/nothing", "/logout"}) {
        Router fresh = router(false);  // so that it is not the number of attempts
        EXPECT_EQ(fresh.answer(request(method, target, {credential})).status, 401)
            << method << target << credential.second;
      }
    }
    Router fresh = router(false);
    EXPECT_EQ(status_of(fresh.admit(request("GET", "/", {credential}))), 401) << credential.second;
  }
}

TEST_F(RouterTest, WithTheTokenEverythingIsRead) {
  Router open = router(false);
  const std::string cookie = log_in(open, request("POST", "/login"));
  const std::vector<std::pair<std::string, std::string>> credentials = {
      {"Authorization", std::string("Bearer ") + kSecret},
      {"Authorization", "Basic YTpjb3JyZWN0LWhvcnNlLWJhdHRlcnk="},  // a:correct-horse-battery
      {"Cookie", "other=1; " + cookie + "; more=2"},
  };
  for (const auto& credential : credentials) {
    EXPECT_EQ(open.answer(request("GET", "/", {credential})).status, 200) << credential.second;
    EXPECT_EQ(open.answer(request("GET", "/bags/", {credential})).status, 200) << credential.second;
    EXPECT_EQ(open.answer(request("GET", "/bags/a.mcap", {credential})).status, 200) << credential.second;
    EXPECT_EQ(status_of(open.admit(request("GET", "/", {credential}))), 101) << credential.second;
  }
}

TEST_F(RouterTest, WithoutAFolderTheListOfBagsIsEmpty) {
  Router without(ServerOptions{}, true, {}, {"foxglove.sdk.v1"});
  without.set_port(8765);
  const auto local = [](const std::string& target) {
    return Request{.method = "GET",
                   .target = target,
                   .headers = {{"Host", "127.0.0.1:8765"}},
                   .address = "127.0.0.1",
                   .now = 1};
  };
  const Reply list = without.answer(local("/bags/"));
  EXPECT_EQ(list.status, 200);
  const auto* text = std::get_if<std::string>(&list.body);
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(*text, "[]");
  EXPECT_EQ(without.answer(local("/bags/a.mcap")).status, 404);
}

TEST_F(RouterTest, FromOtherMachinesCommandsAreOffUnlessTheyAreAllowed) {
  const auto asked = request("GET", "/", {{"Authorization", std::string("Bearer ") + kSecret}});
  EXPECT_THAT(read_only(router(false).admit(asked)), HasSubstr("--allow-commands"));
  EXPECT_EQ(read_only(router(false, true).admit(asked)), "");
}

// On loopback everybody may read; commands need the token, whoever asks: a page of any port, the server's
// own, a program without Origin.
TEST_F(RouterTest, OnLoopbackCommandsNeedTheRunsToken) {
  Router local = router(true);
  const std::string token = local.run_token();
  EXPECT_EQ(token.size(), 32U);                // 128 bits
  EXPECT_EQ(token, router(true).run_token());  // of the run, not of the server
  const std::vector<std::pair<std::string, std::string>> callers = {
      {"X-None", ""}, {"Origin", "http://localhost:3000"}, {"Origin", "http://localhost:8765"}};
  for (const auto& caller : callers) {
    const auto ask = [&](const std::string& target, std::pair<std::string, std::string> more = {"X", ""}) {
      return read_only(local.admit(on_loopback("GET", target, {caller, std::move(more)})));
    };
    EXPECT_THAT(ask("/"), HasSubstr("commands need the token of this run")) << caller.second;
    for (int i = 0; i < 10; ++i)  // no lockout: it would take the stop from who has the token
      EXPECT_THAT(ask("/?token=" + std::string(32, '0')), HasSubstr("not that of this run"));
    for (const std::string& wrong : {std::string(), token.substr(1), token + "0", "x" + token.substr(1)})
      EXPECT_THAT(ask("/?token=" + wrong), HasSubstr("not that of this run")) << wrong;
    EXPECT_THAT(ask("/?token=" + token, {"Authorization", "Bearer wrong"}),
                HasSubstr("not that of this run"));
    EXPECT_EQ(ask("/?token=" + token), "");
    EXPECT_EQ(ask("/", {"Authorization", "Bearer " + token}), "");
  }
  EXPECT_EQ(local.answer(on_loopback("GET", "/?token=" + token)).status, 200);
  EXPECT_EQ(local.answer(on_loopback("GET", "/?token=wrong")).status, 200);
}

// The rules of other machines, and the token is enough for commands.
TEST_F(RouterTest, OnLoopbackATokenFileIsForReadingToo) {
  const auto with_file = [this] { return router(true, true, false); };
  EXPECT_EQ(with_file().run_token(), "");
  EXPECT_EQ(with_file().answer(on_loopback("GET", "/bags/a.mcap")).status, 401);
  EXPECT_EQ(status_of(with_file().admit(on_loopback("GET", "/"))), 401);
  EXPECT_EQ(status_of(with_file().admit(on_loopback("GET", "/?token=wrong"))), 401);
  EXPECT_EQ(status_of(with_file().admit(on_loopback("GET", "/?token=" + token_of_run()))), 401);
  EXPECT_EQ(read_only(with_file().admit(on_loopback("GET", std::string("/?token=") + kSecret))), "");
  EXPECT_EQ(with_file().answer(on_loopback("GET", std::string("/?token=") + kSecret)).status, 400);
  Router locked = with_file();
  for (int i = 0; i < 5; ++i) static_cast<void>(locked.admit(on_loopback("GET", "/?token=wrong")));
  EXPECT_EQ(status_of(locked.admit(on_loopback("GET", std::string("/?token=") + kSecret))), 429);
}

// To a browser all ports of a machine are one site: SameSite keeps no cookie from a page of another port.
TEST_F(RouterTest, ACookieIsForItsOwnPage) {
  Router local = router(true, true, false);
  Request login = on_loopback("POST", "/login", {{"Origin", "http://localhost:8765"}});
  login.body = std::string("token=") + kSecret;
  const Reply reply = local.answer(login);
  ASSERT_EQ(reply.status, 303);
  const std::string cookie = reply.headers.back().second.substr(0, reply.headers.back().second.find(';'));
  const auto asked = [&](const std::string& origin) {
    return on_loopback("GET", "/", {{"Cookie", cookie}, {"Origin", origin}});
  };
  EXPECT_EQ(read_only(local.admit(asked("http://localhost:8765"))), "");
  EXPECT_EQ(status_of(local.admit(asked("http://localhost:3000"))), 401);
  EXPECT_EQ(local.answer(asked("http://localhost:3000")).status, 401);
}

TEST_F(RouterTest, TheTokenHelpsNoForeignHostOrOrigin) {
  Router open = router(false);
  const std::pair<std::string, std::string> right = {"Authorization", std::string("Bearer ") + kSecret};
  const std::string cookie = log_in(open, request("POST", "/login"));
  for (const auto& credential : {right, {"Cookie", cookie}}) {
    const auto foreign = request("GET", "/bags/a.mcap", {credential, {"Origin", "https://evil.example"}});
    EXPECT_EQ(open.answer(foreign).status, 403);
    EXPECT_EQ(status_of(open.admit(request("GET", "/", {credential, {"Origin", "https://evil.example"}}))),
              403);
    auto rebound = request("GET", "/bags/a.mcap", {credential});
    rebound.headers[1].second = "evil.example:8765";
    EXPECT_EQ(open.answer(rebound).status, 403);
    EXPECT_EQ(status_of(open.admit(rebound)), 403);
  }
}

TEST_F(RouterTest, ReplayedCookiesAreRefused) {
  Router open = router(false);
  const std::string cookie = log_in(open, request("POST", "/login"));
  auto elsewhere = request("GET", "/", {{"Cookie", cookie}});
  elsewhere.address = "10.0.0.10";
  EXPECT_EQ(open.answer(elsewhere).status, 401);
  EXPECT_EQ(status_of(open.admit(elsewhere)), 401);

  auto late = request("GET", "/", {{"Cookie", cookie}});
  late.now = 1 + 12 * 3600;
  EXPECT_EQ(status_of(open.admit(late)), 401);

  auto other_page = request("POST", "/logout", {{"Cookie", cookie}, {"Origin", "http://localhost:3000"}});
  EXPECT_EQ(open.answer(other_page).status, 401);
  EXPECT_EQ(open.answer(request("GET", "/", {{"Cookie", cookie}})).status, 200);
  EXPECT_EQ(open.answer(request("POST", "/logout", {{"Cookie", cookie}, {"Origin", "http://10.0.0.5:8765"}}))
                .status,
            303);
  EXPECT_EQ(open.answer(request("GET", "/", {{"Cookie", cookie}})).status, 401);
  EXPECT_EQ(status_of(open.admit(request("GET", "/", {{"Cookie", cookie}}))), 401);

  Router restarted = router(false);
  EXPECT_EQ(restarted.answer(request("GET", "/", {{"Cookie", cookie}})).status, 401);
}

TEST_F(RouterTest, LoggingInIsForItsOwnPageAndForFewAttempts) {
  Router open = router(false);
  Request login = request("POST", "/login");
  login.body = std::string("token=") + kSecret;
  EXPECT_EQ(open.answer(login).status, 403);  // no page at all
  login.headers.emplace_back("Origin", "http://localhost:3000");
  EXPECT_EQ(open.answer(login).status, 403);
  login.headers.back().second = "http://10.0.0.5:8765";
  login.body = "token=wrong";
  for (int i = 0; i < 5; ++i) EXPECT_EQ(open.answer(login).status, 401);
  login.body = std::string("token=") + kSecret;
  EXPECT_EQ(open.answer(login).status, 429);  // the right one as well
  EXPECT_EQ(status_of(open.admit(request("GET", "/", {{"Authorization", std::string("Bearer ") + kSecret}}))),
            429);
  login.address = "10.0.0.11";
  EXPECT_EQ(open.answer(login).status, 303);
  login.address = "10.0.0.9";
  login.now = 62;
  EXPECT_EQ(open.answer(login).status, 303);
}

TEST_F(RouterTest, ShowsAFormToABrowser) {
  const Reply reply = router(false).answer(request("GET", "/"));
  EXPECT_EQ(reply.status, 401);
  EXPECT_THAT(std::get<std::string>(reply.body),
              ::testing::HasSubstr("<form method=\"post\" action=\"/login\">"));
}

TEST_F(RouterTest, ATokenInAUrlIsRefusedEvenIfItIsRight) {
  Router open = router(false);
  const std::string target = std::string("/?token=") + kSecret;
  const std::pair<std::string, std::string> right = {"Authorization", std::string("Bearer ") + kSecret};
  EXPECT_EQ(open.answer(request("GET", target, {right})).status, 400);
  EXPECT_EQ(status_of(open.admit(request("GET", target, {right}))), 400);
}

TEST_F(RouterTest, OnLoopbackReadingNeedsNoToken) {
  Router local = router(true);
  auto asked = on_loopback("GET", "/bags/a.mcap");
  EXPECT_EQ(local.answer(asked).status, 200);
  asked.method = "POST";
  asked.target = "/login";
  EXPECT_EQ(local.answer(asked).status, 404);
}

TEST_F(RouterTest, ATokenFileThatIsNoneEndsTheStart) {
  std::ofstream(folder_ / "token") << kToken;
  EXPECT_THROW(router(false), std::runtime_error);
}

}  // namespace
}  // namespace bw::web
