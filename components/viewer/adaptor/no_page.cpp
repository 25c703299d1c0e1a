// Of a program without the page.
#include "components/viewer/adaptor/site.hpp"

namespace bw::viewer {

std::span<const web::SiteFile> page_files() { return {}; }

}  // namespace bw::viewer
