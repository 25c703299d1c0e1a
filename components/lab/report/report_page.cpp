#include "components/lab/report/report_page.hpp"

#include <stdexcept>

#include "components/program/drive_page/self_contained.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {

bool can_draw_reports() { return !viewer::report_files().empty(); }

void require_report_page(const std::string& option) {
  if (can_draw_reports()) return;
  throw std::runtime_error(option +
                           ": this program was built without the page; launch_scripts/setup.sh installs what "
                           "the build needs for it");
}

void write_report_page(const report::Document& document, const std::filesystem::path& html) {
  require_report_page(html.string());
  write_file_atomically(html, self_contained_report(viewer::report_files(), document.json().dump()));
}

}  // namespace bw
