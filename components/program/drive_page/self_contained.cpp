#include "components/program/drive_page/self_contained.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include <openssl/evp.h>

#include "runtime/remote/web/content_coding.hpp"

namespace bw {
namespace {

[[noreturn]] void refuse(std::string_view file, const std::string& what) {
  throw std::runtime_error("page file " + std::string(file) + ": " + what);
}

std::string text_of(const web::SiteFile& file) {
  try {
    return web::inflated(file.gzip);
  } catch (const std::runtime_error&) {
    refuse(file.path, "is not what gzip makes");
  }
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kPart = std::size_t{3} << 20;  // whole groups of three: no padding in between
  std::string text;
  text.reserve(4 * (bytes.size() / 3 + 1));
  std::string part(4 * (kPart / 3) + 1, '\0');
  for (std::size_t at = 0; at < bytes.size(); at += kPart) {
    const std::size_t size = std::min(kPart, bytes.size() - at);
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(part.data()), bytes.data() + at,
                                       static_cast<int>(size));
    text.append(part, 0, static_cast<std::size_t>(length));
  }
  return text;
}

/// As a Content-Security-Policy names a script or style that stands in the page.
std::string hash_source(std::string_view text) {
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL offers no SHA-256");
  return "'sha256-" + base64({digest.data(), length}) + "'";
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// A script may hold these in its own texts; in HTML they would end or hide it.
std::string script_text(std::string script) {
  replace_all(script, "</script", "<\\/script");
  replace_all(script, "<!--", "<\\!--");
  return script;
}

std::string attribute_text(std::string text) {
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, "\"", "&quot;");
  return text;
}

/// Puts `text` in the place of the element that names `path`.
void put_in(std::string& html, std::string_view path, const std::string& text) {
  const std::size_t named = html.find("=\"" + std::string(path) + "\"");
  if (named == std::string::npos) refuse(path, "the page does not name it");
  const std::size_t begin = html.rfind('<', named);
  std::size_t end = html.find('>', named);
  constexpr std::string_view kScript = "<script";
  constexpr std::string_view kScriptEnd = "</script>";
  if (std::string_view(html).substr(begin).starts_with(kScript)) {
    end = html.find(kScriptEnd, named);
    if (end != std::string::npos) end += kScriptEnd.size() - 1;
  }
  if (begin == std::string::npos || end == std::string::npos) refuse(path, "its element is cut");
  html.replace(begin, end + 1 - begin, text);
}

void insert_at(std::string& html, std::string_view mark, bool is_behind, const std::string& text) {
  const std::size_t at = html.find(mark);
  if (at == std::string::npos) refuse("/", "has no " + std::string(mark));
  html.insert(is_behind ? at + mark.size() : at, text);
}

/// The page without what it shows, which stands in the element `content`.
std::string with_content(std::span<const web::SiteFile> site, const std::string& content) {
  const auto index = std::ranges::find_if(site, [](const web::SiteFile& file) { return file.path == "/"; });
  if (index == site.end()) refuse("/", "is missing");
  std::string html = text_of(*index);
  std::string scripts = "script-src";
  std::string styles = "style-src";
  for (const web::SiteFile& file : site) {
    if (file.path == "/") continue;
    if (file.content_type.starts_with("text/javascript")) {
      const std::string script = script_text(text_of(file));
      scripts += " " + hash_source(script);
      put_in(html, file.path, "<script type=\"module\">" + script + "</script>");
    } else if (file.content_type.starts_with("text/css")) {
      const std::string style = text_of(file);
      styles += " " + hash_source(style);
      put_in(html, file.path, "<style>" + style + "</style>");
    } else if (file.content_type.starts_with("image/svg+xml")) {
      const std::string picture = text_of(file);
      const std::span bytes(reinterpret_cast<const std::uint8_t*>(picture.data()), picture.size());
      put_in(html, file.path, "<link rel=\"icon\" href=\"data:image/svg+xml;base64," + base64(bytes) + "\">");
    } else {
      refuse(file.path, "no page of one file can hold " + std::string(file.content_type));
    }
  }
  insert_at(html, "<meta charset=\"utf-8\" />", true,
            "\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; " + scripts + "; " +
                styles + "; img-src data: blob:; base-uri 'none'; form-action 'none'\" />");
  insert_at(html, "</body>", false, content + "</script>\n");
  return html;
}

}  // namespace

std::string self_contained_page(std::span<const web::SiteFile> site, const std::string& name,
                                bag::BytesView bag) {
  return with_content(site, "<script type=\"application/octet-stream\" id=\"bag\" data-name=\"" +
                                attribute_text(name) + "\">" + base64(bag));
}

std::string self_contained_report(std::span<const web::SiteFile> site, std::string json) {
  replace_all(json, "<", "\\u003c");  // no text of it ends the element
  return with_content(site, "<script type=\"application/json\" id=\"report\">" + json);
}

}  // namespace bw
