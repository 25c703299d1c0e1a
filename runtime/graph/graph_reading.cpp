#include "runtime/graph/graph_reading.hpp"

#include "runtime/parameters/scalar_text.hpp"

namespace bw {

std::optional<std::string> label_rule(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '+';
  };
  if (!name.empty() && name.size() <= 64 && std::ranges::all_of(name, is_allowed)) return std::nullopt;
  return "must be a name: at most 64 letters, digits, _, - and +";
}

void read_name(ParameterReader& reader, const ConfigNode& map, std::string_view name, std::string& value,
               std::optional<std::string> (*rule)(std::string_view)) {
  reader(name, value);
  const ConfigNode* node = map.find(name);
  if (node == nullptr || !node->is_scalar()) return;
  if (const auto broken = rule(value)) reader.refuse(*node, name, *broken);
}

std::optional<Duration> read_span(ParameterReader& reader, std::string_view name, Duration least,
                                  Duration most, std::string_view example) {
  const ConfigNode* node = reader.find(name);
  if (node == nullptr) return std::nullopt;
  const std::optional<Duration> span = node->is_scalar() ? parse_duration(node->scalar) : std::nullopt;
  if (span && *span >= least && *span <= most) return span;
  reader.refuse(*node, name,
                "must be a duration between " + short_text(least.to_seconds()) + " s and " +
                    short_text(most.to_seconds()) + " s, such as " + std::string(example));
  return std::nullopt;
}

}  // namespace bw
