#include "runtime/recording/bag/ros2msg.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace bw::bag {
namespace {

constexpr std::string_view kBlank = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Takes everything up to `end` and the end itself off `text`.
std::string_view take(std::string_view& text, std::string_view ends) {
  const std::size_t end = std::min(text.find_first_of(ends), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

/// nav_msgs/msg/Odometry -> nav_msgs/Odometry
std::string short_name(std::string_view name) {
  return std::string(name.substr(0, name.find('/'))) + std::string(name.substr(name.rfind('/')));
}

bool is_separator(std::string_view line) {
  return line.size() >= 3 && line.find_first_not_of('=') == std::string_view::npos;
}

std::string full_type(std::string_view type, std::string_view package) {
  static constexpr std::array<std::string_view, 12> kPrimitives = {"bool",   "int8",    "uint8",   "int16",
                                                                   "uint16", "int32",   "int64",   "uint32",
                                                                   "uint64", "float32", "float64", "string"};
  if (type == "char" || type == "byte") return "uint8";
  if (type == "time" || type == "duration")
    return type == "time" ? "builtin_interfaces/Time" : "builtin_interfaces/Duration";
  if (std::ranges::find(kPrimitives, type.substr(0, type.find('<'))) != kPrimitives.end())
    return std::string(type);
  if (type.find('/') != std::string_view::npos) return short_name(type);
  return type == "Header" ? "std_msgs/Header" : std::string(package) + "/" + std::string(type);
}

/// A line `type name`, `type name default` or `type NAME=value`; nothing for the last one, which is a
/// constant.
std::optional<MsgField> field_of(std::string_view line, std::string_view package) {
  const std::string_view type = take(line, kBlank);
  line = trimmed(line);
  const std::string_view name = line.substr(0, line.find_first_of(" \t="));
  const std::string_view rest = trimmed(line.substr(name.size()));
  if (name.empty() || rest.starts_with('=')) return std::nullopt;
  const std::size_t bracket = std::min(type.find('['), type.size());
  return MsgField{.type = full_type(type.substr(0, bracket), package),
                  .array = std::string(type.substr(bracket)),
                  .name = std::string(name)};
}

class Comparison {
 public:
  Comparison(const MsgDefinition& bag, const MsgDefinition& here) : bag_(bag), here_(here) {}

  std::optional<std::string> fields(const std::vector<MsgField>& bag, const std::vector<MsgField>& here,
                                    const std::string& prefix) {
    for (std::size_t i = 0; i < std::max(bag.size(), here.size()); ++i) {
      const std::string theirs = i < bag.size() ? in_words(bag[i], prefix) : "nothing";
      const std::string ours = i < here.size() ? in_words(here[i], prefix) : "nothing";
      if (theirs != ours) return "the bag's schema has " + theirs + " where this build has " + ours;
      if (auto difference = contained(bag[i].type, prefix + bag[i].name + ".")) return difference;
    }
    return std::nullopt;
  }

 private:
  static std::string in_words(const MsgField& field, const std::string& prefix) {
    return field.type + field.array + " " + prefix + field.name;
  }
  std::optional<std::string> contained(const std::string& type, const std::string& prefix) {
    const auto theirs = bag_.contained.find(type);
    const auto ours = here_.contained.find(type);
    if (theirs == bag_.contained.end() || ours == here_.contained.end()) return std::nullopt;
    if (!compared_.insert(type).second)
      return std::nullopt;  // once is enough, and a circle of a hostile text ends
    return fields(theirs->second, ours->second, prefix);
  }

  const MsgDefinition& bag_;
  const MsgDefinition& here_;
  std::set<std::string> compared_;
};

}  // namespace

MsgDefinition parse_ros2msg(std::string_view type, std::string_view text) {
  MsgDefinition definition;
  std::vector<MsgField>* fields = &definition.fields;
  std::string package(type.substr(0, type.find('/')));
  while (!text.empty()) {
    std::string_view line = take(text, "\n");
    line = trimmed(take(line, "#"));
    if (line.empty() || is_separator(line)) continue;
    if (line.starts_with("MSG:")) {
      const std::string_view name = trimmed(line.substr(4));
      if (name.find('/') == std::string_view::npos) continue;
      fields = &definition.contained[short_name(name)];
      package = name.substr(0, name.find('/'));
    } else if (std::optional<MsgField> field = field_of(line, package)) {
      fields->push_back(std::move(*field));
    }
  }
  return definition;
}

std::optional<std::string> first_difference(const MsgDefinition& bag, const MsgDefinition& here) {
  return Comparison(bag, here).fields(bag.fields, here.fields, "");
}

}  // namespace bw::bag
