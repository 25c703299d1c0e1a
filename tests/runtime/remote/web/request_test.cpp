// What of a request is taken apart: target, form, range, codings.
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/remote/web/byte_range.hpp"
#include "runtime/remote/web/content_coding.hpp"
#include "runtime/remote/web/request_target.hpp"

namespace bw::web {
namespace {

TEST(RequestTarget, IsTakenApart) {
  const auto parsed = parse_target("/bags/my%20run/run_0.mcap?x=%2e&y");
  ASSERT_TRUE(std::holds_alternative<RequestTarget>(parsed));
  const auto& target = std::get<RequestTarget>(parsed);
  EXPECT_EQ(target.path, "/bags/my run/run_0.mcap");
  EXPECT_EQ(target.segments, (std::vector<std::string>{"bags", "my run", "run_0.mcap"}));
  EXPECT_FALSE(target.token);
  EXPECT_EQ(std::get<RequestTarget>(parse_target("/?a=1&tok%65n=%78=y&token=z")).token, "x=y");
  for (const std::string_view empty : {"/?token", "/?token=", "/?token=%", "/?token=&token=x"})
    EXPECT_EQ(std::get<RequestTarget>(parse_target(empty)).token, "") << empty;
  EXPECT_EQ(std::get<RequestTarget>(parse_target("/bags/")).segments, (std::vector<std::string>{"bags", ""}));
}

TEST(RequestTarget, RefusesWhatLeadsElsewhere) {
  for (const std::string_view target :
       {"",          "*",     "bags",   "http://x/", "/..",   "/bags/..", "/bags/../a", "/./a",
        "/%2e%2E/a", "/.%2e", "/a%2fb", "/a%5cb",    "/a\\b", "//a",      "/a//b",      "/%",
        "/%1",       "/%g0",  "/%00",   "/%0a",      "/\x7f", "/a\nb"}) {
    EXPECT_TRUE(std::holds_alternative<std::string>(parse_target(target))) << target;
  }
  // Decoded once: what is left is a name and no way up.
  EXPECT_EQ(std::get<RequestTarget>(parse_target("/%252e%252e")).path, "/%2e%2e");
}

TEST(RequestTarget, IsLoggedWithoutQueryAndControlCharacters) {
  EXPECT_EQ(printable_path("/a\n\x1b[31m?token=secret"), "/a??[31m");
  EXPECT_EQ(printable_path(std::string(500, 'a')).size(), 100U);
}

TEST(FormField, IsDecoded) {
  EXPECT_EQ(form_field("a=1&token=x%2B+y&token=z", "token"), "x+ y");
  EXPECT_EQ(form_field("token", "token"), "");
  EXPECT_EQ(form_field("token=%", "token"), "");
  EXPECT_EQ(form_field("xtoken=a", "token"), "");
}

void expect_part(std::string_view header, std::uint64_t begin, std::uint64_t end) {
  const ByteRange range = parse_range(header, 10);
  EXPECT_EQ(range.kind, ByteRange::Kind::part) << header;
  EXPECT_EQ(range.begin, begin) << header;
  EXPECT_EQ(range.end, end) << header;
}

TEST(ByteRange, IsReadAsTheRfcSays) {
  expect_part("bytes=0-0", 0, 1);
  expect_part("bytes=2-5", 2, 6);
  expect_part("bytes=9-", 9, 10);
  expect_part("bytes=5-99", 5, 10);
  expect_part("bytes=5-99999999999999999999999", 5, 10);
  expect_part("bytes=-4", 6, 10);
  expect_part("bytes=-40", 0, 10);
  for (const auto* header : {"bytes=10-", "bytes=10-11", "bytes=99999999999999999999-", "bytes=-0"}) {
    EXPECT_EQ(parse_range(header, 10).kind, ByteRange::Kind::unsatisfiable) << header;
  }
  for (const auto* header : {"", "bytes", "bytes=", "bytes=-", "bytes=a-b", "bytes=5-2", "bytes=0-1,3-4",
                             "items=0-1", "bytes=--1", "bytes=+1-2"}) {
    EXPECT_EQ(parse_range(header, 10).kind, ByteRange::Kind::whole) << header;
  }
  EXPECT_EQ(parse_range("bytes=0-", 0).kind, ByteRange::Kind::unsatisfiable);
  EXPECT_EQ(parse_range("bytes=-1", 0).kind, ByteRange::Kind::unsatisfiable);
}

TEST(ContentCoding, GzipIsForThoseWhoTakeIt) {
  for (const auto* header : {"gzip", "br, gzip", "gzip;q=0.5", "*", "deflate , gzip;q=1.0"})
    EXPECT_TRUE(accepts_gzip(header)) << header;
  for (const auto* header : {"", "br", "gzip;q=0", "gzip; q=0.000", "identity", "xgzip"})
    EXPECT_FALSE(accepts_gzip(header)) << header;
}

}  // namespace
}  // namespace bw::web
