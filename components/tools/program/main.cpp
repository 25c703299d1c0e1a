// The program `bandwagon`: every verb that is linked into it.
#include <iostream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "runtime/cli/verb.hpp"

int main(int argc, char** argv) {
  CLI::App app("Drives wheeled robots among people", "bandwagon");
  app.require_subcommand(1);
  app.set_version_flag("--version", BANDWAGON_VERSION);
  int status = 0;
  bw::cli::add_verbs(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return status;
}
