// What the command line says of the page.
#pragma once

#include <string>
#include <vector>

#include "runtime/cli/verb.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {

struct PageOptions {
  static constexpr const char* kAsGiven = "as the graph says";  ///< what --page stands for alone

  std::string page;  ///< empty: as the graph says; else a port, or kAsGiven
  std::string bags;
  std::string listen;
  std::string token_file;
  std::vector<std::string> allow_origins;
  bool allow_commands = false;

  /// --page and where it listens.
  void add_to(cli::Verb verb);
  /// Enables the viewer of the graph, or adds one, and puts what was given over its parameters. Does nothing
  /// where nothing was given. Throws std::runtime_error naming option, value and rule.
  void apply_to(Graph& graph) const;
};

}  // namespace bw
