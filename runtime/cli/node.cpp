#include <iostream>
#include <set>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::cli {
namespace {

void add_node(Verb node) {
  node.verb("list", "Full names of all nodes").run([] {
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
}

}  // namespace

BW_VERB(look, "node", "Nodes on the wire", add_node)

}  // namespace bw::cli
