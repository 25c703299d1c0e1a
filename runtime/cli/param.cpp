#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/cli/param_count.hpp"
#include "runtime/cli/param_graph.hpp"
#include "runtime/cli/param_node.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/config_file.hpp"

namespace bw::cli {
namespace {

/// What stands behind `list` and `dump`: a graph, then one of its components; or a running node.
struct Target {
  std::string name;
  GraphParameters graph;

  bool is_graph() const { return find_config_file("graphs", name).has_value(); }
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
std::shared_ptr<Target> add_target(Verb verb, bool is_required) {
  auto target = std::make_shared<Target>();
  const Option name = verb.option("TARGET", target->name, "Graph file (.yaml), or a running node");
  if (is_required) name.required();
  verb.option("COMPONENT", target->graph.component,
              "Only this component of the graph, or section that components share: all of it");
  verb.option("--set", target->graph.set, "component.param=value, of the graph").one_each_time();
  return target;
}

void add_param_list(Verb param) {
  Verb verb = param.verb(
      "list",
      "Of a graph: names, types, ranges, defaults, values, meaning. Of a node, or all of them: names");
  auto target = add_target(verb, false);
  auto counted = std::make_shared<std::vector<std::string>>();
  verb.flag("--all", target->graph.all, "Of a graph: not only those that people turn first");
  verb.option("--count", *counted, "How many names these graphs have, type by type");
  verb.run([target, counted] {
    if (!counted->empty()) return count_names(*counted, target->graph.set, target->graph.all);
    if (target->name.empty()) return list_nodes_parameters();
    if (!target->is_graph()) return list_node(target->as_node());
    list_graph(target->as_graph());
    return 0;
  });
}

void add_dump(Verb param) {
  Verb verb = param.verb(
      "dump",
      "Values in use. Of a graph: YAML for its parameters: sections. Of a node: a file for `param load`");
  auto target = add_target(verb, true);
  verb.run([target] {
    if (!target->is_graph()) return dump_node(target->as_node());
    dump_graph(target->as_graph());
    return 0;
  });
}

struct Named {
  std::string node, name, value;
};

void add_one(Verb param) {
  auto named = std::make_shared<Named>();
  const auto add = [&](const char* verb_name, const char* help) {
    Verb verb = param.verb(verb_name, help);
    verb.option("NODE", named->node, "Running node").required();
    return verb;
  };
  Verb get = add("get", "Value of a parameter of a running node");
  get.option("NAME", named->name, "Parameter").required();
  get.run([named] { return get_parameter(named->node, named->name); });
  Verb describe =
      add("describe", "Type, meaning, range of a parameter of a running node; may it be changed?");
  describe.option("NAME", named->name, "Parameter").required();
  describe.run([named] { return describe_parameter(named->node, named->name); });
  Verb set = add("set", "Changes a parameter of a running node, if its component takes it");
  set.option("NAME", named->name, "Parameter").required();
  set.option("VALUE", named->value, "As YAML: 1 is an integer, 1.0 a double").required();
  set.run([named] { return set_parameter(named->node, named->name, named->value); });
  Verb load = add("load", "Changes parameters of a running node to those of a file");
  load.option("FILE", named->value, "As `param dump NODE` writes it").required();
  load.run([named] { return load_node(named->node, named->value); });
}

void add_param(Verb param) {
  add_param_list(param);
  add_dump(param);
  add_one(param);
}

}  // namespace

BW_VERB(look, "param", "Parameters of a graph's components or of running nodes", add_param)

}  // namespace bw::cli
