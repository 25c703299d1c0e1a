#include "runtime/replay/output_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "runtime/wire/leaves.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::replay {
namespace {

/// ranges[17] -> ranges
std::string without_indexes(const std::string& path) {
  std::string out;
  bool inside = false;
  for (const char c : path) {
    if (c == '[') inside = true;
    if (!inside) out += c;
    if (c == ']') inside = false;
  }
  return out;
}

/// Of two numbers; nothing where one is none. Equal infinities and NaN beside NaN are 0 apart.
std::optional<double> distance(const LeafValue& a, const LeafValue& b) {
  const auto number = [](const LeafValue& value) -> std::optional<double> {
    if (const auto* v = std::get_if<double>(&value)) return *v;
    if (const auto* v = std::get_if<std::int64_t>(&value)) return static_cast<double>(*v);
    if (const auto* v = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*v);
    return std::nullopt;
  };
  const auto x = number(a);
  const auto y = number(b);
  if (!x || !y) return std::nullopt;
  if (*x == *y || (std::isnan(*x) && std::isnan(*y))) return 0.0;
  const double apart = std::abs(*x - *y);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

std::string time_text(Time time) { return fmt::format("{:.9f} s", time.to_seconds()); }

}  // namespace

void OutputComparison::add_topic(const std::string& topic, const std::string& type) {
  verdicts_[topic].type = type;
}

void OutputComparison::expect(const std::string& topic, Time time, bag::BytesView cdr) {
  waiting_[topic].expected.push_back({time, {cdr.begin(), cdr.end()}});
  match(topic);
}

void OutputComparison::got(const std::string& topic, Time time, bag::BytesView cdr) {
  waiting_[topic].got.push_back({time, {cdr.begin(), cdr.end()}});
  match(topic);
}

void OutputComparison::match(const std::string& topic) {
  Pair& pair = waiting_[topic];
  while (!pair.expected.empty() && !pair.got.empty()) {
    compare(topic, pair.expected.front(), pair.got.front());
    pair.expected.pop_front();
    pair.got.pop_front();
  }
}

void OutputComparison::compare(const std::string& topic, const Waiting& recorded, const Waiting& replayed) {
  TopicVerdict& verdict = verdicts_[topic];
  if (recorded.time == replayed.time && recorded.cdr == replayed.cdr) {
    ++verdict.equal;
    return;
  }
  std::optional<Difference> first;
  if (recorded.time != replayed.time)
    first = {recorded.time, "", time_text(recorded.time), time_text(replayed.time)};
  const TypeDescription* type = find_type(verdict.type);
  const auto old_leaves = type == nullptr ? std::vector<Leaf>() : leaves_of(*type, recorded.cdr);
  const auto new_leaves = type == nullptr ? std::vector<Leaf>() : leaves_of(*type, replayed.cdr);
  const auto& left_out = tolerances_.left_out[topic];
  const auto& absolute = tolerances_.absolute[topic];
  const bool is_explained = !old_leaves.empty();
  for (std::size_t i = 0; i < std::min(old_leaves.size(), new_leaves.size()); ++i) {
    const Leaf& a = old_leaves[i];
    const Leaf& b = new_leaves[i];
    if (a.path == b.path && a.value == b.value) continue;
    const std::string field = without_indexes(a.path);
    if (std::ranges::find(left_out, field) != left_out.end()) continue;
    // Negative: not two numbers of one field.
    const double apart = a.path == b.path ? distance(a.value, b.value).value_or(-1.0) : -1.0;
    if (apart > verdict.largest) {
      verdict.largest = apart;
      verdict.largest_field = a.path;
    }
    const auto tolerance = absolute.find(field);
    if (apart == 0.0 || (apart > 0.0 && tolerance != absolute.end() && apart <= tolerance->second)) continue;
    if (!first) first = {recorded.time, a.path, to_text(a.value), to_text(b.value)};
    if (a.path != b.path) break;  // sequences of other lengths: what follows is not the same field
  }
  if (!is_explained && !first) first = {recorded.time, "bytes", "", ""};
  if (!first) {
    ++verdict.equal;
    return;
  }
  ++verdict.differing;
  if (!verdict.first) verdict.first = std::move(first);
}

void OutputComparison::finish(Time end) {
  for (auto& [topic, pair] : waiting_) {
    TopicVerdict& verdict = verdicts_[topic];
    verdict.missing += pair.expected.size();
    if (!pair.expected.empty() && !verdict.first) {
      verdict.first = Difference{pair.expected.front().time, "", "a message", "none"};
    }
    const auto is_late = [&](const Waiting& w) { return w.time >= end; };
    const auto count = std::ranges::count_if(pair.got, [&](const Waiting& w) { return !is_late(w); });
    verdict.extra += static_cast<std::uint64_t>(count);
    if (count > 0 && !verdict.first)
      verdict.first = Difference{pair.got.front().time, "", "none", "a message"};
  }
  waiting_.clear();
}

std::optional<std::string> OutputComparison::first_topic() const {
  std::optional<std::string> first;
  for (const auto& [topic, verdict] : verdicts_) {
    if (verdict.first && (!first || verdict.first->time < verdicts_.at(*first).first->time)) first = topic;
  }
  return first;
}

std::uint64_t OutputComparison::compared() const {
  std::uint64_t sum = 0;
  for (const auto& [topic, verdict] : verdicts_) sum += verdict.equal + verdict.differing;
  return sum;
}

}  // namespace bw::replay
