#include "runtime/remote/web/token.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "runtime/remote/web/rate.hpp"
#include "tests/folder.hpp"

namespace bw::web {
namespace {

constexpr std::string_view kToken = "0123456789abcdef";

std::filesystem::path token_file(const test::Folder& folder, std::string_view text, unsigned mode) {
  const auto path = folder / "token";
  std::ofstream(path) << text;
  chmod(path.c_str(), mode);
  return path;
}

std::string complaint(const std::filesystem::path& path) {
  try {
    read_token_file(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(TokenFile, IsOneLineThatOnlyItsOwnerReads) {
  const test::Folder folder;
  EXPECT_EQ(read_token_file(token_file(folder, std::string(kToken) + '\n', 0600)), kToken);
  EXPECT_EQ(read_token_file(token_file(folder, kToken, 0400)), kToken);
}

TEST(TokenFile, IsRefusedWithItsRule) {
  using ::testing::HasSubstr;
  const test::Folder folder;
  EXPECT_THAT(complaint(token_file(folder, kToken, 0640)), HasSubstr("mode 640: others can use it"));
  EXPECT_THAT(complaint(token_file(folder, kToken, 0602)), HasSubstr("mode 602"));
  EXPECT_THAT(complaint(token_file(folder, "0123456789abcde\n", 0600)),
              HasSubstr("has 15 characters, 16 to"));
  EXPECT_THAT(complaint(token_file(folder, "", 0600)), HasSubstr("has 0 characters"));
  EXPECT_THAT(complaint(token_file(folder, std::string(5000, 'a'), 0600)),
              HasSubstr("16 to 1024 are needed"));
  EXPECT_THAT(complaint(token_file(folder, "0123456789 abcdef", 0600)), HasSubstr("without spaces"));
  EXPECT_THAT(complaint(token_file(folder, "0123456789abcdef\nsecond", 0600)), HasSubstr("one line"));
  EXPECT_THAT(complaint(folder / "none"), HasSubstr("cannot be read"));
  EXPECT_THAT(complaint(folder / ""), HasSubstr("regular file"));
}

TEST(Token, IsComparedWhole) {
  EXPECT_TRUE(is_equal_in_constant_time(kToken, kToken));
  for (const std::string_view given : {"", "0", "0123456789abcdeF", "0123456789abcdef0", "123456789abcdef",
                                       "0123456789abcdef0123456789abcdef"}) {
    EXPECT_FALSE(is_equal_in_constant_time(given, kToken)) << given;
  }
  EXPECT_FALSE(is_equal_in_constant_time("", ""));
}

TEST(Token, ComesAsBearerOrAsPassword) {
  EXPECT_EQ(token_of("Bearer abc"), "abc");
  EXPECT_EQ(token_of("Basic YW55OnNlY3JldA=="), "secret");  // any:secret
  EXPECT_EQ(token_of("Basic OnM6dA=="), "s:t");             // :s:t
  for (const auto* wrong :
       {"", "bearer", "Basic ", "Basic YW55", "Basic !!!!", "Basic YW55OnNlY3JldA", "Digest x"}) {
    EXPECT_FALSE(token_of(wrong)) << wrong;
  }
}

TEST(Sessions, CountFromTheirAddressForTwelveHours) {
  Sessions sessions;
  const std::string cookie = sessions.open("10.0.0.5", 100);
  EXPECT_EQ(cookie.size(), 32U);
  EXPECT_TRUE(sessions.holds(cookie, "10.0.0.5", 100 + 12 * 3600 - 1));
  EXPECT_FALSE(sessions.holds(cookie, "10.0.0.5", 100 + 12 * 3600));
  EXPECT_FALSE(sessions.holds(cookie, "10.0.0.6", 101));
  EXPECT_FALSE(sessions.holds(std::string(32, '0'), "10.0.0.5", 101));
  EXPECT_FALSE(sessions.holds("", "10.0.0.5", 101));
  sessions.close(cookie);
  EXPECT_FALSE(sessions.holds(cookie, "10.0.0.5", 101));
}

TEST(Sessions, AreNeverTheSameAndNeverMoreThan64) {
  Sessions sessions;
  const std::string first = sessions.open("a", 0);
  std::set<std::string> all = {first};
  for (int i = 0; i < 64; ++i) all.insert(sessions.open("a", 0));
  EXPECT_EQ(all.size(), 65U);
  EXPECT_FALSE(sessions.holds(first, "a", 0));
}

TEST(Attempts, AreCountedByAddressForAMinute) {
  Attempts attempts(3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(attempts.may_try("a", i));
    attempts.count_failure("a", i);
  }
  EXPECT_FALSE(attempts.may_try("a", 3));
  EXPECT_TRUE(attempts.may_try("b", 3));
  EXPECT_FALSE(attempts.may_try("a", 59.9));
  EXPECT_TRUE(attempts.may_try("a", 60));
}

TEST(Attempts, AreForgottenSoThatNobodyFillsTheMemory) {
  Attempts attempts(3);
  for (int i = 0; i < 1024; ++i) {
    ASSERT_TRUE(attempts.may_try(std::to_string(i), 0));
    attempts.count_failure(std::to_string(i), 0);
  }
  EXPECT_FALSE(attempts.may_try("one more", 1));
  EXPECT_TRUE(attempts.may_try("one more", 61));
}

TEST(Rate, AllowsABurstAndThenSoManyInASecond) {
  Rate rate(2, 4);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(rate.take(10));
  EXPECT_FALSE(rate.take(10.4));
  EXPECT_TRUE(rate.take(10.5));
  EXPECT_FALSE(rate.take(10.6));
}

}  // namespace
}  // namespace bw::web
