#include <fstream>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "runtime/cli/verb.hpp"
#include "runtime/graph/config_file.hpp"
#include "runtime/registry.hpp"

namespace bw::cli {
namespace {

void add_list(Verb verb) {
  verb.run([] {
    for (const std::string& name : registered_components()) std::cout << name << "\n";
  });
}

/// The first sentence of the comment that the file begins with.
std::string first_sentence(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string comment;
  for (std::string line; std::getline(file, line) && line.starts_with("# ");)
    comment += (comment.empty() ? "" : " ") + line.substr(2);
  return comment.substr(0, comment.find(". "));
}

void list_files(const std::string& kind) {
  for (const ConfigFile& file : config_files(kind))
    std::cout << fmt::format("{:16} {}\n{:16} {}\n", file.name, first_sentence(file.path), "",
                             file.path.string());
}

void add_graphs(Verb verb) {
  verb.run([] { list_files("graphs"); });
}

void add_robots(Verb verb) {
  verb.run([] { list_files("robots"); });
}

}  // namespace

BW_VERB(look, "list", "Component types this program knows", add_list)
BW_VERB(look, "graphs", "Graphs that go by a name: run NAME", add_graphs)
BW_VERB(look, "robots", "Robots that go by a name: --set robot=NAME", add_robots)

}  // namespace bw::cli
