#include <string>

#include <fmt/format.h>

#include "components/viewer/adaptor/help/help_pages.hpp"

namespace bw::viewer {
namespace {

/// Of what is served, as long as the program runs.
struct Names {
  std::string path, etag;
};

/// gzip ends in the text's checksum and size.
std::string etag_of(std::span<const std::uint8_t> gzip) {
  return fmt::format("\"{:02x}\"", fmt::join(gzip.last(8), ""));
}

std::vector<Names> all_names() {
  std::vector<Names> names;
  for (const HelpPage& page : help_pages())
    names.push_back({fmt::format("/help/{}", page.topic), etag_of(page.gzip)});
  return names;
}

}  // namespace

std::vector<web::SiteFile> help_site() {
  static const std::vector<Names> kNames = all_names();
  std::vector<web::SiteFile> files;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    files.push_back(
        {kNames[i].path, "text/markdown; charset=utf-8", help_pages()[i].gzip, kNames[i].etag});
  return files;
}

}  // namespace bw::viewer
