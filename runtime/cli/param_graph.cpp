#include "runtime/cli/param_graph.hpp"

#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

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
void for_each_component(const GraphParameters& asked, Print print) {
  const Host host(load_graph(asked.path, asked.set), {});
  bool found = false;
  for (const auto& [name, report] : host.parameters()) {
    if (!asked.component.empty() && name != asked.component) continue;
    found = true;
    print(name, report);
  }
  if (!found) throw std::runtime_error("the graph has no component \"" + asked.component + "\"");
}

}  // namespace

void list_graph(const GraphParameters& asked) {
  for_each_component(asked, [](const std::string& name, const ParameterReport& report) {
    std::cout << name << ":\n";
    for (const ParameterRow& row : report.rows) {
      std::cout << fmt::format("  {} ({}{}{}; {}; {}): {}\n", row.name, row.type,
                               row.unit.empty() ? "" : ", ", row.unit, range_text(row), value_text(row),
                               row.doc);
    }
  });
}

void dump_graph(const GraphParameters& asked) {
  for_each_component(asked, [](const std::string& name, const ParameterReport& report) {
    std::cout << name << ":\n";
    std::istringstream lines(report.yaml);
    for (std::string line; std::getline(lines, line);) std::cout << "  " << line << "\n";
  });
}

}  // namespace bw::cli
