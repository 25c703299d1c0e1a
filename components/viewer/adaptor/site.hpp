// The page, as the build put it into the program.
#pragma once

#include <span>

#include "runtime/remote/web/site_file.hpp"

namespace bw::viewer {

/// Empty where the program was built without Node.js: then there is no page, and everything else is as it is.
std::span<const web::SiteFile> page_files();

/// The page that draws reports: of the programs that make them. Empty likewise.
std::span<const web::SiteFile> report_files();

}  // namespace bw::viewer
