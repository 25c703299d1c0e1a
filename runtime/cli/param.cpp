#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "runtime/cli/verb.hpp"
#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

struct ParamOptions {
  std::string path;
  std::string component;
  std::vector<std::string> set;
};

/// Empty text is shown as such, so that the line does not end in nothing.
std::string shown(const std::string& yaml) { return yaml.empty() ? "''" : yaml; }

/// The default, and what the graph sets instead.
std::string value_text(const ParameterRow& row) {
  if (row.default_value.empty()) return "= " + shown(row.value);  // of a list element the graph adds
  if (row.value == row.default_value) return "default " + shown(row.value);
  return "default " + shown(row.default_value) + ", here " + shown(row.value);
}

std::string range_text(const ParameterRow& row) {
  if (!row.choices.empty()) return fmt::format("one of {}", fmt::join(row.choices, ", "));
  const bool low = std::isfinite(row.min);
  const bool high = std::isfinite(row.max);
  if (low && high) return fmt::format("{} to {}", row.min, row.max);
  if (low) return fmt::format("at least {}", row.min);
  if (high) return fmt::format("at most {}", row.max);
  return "any";
}

template <class Print>
void for_each_component(const ParamOptions& options, Print print) {
  const Host host(load_graph(options.path, options.set), {});
  bool found = false;
  for (const auto& [name, report] : host.parameters()) {
    if (!options.component.empty() && name != options.component) continue;
    found = true;
    print(name, report);
  }
  if (!found) throw std::runtime_error("the graph has no component \"" + options.component + "\"");
}

CLI::App* add_param(CLI::App& app, int&) {
  auto options = std::make_shared<ParamOptions>();
  CLI::App* param = app.add_subcommand("param", "Parameters of a graph's components")->require_subcommand(1);
  const auto common = [&](CLI::App* verb) {
    verb->add_option("GRAPH", options->path, "Graph file")->required();
    verb->add_option("COMPONENT", options->component, "Only this component");
    verb->add_option("--set", options->set, "component.param=value")->allow_extra_args(false);
  };
  CLI::App* list =
      param->add_subcommand("list", "Names, types, ranges, defaults, values set by the graph, and meaning");
  common(list);
  list->callback([options] {
    for_each_component(*options, [](const std::string& name, const ParameterReport& report) {
      std::cout << name << ":\n";
      for (const ParameterRow& row : report.rows) {
        std::cout << fmt::format("  {} ({}{}{}; {}; {}): {}\n", row.name, row.type,
                                 row.unit.empty() ? "" : ", ", row.unit, range_text(row), value_text(row),
                                 row.doc);
      }
    });
  });
  CLI::App* dump =
      param->add_subcommand("dump", "Values in use, as YAML for the graph's parameters: sections");
  common(dump);
  dump->callback([options] {
    for_each_component(*options, [](const std::string& name, const ParameterReport& report) {
      std::cout << name << ":\n";
      std::istringstream lines(report.yaml);
      for (std::string line; std::getline(lines, line);) std::cout << "  " << line << "\n";
    });
  });
  return param;
}

}  // namespace

BW_VERB(look, "param", add_param)

}  // namespace bw::cli
