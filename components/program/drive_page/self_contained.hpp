// A page and what it shows, a bag or a report, as one HTML text that needs nothing else: no server, no
// network.
#pragma once

#include <span>
#include <string>

#include "runtime/recording/bag/bytes.hpp"
#include "runtime/remote/web/site_file.hpp"

namespace bw {

/// Scripts and styles of `site` stand in the text, and its Content-Security-Policy names them by their
/// hashes: nothing else runs, nothing is loaded. `name` is shown as that of the bag. Throws
/// std::runtime_error naming the file of the site that is not as expected.
std::string self_contained_page(std::span<const web::SiteFile> site, const std::string& name,
                                bag::BytesView bag);

/// The same of the page that draws reports (components/lab/report) and one of them.
std::string self_contained_report(std::span<const web::SiteFile> site, std::string json);

}  // namespace bw
