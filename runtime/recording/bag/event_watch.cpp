#include "runtime/recording/bag/event_watch.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>
#include <string_view>
#include <variant>

#include "runtime/parameters/nearest.hpp"
#include "runtime/wire/leaves.hpp"

namespace bw::bag {
namespace {

constexpr std::size_t kWhole = std::numeric_limits<std::size_t>::max();  // a field outside of any sequence

/// status[].name and status[3].name: 3. Of a field without []: kWhole. Nothing when the path is of another
/// field.
std::optional<std::size_t> element_of(std::string_view field, std::string_view path) {
  const std::size_t bracket = field.find("[]");
  if (bracket == std::string_view::npos) return field == path ? std::optional(kWhole) : std::nullopt;
  if (path.substr(0, bracket + 1) != field.substr(0, bracket + 1)) return std::nullopt;
  std::size_t index = 0;
  const char* begin = path.data() + bracket + 1;
  const auto [end, error] = std::from_chars(begin, path.data() + path.size(), index);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view rest(end, static_cast<std::size_t>(path.data() + path.size() - end));
  return rest == field.substr(bracket + 1) ? std::optional(index) : std::nullopt;
}

std::optional<double> number_of(const LeafValue& value) {
  if (const auto* v = std::get_if<double>(&value)) return *v;
  if (const auto* v = std::get_if<std::int64_t>(&value)) return static_cast<double>(*v);
  if (const auto* v = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*v);
  return std::nullopt;
}

bool is_equal(const LeafValue& value, const EventCondition& condition) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text == condition.text;
  if (const auto* flag = std::get_if<bool>(&value)) return condition.text == (*flag ? "true" : "false");
  return number_of(value) == condition.number;
}

bool holds(const LeafValue& value, const EventCondition& condition, std::optional<double> last) {
  const std::optional<double> number = number_of(value);
  const auto* text = std::get_if<std::string>(&value);
  switch (condition.rule) {
    case EventRule::is:
      return is_equal(value, condition);
    case EventRule::is_not:
      return !is_equal(value, condition);
    case EventRule::above:
      return number && *number > *condition.number;
    case EventRule::below:
      return number && *number < *condition.number;
    case EventRule::begins_with:
      return text != nullptr && text->starts_with(condition.text);
    case EventRule::rises:
      return number && last && *number > *last;
  }
  return false;
}

}  // namespace

bool all_hold(const std::vector<EventCondition>& conditions, const TypeDescription& type, BytesView cdr,
              std::map<std::size_t, double>& last) {
  std::vector<std::set<std::size_t>> where(conditions.size());  // elements at which each one holds
  for (const Leaf& leaf : leaves_of(type, cdr)) {
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      const auto element = element_of(conditions[i].field, leaf.path);
      if (!element) continue;
      const auto before = last.find(i);
      if (holds(leaf.value, conditions[i],
                before == last.end() ? std::nullopt : std::optional(before->second)))
        where[i].insert(*element);
      if (conditions[i].rule == EventRule::rises) last[i] = number_of(leaf.value).value_or(0.0);
    }
  }
  std::optional<std::set<std::size_t>> common;
  for (const auto& elements : where) {
    if (elements.empty()) return false;
    if (elements.contains(kWhole)) continue;
    std::set<std::size_t> both;
    if (common) std::ranges::set_intersection(*common, elements, std::inserter(both, both.end()));
    common = common ? std::move(both) : elements;
  }
  return !common || !common->empty();
}

std::optional<std::string> condition_rule(const TypeDescription& type, const EventCondition& condition) {
  const TypeDescription* inside = &type;
  std::string_view rest = condition.field;
  int sequences = 0;
  while (true) {
    const std::size_t end = std::min(rest.find('.'), rest.size());
    const std::string_view part = rest.substr(0, end);
    const std::string_view name = part.substr(0, part.find('['));
    const auto field = std::ranges::find(inside->fields, name, &FieldDescription::name);
    if (field == inside->fields.end()) {
      std::vector<std::string_view> known;
      for (const FieldDescription& f : inside->fields) known.push_back(f.name);
      return std::string(inside->ros_name) + ": " + unknown_rule("field", name, known);
    }
    const bool is_single = field->shape == Shape::kSingle;
    if (is_single != (name.size() == part.size()) || (!is_single && !part.ends_with(']')))
      return std::string(name) +
             (is_single ? " is one value, no sequence" : " is a sequence: write [] or [3] behind it");
    sequences += part.ends_with("[]") ? 1 : 0;
    const bool is_last = end == rest.size();
    if (is_last != (field->kind != Kind::kMessage))
      return std::string(name) + (is_last ? " is a message: name a field of it" : " has no fields");
    if (is_last) {
      const bool is_text = field->kind == Kind::kString;
      const bool wants_text = condition.rule == EventRule::begins_with;
      const bool wants_number = condition.rule == EventRule::above || condition.rule == EventRule::below ||
                                condition.rule == EventRule::rises;
      if (wants_text && !is_text) return std::string(name) + " is no text: it begins with nothing";
      if (wants_number && (is_text || field->kind == Kind::kBoolean))
        return std::string(name) + " is no number";
      const bool is_compared = condition.rule == EventRule::is || condition.rule == EventRule::is_not;
      if (is_compared && !is_text && field->kind != Kind::kBoolean && !condition.number)
        return std::string(name) + " is a number, and is compared with one";
      break;
    }
    inside = field->message;
    rest.remove_prefix(end + 1);
  }
  if (sequences > 1) return "may have [] once only";
  if (sequences > 0 && condition.rule == EventRule::rises) return "rises is of one value, not of any element";
  return std::nullopt;
}

std::size_t EventWatch::add_topic(const std::string& name, const TypeDescription* type) {
  Topic& topic = topics_.emplace_back();
  topic.type = type;
  for (const Event& event : events_) {
    if (event.topic == name && (event.when.empty() || type != nullptr))
      topic.watches.push_back({.event = &event});
  }
  return topics_.size() - 1;
}

std::vector<const Event*> EventWatch::look(std::size_t topic, BytesView cdr) {
  std::vector<const Event*> happened;
  for (Watch& watch : topics_[topic].watches) {
    const std::vector<EventCondition>& when = watch.event->when;
    const bool held = watch.held;
    watch.held = !when.empty() && all_hold(when, *topics_[topic].type, cdr, watch.last);
    const bool rises = std::ranges::any_of(when, [](const auto& c) { return c.rule == EventRule::rises; });
    if (when.empty() || (watch.held && (!held || rises))) happened.push_back(watch.event);
  }
  return happened;
}

}  // namespace bw::bag
