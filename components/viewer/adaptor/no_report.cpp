// Of a program without the page of reports.
#include "components/viewer/adaptor/site.hpp"

namespace bw::viewer {

std::span<const web::SiteFile> report_files() { return {}; }

}  // namespace bw::viewer
