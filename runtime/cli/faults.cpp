// bandwagon faults [GRAPH]: what may go wrong on purpose; with a graph, what does in it.
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/cli/verb.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/injected_fault.hpp"

namespace bw::cli {
namespace {

struct FaultsOptions {
  std::string path;
  std::vector<std::string> set;
};

std::string subject(const FaultDescription& kind) {
  if (kind.is_of_a_process) return "a component or process, under launch";
  if (kind.is_of_component) return "a component or process";
  std::vector<std::string> topics = kind.topics;
  for (std::string& topic : topics) topic = topic.empty() ? "any topic" : topic;
  return fmt::format("{}", fmt::join(topics, ", "));
}

void show_kinds() {
  for (const FaultKind& kind : registered_faults()) {
    const FaultDescription description = describe(kind);
    std::cout << fmt::format("{:18} {}; of {}\n", kind.name, kind.doc, subject(description));
    for (const ParameterRow& row : description.parameters.rows)
      std::cout << fmt::format("{:18}   {} = {}{}{}: {}\n", "", row.name, row.default_value,
                               row.unit.empty() ? "" : " ", row.unit, row.doc);
  }
}

void show_faults(const FaultsOptions& options) {
  const Host host(load_graph(options.path, options.set), {});
  for (const auto& [name, text] : host.faults()) std::cout << fmt::format("{:18} {}\n", name, text);
}

void add_faults(Verb verb) {
  auto options = std::make_shared<FaultsOptions>();
  verb.option("GRAPH", options->path, "Graph file, or the name of one: what goes wrong in it");
  verb.option("--set", options->set, "component.param=value, or faults=FILE").one_each_time();
  verb.run([options] { options->path.empty() ? show_kinds() : show_faults(*options); });
}

}  // namespace

BW_VERB(look, "faults", "What can go wrong on purpose: kinds of `faults:` in a graph", add_faults)

}  // namespace bw::cli
