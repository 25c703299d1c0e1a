#include <iostream>

#include "runtime/cli/verb.hpp"
#include "runtime/registry.hpp"

namespace bw::cli {
namespace {

CLI::App* add_list(CLI::App& app, int&) {
  return app.add_subcommand("list", "Component types this program knows")->callback([] {
    for (const std::string& name : registered_components()) std::cout << name << "\n";
  });
}

}  // namespace

BW_VERB(look, "list", add_list)

}  // namespace bw::cli
