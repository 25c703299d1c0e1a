// A server with a token, over its sockets.
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/folder.hpp"
#include "tests/runtime/remote/web/raw_client.hpp"
#include "tests/runtime/remote/web/recording_handler.hpp"

namespace bw::test {
namespace {

constexpr const char* kSecret = "correct-horse-battery";

TEST(Login, GivesACookieThatOpensPageAndSocket) {
  Folder folder;
  std::ofstream(folder / "token") << kSecret << '\n';
  chmod((folder / "token").c_str(), 0600);
  RunningServer run({.token_file = folder / "token"});
  const auto port = run.server.port();
  const auto form = ask(port, "GET", "/");
  EXPECT_EQ(form.status, 401);
  EXPECT_EQ(form.headers.at("content-security-policy"),
            "default-src 'none'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'");

  RawClient refused(port);
  refused.send(handshake_text());
  EXPECT_EQ(refused.receive().status, 401);

  const std::string own = "Origin: http://127.0.0.1\r\nContent-Type: application/x-www-form-urlencoded\r\n";
  EXPECT_EQ(ask(port, "POST", "/login", own, "token=wrong").status, 401);
  const auto let_in = ask(port, "POST", "/login", own, std::string("token=") + kSecret);
  EXPECT_EQ(let_in.status, 303);
  EXPECT_EQ(let_in.headers.at("location"), "/");
  const std::string cookie = let_in.headers.at("set-cookie");
  EXPECT_TRUE(cookie.starts_with("bandwagon_" + std::to_string(port) + '='));

  const std::string line = "Cookie: " + cookie.substr(0, cookie.find(';')) + "\r\n";
  EXPECT_EQ(ask(port, "GET", "/", line).status, 200);
  RawClient page(port);
  page.send(handshake_text(line + "Origin: http://127.0.0.1\r\n"));
  EXPECT_EQ(page.receive().status, 101);
  RawClient program(port);
  program.send(handshake_text(std::string("Authorization: Bearer ") + kSecret + "\r\n"));
  EXPECT_EQ(program.receive().status, 101);
  EXPECT_THAT(run.log_text(), ::testing::Not(::testing::HasSubstr(kSecret)));
}

}  // namespace
}  // namespace bw::test
