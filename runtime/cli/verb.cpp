#include "runtime/cli/verb.hpp"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace bw::cli {
namespace {

constexpr const char* kHeadings[] = {"Drive", "Look", "Measure"};

using Verbs = std::map<std::pair<VerbGroup, std::string_view>, AddVerb>;

Verbs& verbs() {
  static Verbs all;
  return all;
}

}  // namespace

bool register_verb(VerbGroup group, std::string_view name, AddVerb add) {
  if (!verbs().emplace(std::pair(group, name), add).second) {
    throw std::logic_error("two verbs call themselves " + std::string(name));
  }
  return true;
}

void add_verbs(CLI::App& app, int& status) {
  for (const auto& [key, add] : verbs()) {
    add(app, status)->group(kHeadings[static_cast<int>(key.first)]);
  }
}

}  // namespace bw::cli
