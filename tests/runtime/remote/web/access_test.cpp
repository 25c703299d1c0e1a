#include "runtime/remote/web/access.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bw::web {
namespace {

const AccessRules kLocal = {.is_loopback = true, .allow_origins = {"https://app.foxglove.dev"}};
const AccessRules kOpen = {
    .is_loopback = false, .host_names = {"robot.local"}, .allow_origins = {"https://app.foxglove.dev"}};

bool lets_host(const AccessRules& rules, std::optional<std::string_view> host) {
  return !refused_host(rules, {.host = host});
}

TEST(Access, OnLoopbackTheHostIsThisMachine) {
  for (const auto* host :
       {"127.0.0.1", "127.0.0.1:8765", "localhost", "LocalHost:1", "[::1]", "[::1]:8765", "127.1.2.3:80"}) {
    EXPECT_TRUE(lets_host(kLocal, host)) << host;
  }
  for (const auto* host : {"",
                           "evil.example",
                           "evil.example:8765",
                           "10.0.0.5",
                           "128.0.0.1",
                           "127.0.0.1.evil.example",
                           "localhost.evil.example",
                           "localhost.",
                           "robot.local",
                           "[::2]",
                           "[::1",
                           "::1",
                           "127.0.0.1:",
                           "127.0.0.1:x",
                           "127.0.0.1:123456",
                           "a@127.0.0.1",
                           "127.0.0.1/",
                           "127.1",
                           "0x7f.0.0.1",
                           "2130706433",
                           "127.0.0.1 ",
                           "0.0.0.0"}) {
    EXPECT_FALSE(lets_host(kLocal, host)) << host;
  }
  EXPECT_FALSE(lets_host(kLocal, std::nullopt));
}

// A name can be made to mean any address (DNS rebinding); an address cannot.
TEST(Access, OpenItTheHostIsAnAddressOrANameThatWasGiven) {
  for (const auto* host :
       {"10.0.0.5:8765", "[fe80::1]:8765", "robot.local", "ROBOT.local:8765", "localhost:8765"}) {
    EXPECT_TRUE(lets_host(kOpen, host)) << host;
  }
  for (const auto* host : {"evil.example", "robot", "robot.local.evil.example", "10.0.0", ""}) {
    EXPECT_FALSE(lets_host(kOpen, host)) << host;
  }
}

TEST(Access, OriginsThatAreHeard) {
  for (const AccessRules& rules : {kLocal, kOpen}) {
    const auto lets = [&](std::optional<std::string_view> origin, std::string_view host) {
      return !refused_origin(rules, {.host = host, .origin = origin});
    };
    EXPECT_TRUE(lets(std::nullopt, "10.0.0.5:8765"));             // a program
    EXPECT_TRUE(lets("http://10.0.0.5:8765", "10.0.0.5:8765"));   // its own page
    EXPECT_TRUE(lets("https://10.0.0.5:8765", "10.0.0.5:8765"));  // behind a proxy that speaks TLS
    for (const auto* origin : {"http://127.0.0.1:8080", "http://localhost:5173", "http://localhost",
                               "http://[::1]:3000", "https://localhost:8080", "https://app.foxglove.dev"}) {
      EXPECT_TRUE(lets(origin, "127.0.0.1:8765")) << origin;
    }
    for (const auto* origin :
         {"", "null", "http://evil.example", "https://app.foxglove.dev:444", "http://app.foxglove.dev",
          "https://app.foxglove.dev.evil.example", "https://xapp.foxglove.dev", "HTTPS://APP.FOXGLOVE.DEV",
          "http://localhost.evil.example", "http://127.0.0.1.evil.example", "http://10.0.0.6:8765",
          "http://localhost@evil.example", "http://localhost:80@evil.example", "file://", "ftp://localhost",
          "http://127.0.0.1:8765 http://evil.example", "http://evil.example/localhost"}) {
      EXPECT_FALSE(lets(origin, "127.0.0.1:8765")) << origin;
    }
  }
}

TEST(Access, ABrowserThatFetchesForAPageOfElsewhereIsRefusedWithoutAnOriginToo) {
  Caller picture{.host = "localhost", .fetch_site = "cross-site", .fetch_mode = "no-cors"};
  EXPECT_TRUE(refused_origin(kLocal, picture));
  Caller link{.host = "localhost", .fetch_site = "cross-site", .fetch_mode = "navigate"};
  EXPECT_FALSE(refused_origin(kLocal, link));
  Caller own{.host = "localhost", .fetch_site = "same-origin", .fetch_mode = "cors"};
  EXPECT_FALSE(refused_origin(kLocal, own));
}

}  // namespace
}  // namespace bw::web
