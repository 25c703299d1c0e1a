#include "components/program/program.hpp"

#include <iostream>
#include <string>

#include <fmt/format.h>

#include "components/program/drive.hpp"
#include "components/program/drive_page/drive_page.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/page_writer.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/dds/library.hpp"

namespace {

/// bandwagon 0.1.0 (commit 1234567890ab, Fast DDS 2.9.1, GCC 12.2.0, page of 263 kB)
std::string version(const std::string& name) {
  std::size_t bytes = 0;
  for (const bw::web::SiteFile& file : bw::viewer::page_files()) bytes += file.gzip.size();
  const std::string revision = bw::source_revision();
  return fmt::format("{} {} ({}, Fast DDS {}, {}, {})", name, bw::program_version(),
                     revision.empty() ? "no commit" : "commit " + revision.substr(0, 12),
                     bw::dds::to_string(bw::dds::library_version()), bw::compiler(),
                     bytes == 0 ? "without page" : fmt::format("page of {} kB", (bytes + 999) / 1000));
}

}  // namespace

namespace bw {

int run_program(const std::string& name, const std::string& help, int argc, char** argv) {
  cli::set_page_writer({.require = require_page, .write = write_drive_page});
  try {
    return cli::run_verb(
        name, help, [&name] { return version(name); }, argc, argv);
  } catch (const RunFailed& error) {
    std::cerr << error.what() << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace bw
