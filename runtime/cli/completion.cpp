#include "runtime/cli/completion.hpp"

#include <algorithm>
#include <utility>

#include "runtime/graph/config_file.hpp"
#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

std::vector<std::string> names_of(const std::string& kind) {
  std::vector<std::string> names;
  for (const ConfigFile& file : config_files(kind)) names.push_back(file.name);
  return names;
}

/// Of the graph that is named among the words; hallway's where there is none, as for `demo`.
std::vector<std::pair<std::string, ParameterRow>> parameters_of(const std::vector<std::string>& words) {
  std::string graph = "hallway";
  const std::vector<std::string> names = names_of("graphs");
  for (const std::string& word : words) {
    if (word.ends_with(".yaml") || std::ranges::find(names, word) != names.end()) graph = word;
  }
  std::vector<std::pair<std::string, ParameterRow>> all;
  const Host host(load_graph(graph, {}), {.is_partial = true});
  const auto add = [&all](const std::string& section, const ParameterReport& report) {
    for (const ParameterRow& row : report.rows) all.emplace_back(section + "." + row.name, row);
  };
  for (const auto& [section, report] : host.parameters()) add(section, report);
  for (const auto& [section, report] : host.shared_parameters()) add(section, report);
  return all;
}

std::vector<std::string> values_of(const ParameterRow& row) {
  return row.type == "bool" ? std::vector<std::string>{"true", "false"} : row.choices;
}

std::vector<std::string> settings(const std::vector<std::string>& words, const std::string& begun) {
  const std::size_t equals = begun.find('=');
  const std::string name = begun.substr(0, equals);
  std::vector<std::string> all;
  if (equals == std::string::npos) all.emplace_back("robot=");
  if (name == "robot" && equals != std::string::npos) {
    for (const std::string& robot : names_of("robots")) all.push_back("robot=" + robot);
    return all;
  }
  for (const auto& [known, row] : parameters_of(words)) {
    if (equals == std::string::npos) {
      all.push_back(known + "=");
    } else if (known == name) {
      for (const std::string& value : values_of(row)) all.push_back(name + "=" + value);
    }
  }
  return all;
}

/// Behind the last comma.
std::vector<std::string> planners(const std::string& begun) {
  const std::size_t comma = begun.rfind(',');
  const std::string before = comma == std::string::npos ? "" : begun.substr(0, comma + 1);
  std::vector<std::string> all;
  for (const auto& [name, row] : parameters_of({})) {
    if (name != "local_planner.algorithm") continue;
    for (const std::string& planner : row.choices) all.push_back(before + planner);
  }
  return all;
}

}  // namespace

std::vector<std::string> value_candidates(const std::string& asked, const std::vector<std::string>& words,
                                          const std::string& begun) {
  if (asked == "GRAPH" || asked == "TARGET" || asked == "--graph") return names_of("graphs");
  if (asked == "SUITE") return names_of("suites");
  if (asked == "ROBOT") return names_of("robots");
  if (asked == "--set") return settings(words, begun);
  if (asked == "--planner" || asked == "--planners") return planners(begun);
  return {};
}

}  // namespace bw::cli
