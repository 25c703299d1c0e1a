// The program `bandwagon`: every verb that is linked into it.
#include <iostream>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "components/tools/drive_page/drive_page.hpp"
#include "components/tools/program/drive.hpp"
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

int main(int argc, char** argv) {
  CLI::App app("Drives wheeled robots among people", "bandwagon");
  app.require_subcommand(1);
  app.set_version_flag("--version", version);
  int status = 0;
  bw::cli::set_page_writer({.require = bw::require_page, .write = bw::write_drive_page});
  bw::cli::add_verbs(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const bw::RunFailed& error) {
    std::cerr << error.what() << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return status;
}
