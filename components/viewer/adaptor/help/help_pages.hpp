// The project's own pages, as they were when the program was built: for `bandwagon help` and the page's "?".
// Which they are: docs/help.txt.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/remote/web/site_file.hpp"

namespace bw::viewer {

struct HelpPage {
  std::string_view group;  ///< heading that it stands under
  std::string_view topic;  ///< ekf, ekf/theory
  std::string_view file;   ///< below the project's root, by which pages refer to one another
  std::string_view tells;
  std::span<const std::uint8_t> gzip;  ///< Markdown, compressed
};

/// `list`, which is docs/help.txt itself, then its pages in their order.
std::span<const HelpPage> help_pages();

/// Each as /help/<topic>.
std::vector<web::SiteFile> help_site();

}  // namespace bw::viewer
