// The program `bandwagon`: every verb in one place.
#include <iostream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "components/program/bench.hpp"
#include "components/program/evaluate.hpp"
#include "components/program/reproduce.hpp"
#include "components/program/run.hpp"
#include "runtime/cli/verbs.hpp"

int main(int argc, char** argv) {
  CLI::App app("Drives wheeled robots among people", "bandwagon");
  app.require_subcommand(1);
  app.set_version_flag("--version", BANDWAGON_VERSION);
  int status = 0;
  bw::add_run(app, status);
  bw::add_bench(app, status);
  bw::add_evaluate(app, status);
  bw::add_reproduce(app, status);
  bw::cli::add_list(app, status);
  bw::cli::add_graph(app, status);
  bw::cli::add_param(app, status);
  bw::cli::add_topic(app, status);
  bw::cli::add_node(app, status);
  bw::cli::add_doctor(app, status);
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
