#include "runtime/parameters/parameter_file.hpp"

#include <algorithm>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

constexpr std::string_view kParameters = "ros__parameters";
constexpr std::string_view kEveryNode = "/**";

class Reader {
 public:
  explicit Reader(std::string_view node) : node_(node) {}

  /// `node` is what the keys so far say, with slashes.
  void read_nodes(const ConfigNode& map, const std::string& node) {
    for (const ConfigEntry& entry : map.map) {
      if (entry.key == kParameters) {
        if (node != node_ && node != kEveryNode) continue;
        found_ = true;
        read_parameters(entry.value, "");
      } else {
        const std::string key = entry.key.starts_with('/') ? entry.key.substr(1) : entry.key;
        read_nodes(entry.value, node + "/" + key);
      }
    }
  }

  std::vector<NamedValue> take(const ConfigNode& file) {
    if (!found_) {
      violations_.push_back({file.where, "", "",
                             "says nothing of " + std::string(node_) + "; it should have '" +
                                 std::string(node_) + ": {ros__parameters: ...}'"});
    }
    throw_if_any(std::move(violations_));
    return std::move(parameters_);
  }

 private:
  void read_parameters(const ConfigNode& node, const std::string& name) {
    if (node.is_map()) {
      for (const ConfigEntry& entry : node.map) read_parameters(entry.value, joined(name, entry.key));
    } else if (auto value = parameter_value_of(node)) {
      parameters_.push_back({name, std::move(*value)});
    } else {
      violations_.push_back(
          {node.where, name, node.text(), "must be a bool, a number, text, or a list of one of these"});
    }
  }

  std::string_view node_;
  bool found_ = false;
  std::vector<NamedValue> parameters_;
  std::vector<Violation> violations_;
};

}  // namespace

std::string to_parameter_file(std::string_view node, const std::vector<NamedValue>& parameters) {
  std::string text = std::string(node) + ":\n  " + std::string(kParameters) + ":\n";
  std::vector<std::string> open;
  for (const NamedValue& parameter : parameters) {
    const std::vector<std::string> parts = parts_of(parameter.name);
    const std::size_t most = std::min(open.size(), parts.size() - 1);
    const auto last = parts.begin() + static_cast<std::ptrdiff_t>(most);
    const auto same =
        static_cast<std::size_t>(std::mismatch(parts.begin(), last, open.begin()).first - parts.begin());
    const auto margin = [](std::size_t depth) { return std::string(4 + 2 * depth, ' '); };
    for (std::size_t i = same; i + 1 < parts.size(); ++i)
      text.append(margin(i)).append(to_text(parts[i])).append(":\n");
    text.append(margin(parts.size() - 1)).append(to_text(parts.back())).append(": ");
    text.append(to_yaml_text(parameter.value)).append("\n");
    open.assign(parts.begin(), parts.end() - 1);
  }
  return text;
}

std::vector<NamedValue> parameters_of_node(const ConfigNode& file, std::string_view node) {
  Reader reader(node);
  reader.read_nodes(file, "");
  return reader.take(file);
}

}  // namespace bw
