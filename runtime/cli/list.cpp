#include <iostream>

#include "runtime/cli/verb.hpp"
#include "runtime/registry.hpp"

namespace bw::cli {
namespace {

void add_list(Verb verb) {
  verb.run([] {
    for (const std::string& name : registered_components()) std::cout << name << "\n";
  });
}

}  // namespace

BW_VERB(look, "list", "Component types this program knows", add_list)

}  // namespace bw::cli
