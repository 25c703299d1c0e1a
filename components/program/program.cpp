#include "components/program/program.hpp"

#include <iostream>
#include <string>

#include <fmt/format.h>

#include "components/program/drive.hpp"
#include "components/program/drive_page/drive_page.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/cli/page_writer.hpp"
#include "runtime/cli/verb.hpp"

namespace {

std::string version() {
  std::size_t bytes = 0;
  for (const bw::web::SiteFile& file : bw::viewer::page_files()) bytes += file.gzip.size();
  return bytes == 0 ? BANDWAGON_VERSION " without page"
                    : fmt::format(BANDWAGON_VERSION " with page, {} kB compressed", (bytes + 999) / 1000);
}

}  // namespace

namespace bw {

int run_program(const std::string& name, const std::string& help, int argc, char** argv) {
  cli::set_page_writer({.require = require_page, .write = write_drive_page});
  try {
    return cli::run_verb(name, help, version, argc, argv);
  } catch (const RunFailed& error) {
    std::cerr << error.what() << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace bw
