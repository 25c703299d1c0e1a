#include <filesystem>
#include <memory>
#include <stdexcept>

#include <CLI/App.hpp>

#include "runtime/cli/param_graph.hpp"
#include "runtime/cli/param_node.hpp"
#include "runtime/cli/verb.hpp"

namespace bw::cli {
namespace {

/// What stands behind `list` and `dump`: a graph file, then one of its components; or a running node.
struct Target {
  std::string name;
  GraphParameters graph;

  bool is_graph() const {
    return name.ends_with(".yaml") || name.ends_with(".yml") || std::filesystem::exists(name);
  }
  const GraphParameters& as_graph() {
    graph.path = name;
    return graph;
  }
  const std::string& as_node() const {
    if (!graph.component.empty() || !graph.set.empty())
      throw std::runtime_error(name + " is no graph file: COMPONENT and --set are for those");
    return name;
  }
};

/// A verb on a graph file or on a node.
std::shared_ptr<Target> add_target(CLI::App* verb) {
  auto target = std::make_shared<Target>();
  verb->add_option("TARGET", target->name, "Graph file (.yaml), or a running node");
  verb->add_option("COMPONENT", target->graph.component, "Only this component of the graph");
  verb->add_option("--set", target->graph.set, "component.param=value, of the graph")
      ->allow_extra_args(false);
  return target;
}

void add_list(CLI::App& param, int& status) {
  CLI::App* verb = param.add_subcommand(
      "list",
      "Of a graph: names, types, ranges, defaults, values, meaning. Of a node, or all of them: names");
  auto target = add_target(verb);
  verb->callback([target, &status] {
    if (target->is_graph()) {
      list_graph(target->as_graph());
    } else if (target->name.empty()) {
      status = list_nodes_parameters();
    } else {
      status = list_node(target->as_node());
    }
  });
}

void add_dump(CLI::App& param, int& status) {
  CLI::App* verb = param.add_subcommand(
      "dump",
      "Values in use. Of a graph: YAML for its parameters: sections. Of a node: a file for `param load`");
  auto target = add_target(verb);
  verb->get_option("TARGET")->required();
  verb->callback([target, &status] {
    if (target->is_graph()) {
      dump_graph(target->as_graph());
    } else {
      status = dump_node(target->as_node());
    }
  });
}

struct Named {
  std::string node, name, value;
};

void add_one(CLI::App& param, int& status) {
  auto named = std::make_shared<Named>();
  const auto add = [&](const char* verb_name, const char* help) {
    CLI::App* verb = param.add_subcommand(verb_name, help);
    verb->add_option("NODE", named->node, "Running node")->required();
    return verb;
  };
  CLI::App* get = add("get", "Value of a parameter of a running node");
  get->add_option("NAME", named->name, "Parameter")->required();
  get->callback([named, &status] { status = get_parameter(named->node, named->name); });
  CLI::App* describe =
      add("describe", "Type, meaning, range of a parameter of a running node; may it be changed?");
  describe->add_option("NAME", named->name, "Parameter")->required();
  describe->callback([named, &status] { status = describe_parameter(named->node, named->name); });
  CLI::App* set = add("set", "Changes a parameter of a running node, if its component takes it");
  set->add_option("NAME", named->name, "Parameter")->required();
  set->add_option("VALUE", named->value, "As YAML: 1 is an integer, 1.0 a double")->required();
  set->callback([named, &status] { status = set_parameter(named->node, named->name, named->value); });
  CLI::App* load = add("load", "Changes parameters of a running node to those of a file");
  load->add_option("FILE", named->value, "As `param dump NODE` writes it")->required();
  load->callback([named, &status] { status = load_node(named->node, named->value); });
}

CLI::App* add_param(CLI::App& app, int& status) {
  CLI::App* param = app.add_subcommand("param", "Parameters of a graph's components or of running nodes")
                        ->require_subcommand(1);
  add_list(*param, status);
  add_dump(*param, status);
  add_one(*param, status);
  return param;
}

}  // namespace

BW_VERB(look, "param", add_param)

}  // namespace bw::cli
