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

void print_rows(const std::string& name, const std::vector<ParameterRow>& rows) {
  if (!rows.empty()) std::cout << name << ":\n";
  for (const ParameterRow& row : rows) {
    std::cout << fmt::format("  {} ({}{}{}; {}; {}): {}\n", row.name, row.type, row.unit.empty() ? "" : ", ",
                             row.unit, range_text(row), value_text(row), row.doc);
  }
}

std::runtime_error no_component(const std::string& name) {
  return std::runtime_error("the graph has no component \"" + name + "\"");
}

}  // namespace

void list_graph(const GraphParameters& asked) {
  const Host host(load_graph(asked.path, asked.set), {});
  auto sections = host.parameters();
  for (auto& shared : host.shared_parameters()) sections.push_back(std::move(shared));
  const bool is_whole = asked.component.empty();
  bool found = is_whole;
  std::size_t left_out = 0;
  for (auto& [name, report] : sections) {
    if (!is_whole && name != asked.component) continue;
    found = true;
    if (is_whole && !asked.all)
      left_out += std::erase_if(report.rows, [](const ParameterRow& row) { return !row.first; });
    print_rows(name, report.rows);
  }
  if (!found) throw no_component(asked.component);
  if (left_out > 0)
    std::cout << fmt::format("and {} more: --all, or the name of a component behind the graph\n", left_out);
}

void dump_graph(const GraphParameters& asked) {
  const Host host(load_graph(asked.path, asked.set), {});
  bool found = asked.component.empty();
  for (const auto& [name, report] : host.parameters()) {
    if (!asked.component.empty() && name != asked.component) continue;
    found = true;
    std::cout << name << ":\n";
    std::istringstream lines(report.yaml);
    for (std::string line; std::getline(lines, line);) std::cout << "  " << line << "\n";
  }
  if (!found) throw no_component(asked.component);
}

}  // namespace bw::cli
