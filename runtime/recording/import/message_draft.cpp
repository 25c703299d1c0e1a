#include "runtime/recording/import/message_draft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/wire/cdr_writer.hpp"
#include "runtime/wire/number_kinds.hpp"

namespace bw::imports {
namespace {

constexpr std::string_view kTimeType = "builtin_interfaces/msg/Time";
constexpr std::string_view kDurationType = "builtin_interfaces/msg/Duration";
constexpr std::string_view kQuaternionType = "geometry_msgs/msg/Quaternion";
constexpr std::string_view kHeaderType = "std_msgs/msg/Header";
constexpr std::string_view kAngles[] = {"roll", "pitch", "yaw"};
constexpr std::size_t kMaxElements = 1000;

/// "covariance[4]" is covariance and 4.
struct Part {
  std::string_view name;
  std::optional<std::size_t> index;
};

Part part_of(std::string_view text) {
  const std::size_t bracket = text.find('[');
  if (bracket == std::string_view::npos) return {text, std::nullopt};
  const std::string_view inside = text.substr(bracket + 1);
  const std::optional<std::int64_t> index =
      inside.ends_with(']') ? parse_integer(inside.substr(0, inside.size() - 1)) : std::nullopt;
  if (!index || *index < 0 || *index >= static_cast<std::int64_t>(kMaxElements))
    throw std::invalid_argument(fmt::format("'{}': an element is written as name[0]", text));
  return {text.substr(0, bracket), static_cast<std::size_t>(*index)};
}

std::vector<std::string_view> names_of(const TypeDescription& type) {
  std::vector<std::string_view> names;
  for (const FieldDescription& field : type.fields) names.push_back(field.name);
  if (type.ros_name == kQuaternionType) names.insert(names.end(), {"roll", "pitch", "yaw"});
  return names;
}

}  // namespace

MessageDraft::Node MessageDraft::make(const FieldDescription& field) {
  Node node{.field = &field};
  const std::size_t count = field.shape == Shape::kSingle  ? 1
                            : field.shape == Shape::kArray ? field.capacity
                                                           : 0;
  if (field.kind == bw::Kind::kString) {
    node.texts.resize(count);
  } else if (field.kind != bw::Kind::kMessage) {
    node.numbers.resize(count);
  } else if (field.shape == Shape::kSingle) {
    fill(node, *field.message);
  } else {
    node.children.resize(count);
    for (Node& child : node.children) fill(child, *field.message);
  }
  return node;
}

void MessageDraft::fill(Node& node, const TypeDescription& type) {
  node.type = &type;
  for (const FieldDescription& field : type.fields) node.children.push_back(make(field));
}

MessageDraft::MessageDraft(const TypeDescription& type) { fill(root_, type); }

const FieldDescription& MessageDraft::field_of(const Node& node, std::string_view name) {
  if (node.type == nullptr)
    throw std::invalid_argument(fmt::format("nothing is below '{}'", node.field->name));
  const auto field = std::ranges::find(node.type->fields, name, &FieldDescription::name);
  if (field != node.type->fields.end()) return *field;
  throw std::invalid_argument(fmt::format("{} has no '{}': {}", node.type->ros_name, name,
                                          unknown_rule("field", name, names_of(*node.type))));
}

MessageDraft::Node& MessageDraft::element_of(Node& list, std::size_t index, Target& target) {
  const FieldDescription& field = *list.field;
  if (field.shape == Shape::kSingle) throw std::invalid_argument(fmt::format("'{}' is no list", field.name));
  if (field.capacity != 0 && index >= field.capacity)
    throw std::invalid_argument(fmt::format("'{}' has {} elements", field.name, field.capacity));
  if (field.kind == bw::Kind::kMessage) {
    while (list.children.size() <= index) fill(list.children.emplace_back(), *field.message);
    target.steps.push_back(index);
    return list.children[index];
  }
  if (field.kind == bw::Kind::kString) {
    list.texts.resize(std::max(list.texts.size(), index + 1));
  } else {
    list.numbers.resize(std::max(list.numbers.size(), index + 1));
  }
  target.element = index;
  target.is_element = true;
  return list;
}

MessageDraft::Target MessageDraft::find(std::string_view path) {
  Target target;
  Node* at = &root_;
  for (std::string_view rest = path; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find('.'));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    if (target.is_element) throw std::invalid_argument(fmt::format("nothing is below '{}'", at->field->name));
    const bool is_rotation = at->type != nullptr && at->type->ros_name == kQuaternionType;
    if (const auto* angle = std::ranges::find(kAngles, word); is_rotation && angle != std::end(kAngles)) {
      if (!rest.empty()) throw std::invalid_argument("nothing is below an angle");
      at->numbers.resize(3);
      target.kind = Kind::angle;
      target.element = static_cast<std::size_t>(angle - kAngles);
      return target;
    }
    const Part part = part_of(word);
    target.field = &field_of(*at, part.name);
    target.steps.push_back(static_cast<std::size_t>(target.field - at->type->fields.data()));
    at = &at->children[target.steps.back()];
    if (part.index) at = &element_of(*at, *part.index, target);
  }
  if (at == &root_) throw std::invalid_argument("a field must be named");
  target.kind = kind_of(*at, target);
  return target;
}

