#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "runtime/cli/emulate_option.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/dot.hpp"
#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

struct GraphOptions {
  std::string path;
  std::vector<std::string> set;
  bool emulate = false;
  bool dot = false;
  bool processes = false;
};

void show(const GraphOptions& options) {
  const Host host(load_graph(options.path, with_emulation(options.set, options.emulate)), {});
  if (options.dot) {
    std::cout << to_dot(host.declarations(), host.graph());
    return;
  }
  if (options.processes) {
    for (const std::string& process : host.graph().processes()) std::cout << process << "\n";
    return;
  }
  for (const ComponentDeclaration& declaration : host.declarations()) {
    const ComponentNode& node = *host.graph().find(declaration.name);
    std::cout << fmt::format("{} ({}, process {}, lane {})\n", node.name, node.type, node.process, node.lane);
    for (const auto& input : declaration.inputs)
      std::cout << fmt::format("  in  {} [{}]\n", node.topic_of(input.name), input.type);
    for (const auto& output : declaration.outputs) {
      std::cout << fmt::format("  out {} [{}]\n", node.topic_of(output.name), output.type);
    }
  }
}

void add_graph(Verb graph) {
  auto options = std::make_shared<GraphOptions>();
  graph.option("GRAPH", options->path, "Graph file").required();
  graph.option("--set", options->set, "component.param=value").one_each_time();
  graph.flag("--emulate", options->emulate, kEmulateHelp);
  graph.flag("--dot", options->dot, "As a Graphviz picture");
  graph.flag("--processes", options->processes, "Only the names of its processes");
  graph.run([options] { show(*options); });
}

}  // namespace

BW_VERB(look, "graph", "Checks a graph file and shows its components and topics", add_graph)

}  // namespace bw::cli
