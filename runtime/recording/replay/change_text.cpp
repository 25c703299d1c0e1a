#include "runtime/recording/replay/change_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runtime/wire/leaves.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::replay {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(200);
constexpr std::string_view kPictures = "visualization_msgs/";
constexpr std::size_t kLongestList = 12;  // numbers that stand one by one

std::string rounded(double value) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::optional<double> number(const LeafValue& value) {
  if (const auto* v = std::get_if<double>(&value)) return *v;
  if (const auto* v = std::get_if<std::int64_t>(&value)) return static_cast<double>(*v);
  if (const auto* v = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*v);
  if (const auto* v = std::get_if<bool>(&value)) return *v ? 1.0 : 0.0;
  return std::nullopt;
}

/// The list that an element stands in: the path up to its last index, with what comes behind it.
std::string list_of(const std::string& path) {
  const std::size_t open = path.rfind('[');
  if (open == std::string::npos) return {};
  return path.substr(0, open) + "[]" + path.substr(path.find(']', open) + 1);
}

bool is_stamp(const std::string& path) { return path.ends_with(".sec") || path.ends_with(".nanosec"); }

/// Of a list too long to stand there value by value.
std::string summary(const std::string& list, const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  const auto [least, largest] = std::ranges::minmax(values);
  const std::string from = rounded(least), to = rounded(largest);
  if (from == to) return from == "0" ? "" : fmt::format(" {}={{{} of {}}}", list, values.size(), from);
  return fmt::format(" {}={{{} from {} to {}, mean {}}}", list, values.size(), from, to,
                     rounded(sum / static_cast<double>(values.size())));
}

/// What a list of a message holds: how many elements, and those that are numbers.
struct List {
  std::size_t size = 0;
  std::vector<double> numbers;
  bool is_told = false;
};

std::map<std::string, List> lists_of(const std::vector<Leaf>& leaves) {
  std::map<std::string, List> lists;
  for (const Leaf& leaf : leaves) {
    const std::string path = list_of(leaf.path);
    if (path.empty()) continue;
    List& list = lists[path];
    ++list.size;
    if (const auto value = number(leaf.value)) list.numbers.push_back(*value);
  }
  return lists;
}

std::string line_of(const std::vector<Leaf>& leaves) {
  std::map<std::string, List> lists = lists_of(leaves);
  std::string line;
  for (const Leaf& leaf : leaves) {
    if (is_stamp(leaf.path)) continue;
    const auto list = lists.find(list_of(leaf.path));
    if (list != lists.end() && list->second.size > kLongestList) {
      if (std::exchange(list->second.is_told, true) || list->second.numbers.empty()) continue;
      line += summary(list->first, list->second.numbers);
      continue;
    }
    const auto value = number(leaf.value);
    const std::string text = value ? rounded(*value) : to_text(leaf.value);
    if (text == "0" || text == "\"\"") continue;
    line += " " + leaf.path + "=" + text;
  }
  return line;
}

}  // namespace

void ChangeText::add(const std::string& topic, const std::string& type, Time time, bag::BytesView cdr) {
  if (type.starts_with(kPictures)) return;
  Topic& entry = topics_[topic + " " + type];
  const std::int64_t period = (time - start_).nanoseconds / kPeriod.nanoseconds;
  if (period <= entry.last_period) return;
  entry.last_period = period;
  const TypeDescription* description = find_type(type);
  const std::string line =
      description == nullptr ? fmt::format(" {} bytes", cdr.size()) : line_of(leaves_of(*description, cdr));
  entry.lines += fmt::format("  {:.3f}{}\n", (time - start_).to_seconds(), line);
}

std::string ChangeText::text() const {
  std::string text;
  for (const auto& [name, topic] : topics_) text += name + "\n" + topic.lines;
  return text;
}

}  // namespace bw::replay
