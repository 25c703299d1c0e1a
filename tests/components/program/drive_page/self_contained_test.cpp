// A site and a bag as one text.
#include "components/program/drive_page/self_contained.hpp"

#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <zlib.h>

#include "tests/components/program/drive_page/page_parts.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::uint8_t> zipped(const std::string& text) {
  std::vector<std::uint8_t> out(text.size() + 128);
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

const std::string kIndex =
    "<html><head><meta charset=\"utf-8\" /><link rel=\"icon\" href=\"/icon.svg\" />"
    "<link rel=\"stylesheet\" href=\"/app.css\" /><script type=\"module\" src=\"/app.js\"></script></head>"
    "<body><main></main></body></html>";
const std::string kScript = "const a = \"</script>\", b = \"<!-- <script>\"; run(a, b);";
const std::string kStyle = "body { color: red }";

struct Site {
  std::vector<web::SiteFile> files;
  std::deque<std::vector<std::uint8_t>> bytes;

  void add(std::string_view path, std::string_view type, const std::string& text) {
    bytes.push_back(zipped(text));
    files.push_back({.path = path, .content_type = type, .gzip = bytes.back(), .etag = "\"\""});
  }
};

Site site(const std::string& index = kIndex) {
  Site made;
  made.add("/", "text/html; charset=utf-8", index);
  made.add("/app.js", "text/javascript; charset=utf-8", kScript);
  made.add("/app.css", "text/css; charset=utf-8", kStyle);
  made.add("/icon.svg", "image/svg+xml", "<svg/>");
  return made;
}

const std::vector<std::uint8_t> kBag = {0, 1, 2, 253, 254, 255, 7};

TEST(SelfContainedPage, HoldsScriptStyleAndBagAndNamesNothingElse) {
  const std::string page = self_contained_page(site().files, "hallway \"7\" <&>", kBag);
  for (const char* outside : {"src=", "href=\"/", "http:", "https:", "url("})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_THAT(page, HasSubstr("data-name=\"hallway &quot;7&quot; &lt;&amp;>\""));
  EXPECT_EQ(from_base64(between(page, "&amp;>\">", "</script>")), kBag);
  EXPECT_EQ(between(page, "<style>", "</style>"), kStyle);
  // One script and the bag; neither text of the script ends it.
  const std::string script = between(page, "<script type=\"module\">", "</script>");
  EXPECT_EQ(script, "const a = \"<\\/script>\", b = \"<\\!-- <script>\"; run(a, b);");
}

TEST(SelfContainedPage, LetsRunWhatItHoldsAndNothingElse) {
  const std::string page = self_contained_page(site().files, "drive", kBag);
  const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
  EXPECT_THAT(policy, HasSubstr("default-src 'none'; "));
  EXPECT_THAT(policy, Not(HasSubstr("unsafe")));
  EXPECT_THAT(policy, HasSubstr("script-src " +
                                hash_source(between(page, "<script type=\"module\">", "</script>")) + ";"));
  EXPECT_THAT(policy, HasSubstr("style-src " + hash_source(kStyle) + ";"));
  // It counts for what comes behind it.
  EXPECT_LT(page.find("Content-Security-Policy"), page.find("<script"));
}

// Base64 in parts of 3 MiB: 7 MB go over two borders.
TEST(SelfContainedPage, TakesLargeBags) {
  std::vector<std::uint8_t> bag(7'000'001);
  for (std::size_t i = 0; i < bag.size(); ++i) bag[i] = static_cast<std::uint8_t>(i * 31 % 251);
  const std::string page = self_contained_page(site().files, "drive", bag);
  EXPECT_EQ(from_base64(between(page, "data-name=\"drive\">", "</script>")), bag);
}

TEST(SelfContainedReport, NoTextOfTheReportEndsItsElement) {
  const std::string page = self_contained_report(site().files, R"({"title": "a </script><script>b"})");
  EXPECT_THAT(between(page, "<script type=\"application/json\" id=\"report\">", "</script>"),
              R"({"title": "a \u003c/script>\u003cscript>b"})");
  EXPECT_THAT(page, HasSubstr("script-src 'sha256-"));
}

std::string refusal(const Site& made) {
  try {
    self_contained_page(made.files, "drive", kBag);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SelfContainedPage, RefusesASiteThatIsNotAsExpected) {
  EXPECT_EQ(refusal({}), "page file /: is missing");
  EXPECT_EQ(refusal(site("<html></html>")), "page file /app.js: the page does not name it");
  Site torn = site();
  torn.files[1].gzip = torn.files[1].gzip.first(20);
  EXPECT_EQ(refusal(torn), "page file /app.js: is not what gzip makes");
  Site strange = site();
  strange.files[3].content_type = "font/woff2";
  EXPECT_EQ(refusal(strange), "page file /icon.svg: no page of one file can hold font/woff2");
}

}  // namespace
}  // namespace bw::test
