#include <iostream>
#include <set>

#include <CLI/App.hpp>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::cli {
namespace {

CLI::App* add_node(CLI::App& app, int&) {
  CLI::App* node = app.add_subcommand("node", "Nodes on the wire")->require_subcommand(1);
  node->add_subcommand("list", "Full names of all nodes")->callback([] {
    Outside outside;
    outside.settle();
    std::multiset<std::string> names;
    for (const ParticipantEntities& participant : outside.nodes()) {
      for (const NodeEntities& entities : participant.nodes) {
        names.insert(full_name(entities));
      }
    }
    for (const std::string& name : names) std::cout << name << "\n";
  });
  return node;
}

}  // namespace

BW_VERB(look, "node", add_node)

}  // namespace bw::cli