MessageDraft::Kind MessageDraft::kind_of(const Node& node, const Target& target) {
  if (node.type != nullptr) {
    if (node.type->ros_name == kTimeType || node.type->ros_name == kDurationType) return Kind::time;
    throw std::invalid_argument(fmt::format("is a whole {}: one of its fields must be named ({})",
                                            node.type->ros_name, comma_separated(names_of(*node.type))));
  }
  const FieldDescription& field = *target.field;
  const bool is_whole_list = field.shape != Shape::kSingle && !target.is_element;
  if (is_whole_list && (field.kind == bw::Kind::kString || field.kind == bw::Kind::kMessage))
    throw std::invalid_argument(fmt::format("is a list: name its elements, {}[0]", field.name));
  if (field.kind == bw::Kind::kString) return Kind::text;
  return is_whole_list ? Kind::numbers : Kind::number;
}

const MessageDraft::Node& MessageDraft::node(const Target& target) const {
  const Node* at = &root_;
  for (const std::size_t step : target.steps) at = &at->children[step];
  return *at;
}

MessageDraft::Node& MessageDraft::node(const Target& target) {
  return const_cast<Node&>(static_cast<const MessageDraft&>(*this).node(target));
}

std::optional<std::string> MessageDraft::set(const Target& target, double value) {
  Node& at = node(target);
  if (target.kind == Kind::angle) {
    if (!std::isfinite(value)) return "an angle must be finite";
    at.numbers[target.element] = value;
    const double half[] = {at.numbers[0] / 2.0, at.numbers[1] / 2.0, at.numbers[2] / 2.0};
    const double cr = std::cos(half[0]), cp = std::cos(half[1]), cy = std::cos(half[2]);
    const double sr = std::sin(half[0]), sp = std::sin(half[1]), sy = std::sin(half[2]);
    at.children[0].numbers[0] = sr * cp * cy - cr * sp * sy;
    at.children[1].numbers[0] = cr * sp * cy + sr * cp * sy;
    at.children[2].numbers[0] = cr * cp * sy - sr * sp * cy;
    at.children[3].numbers[0] = cr * cp * cy + sr * sp * sy;
    return std::nullopt;
  }
  if (auto rule = broken_rule(target.field->kind, value)) return rule;
  at.numbers[target.element] = value;
  return std::nullopt;
}

std::optional<std::string> MessageDraft::set(const Target& target, std::string_view text) {
  const std::uint32_t bound = target.field->string_capacity;
  if (bound != 0 && text.size() > bound) return fmt::format("must have at most {} bytes", bound);
  node(target).texts[target.element] = text;
  return std::nullopt;
}

std::optional<std::string> MessageDraft::set(const Target& target, std::span<const double> values) {
  const FieldDescription& field = *target.field;
  const bool wrong_count = field.shape == Shape::kArray
                               ? values.size() != field.capacity
                               : field.capacity != 0 && values.size() > field.capacity;
  if (wrong_count)
    return fmt::format("'{}' has room for {}, not for {}", field.name, field.capacity, values.size());
  for (const double value : values) {
    if (auto rule = broken_rule(field.kind, value)) return rule;
  }
  node(target).numbers.assign(values.begin(), values.end());
  return std::nullopt;
}

std::optional<std::string> MessageDraft::set(const Target& target, Duration since_epoch) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  std::int64_t seconds = since_epoch.nanoseconds / kSecond;
  std::int64_t rest = since_epoch.nanoseconds % kSecond;
  if (rest < 0) {
    rest += kSecond;
    --seconds;
  }
  if (std::abs(seconds) > std::numeric_limits<std::int32_t>::max()) return "does not fit 32 bits of seconds";
  Node& at = node(target);
  at.children[0].numbers[0] = static_cast<double>(seconds);
  at.children[1].numbers[0] = static_cast<double>(rest);
  return std::nullopt;
}

void MessageDraft::set_stamps(Node& node, Time stamp, bool is_first) {
  if (node.type == nullptr) {
    for (Node& element : node.children) set_stamps(element, stamp, false);
    return;
  }
  const bool is_header = node.type->ros_name == kHeaderType;
  for (Node& child : node.children) {
    const bool first = is_first && &child == &node.children.front();
    if (child.type != nullptr && child.type->ros_name == kTimeType) {
      if (!is_header && !first) continue;
      child.children[0].numbers[0] = static_cast<double>(stamp.nanoseconds / 1'000'000'000);
      child.children[1].numbers[0] = static_cast<double>(stamp.nanoseconds % 1'000'000'000);
    } else {
      set_stamps(child, stamp, false);
    }
  }
}

void MessageDraft::set_stamps(Time stamp) { set_stamps(root_, stamp, true); }

std::span<const double> MessageDraft::numbers(const Target& target) const { return node(target).numbers; }

void MessageDraft::write(std::vector<std::uint8_t>& cdr) const {
  CdrWriter writer(cdr);
  const auto add = [&writer](const auto& self, const Node& node) -> void {
    const bool is_sequence = node.type == nullptr && node.field->shape == Shape::kSequence;
    const std::size_t count = node.numbers.size() + node.texts.size() + node.children.size();
    if (is_sequence) writer.write(static_cast<std::uint32_t>(count));
    for (const Node& child : node.children) self(self, child);
    if (node.type != nullptr) return;  // the numbers of a quaternion are its angles
    for (const double number : node.numbers) write_number(node.field->kind, number, writer);
    for (const std::string& text : node.texts) writer.write(std::string_view(text));
  };
  add(add, root_);
}

}  // namespace bw::imports
