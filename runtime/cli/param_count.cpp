#include "runtime/cli/param_count.hpp"

#include <exception>
#include <iostream>
#include <map>
#include <set>

#include <fmt/format.h>

#include "runtime/host/host.hpp"

namespace bw::cli {
namespace {

class NameCount {
 public:
  explicit NameCount(bool all) : all_(all) {}

  /// Each component by itself: stand-ins for one another, as a localization and the ideal one, do not live
  /// together.
  void add(const Graph& graph) {
    for (const ComponentNode& node : graph.components) {
      Graph alone = graph;
      alone.components = {node};
      alone.components.front().enabled = true;
      try {
        const Host host(std::move(alone), {.is_partial = true});
        for (const auto& [name, report] : host.parameters()) add(node.type, report);
        for (const auto& [section, report] : host.shared_parameters()) add(section, report);
      } catch (const std::exception& fault) {
        faults_[node.type] = fault.what();
      }
    }
  }

  int print() const {
    std::size_t sum = 0;
    for (const auto& [type, names] : names_) {
      std::cout << fmt::format("{:5} {}\n", names.size(), type);
      sum += names.size();
    }
    std::cout << fmt::format("{:5}\n", sum);
    int status = 0;
    for (const auto& [type, fault] : faults_) {
      if (names_.contains(type)) continue;
      std::cerr << type << " is not counted: " << fault << "\n";
      status = 1;
    }
    return status;
  }

 private:
  void add(const std::string& type, const ParameterReport& report) {
    std::set<std::string>& names = names_[type];
    if (all_) return names.insert(report.names.begin(), report.names.end());
    for (const ParameterRow& row : report.rows) {
      if (row.first) names.insert(row.name);
    }
  }

  bool all_;
  std::map<std::string, std::set<std::string>> names_;
  std::map<std::string, std::string> faults_;  ///< of types, the newest
};

}  // namespace

int count_names(const std::vector<std::string>& graphs, const std::vector<std::string>& set, bool all) {
  NameCount count(all);
  for (const std::string& path : graphs) count.add(load_graph(path, set));
  return count.print();
}

}  // namespace bw::cli
