#include "components/lab/evaluate/suite.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "runtime/graph/config_file.hpp"
#include "runtime/parameters/parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

/// `text` with every ${NAME} replaced.
std::string with_environment(const std::string& text, const Location& where) {
  const auto refuse = [&](const std::string& rule) {
    throw ConfigError(Violation{where, "set", text, rule});
  };
  std::string out;
  std::size_t at = 0;
  for (std::size_t open = text.find("${"); open != std::string::npos; open = text.find("${", at)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) refuse("a ${ must be closed by }");
    const std::string name = text.substr(open + 2, close - open - 2);
    const char* value = std::getenv(name.c_str());
    if (value == nullptr) refuse("the environment variable " + name + " must be set");
    out += text.substr(at, open - at) + value;
    at = close + 1;
  }
  return out + text.substr(at);
}

void relocate(ConfigNode& node, const Location& where) {
  node.where = where;
  for (ConfigNode& element : node.sequence) relocate(element, where);
  for (ConfigEntry& entry : node.map) {
    entry.where = where;
    relocate(entry.value, where);
  }
}

/// The overrides of the list at `key`, written where the suite has them.
void read_overrides(const ConfigNode& root, const std::string& key, std::vector<Override>& overrides,
                    std::vector<Violation>& violations) {
  const ConfigNode* list = find_dotted(root, key);
  if (list == nullptr) return;
  for (const ConfigNode& line : list->sequence) {
    try {
      Override change = parse_override(with_environment(line.scalar, line.where));
      relocate(change.value, line.where);
      overrides.push_back(std::move(change));
    } catch (const ConfigError& error) {
      for (Violation violation : error.violations()) {
        violation.where = line.where;
        violations.push_back(std::move(violation));
      }
    }
  }
}

}  // namespace

bool is_episode_name(const std::string& text) {
  const auto is_allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 100 && text.front() != '.' &&
         std::all_of(text.begin(), text.end(), is_allowed);
}

std::optional<std::string> SuiteOptions::violated_rule() const {
  if (graph.empty()) return "graph must name a graph file";
  if (episodes.empty()) return "episodes must hold at least one";
  std::set<std::string> names;
  for (const SuiteEpisode& episode : episodes) {
    if (!is_episode_name(episode.name)) {
      return "an episode's name must be letters, digits, dot, _ and -, not '" + episode.name + "'";
    }
    if (!names.insert(episode.name).second) return "two episodes are named '" + episode.name + "'";
  }
  names.clear();
  for (const SuiteVariant& variant : variants) {
    if (!is_episode_name(variant.name)) {
      return "a variant's name must be letters, digits, dot, _ and -, not '" + variant.name + "'";
    }
    if (!names.insert(variant.name).second) return "two variants are named '" + variant.name + "'";
  }
  return std::nullopt;
}

Graph Suite::graph_of(std::size_t episode, const std::string& variant) const {
  Graph loaded = load_graph(graph);
  for (const Override& change : overrides[episode]) apply_override(loaded, change);
  if (variant.empty()) return loaded;
  std::string known;
  for (std::size_t i = 0; i < options.variants.size(); ++i) {
    known += (i == 0 ? "" : ", ") + options.variants[i].name;
    if (options.variants[i].name != variant) continue;
    for (const Override& change : variant_overrides[i]) apply_override(loaded, change);
    return loaded;
  }
  throw std::runtime_error("--variants " + variant + ": the suite of " + graph.string() + " has " +
                           (known.empty() ? "none" : known));
}

Suite load_suite(const std::filesystem::path& asked) {
  const std::filesystem::path file = config_file("suites", asked);
  const ConfigNode root = load_yaml(file);
  Suite suite;
  suite.options = read_parameters<SuiteOptions>(root, "");
  suite.graph = resolve_path(root.find("graph")->where, suite.options.graph);
  std::vector<Violation> violations;
  std::vector<Override> common;
  read_overrides(root, "set", common, violations);
  for (std::size_t i = 0; i < suite.options.episodes.size(); ++i) {
    suite.overrides.push_back(common);
    read_overrides(root, "episodes." + std::to_string(i) + ".set", suite.overrides.back(), violations);
  }
  for (std::size_t i = 0; i < suite.options.variants.size(); ++i) {
    suite.variant_overrides.emplace_back();
    read_overrides(root, "variants." + std::to_string(i) + ".set", suite.variant_overrides.back(),
                   violations);
  }
  throw_if_any(std::move(violations));
  return suite;
}

}  // namespace bw
