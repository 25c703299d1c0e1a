#include "components/program/drive_page/drive_page.hpp"

#include <stdexcept>

#include "components/program/drive_page/self_contained.hpp"
#include "components/program/drive_page/shown_bag.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {

void require_page(const std::string& option) {
  if (viewer::page_files().empty())
    throw std::runtime_error(
        option +
        ": this program was built without the page; launch_scripts/setup.sh installs what "
        "the build needs for it");
}

void write_drive_page(const std::filesystem::path& bag, const std::string& name,
                      const std::filesystem::path& html) {
  require_page("--html " + html.string());
  const bag::Bytes shown = shown_bag(*bag::open_bag(bag));
  write_file_atomically(html, self_contained_page(viewer::page_files(), name, shown));
}

}  // namespace bw
