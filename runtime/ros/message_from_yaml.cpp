#include "runtime/ros/message_from_yaml.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/wire/cdr_writer.hpp"
#include "runtime/wire/number_kinds.hpp"

namespace bw {
namespace {

constexpr std::string_view kQuaternion = "geometry_msgs/msg/Quaternion";

class MessageText {
 public:
  explicit MessageText(std::vector<std::uint8_t>& cdr) : writer_(cdr) {}

  /// `text` may be null: nothing is given.
  void write(const TypeDescription& type, const ConfigNode* text, const std::string& path) {
    if (text != nullptr && !text->is_null() && !text->is_map()) {
      refuse(*text, path, fmt::format("must be a map of the fields of {}", type.ros_name));
      text = nullptr;
    }
    if (text != nullptr) refuse_unknown(type, *text, path);
    for (const FieldDescription& field : type.fields) {
      const ConfigNode* value = text == nullptr ? nullptr : text->find(field.name);
      if (value == nullptr && type.ros_name == kQuaternion && field.name == "w") {
        writer_.write(1.0);
      } else {
        write(field, value, joined(path, field.name));
      }
    }
  }
  void throw_if_refused() { throw_if_any(std::move(violations_)); }

 private:
  void refuse(const ConfigNode& node, const std::string& path, std::string rule) {
    violations_.push_back({node.where, path, node.text(), std::move(rule)});
  }

  void refuse_unknown(const TypeDescription& type, const ConfigNode& text, const std::string& path) {
    std::vector<std::string_view> known;
    for (const FieldDescription& field : type.fields) {
      if (field.name != kEmptyMessageMember) known.push_back(field.name);
    }
    for (const ConfigEntry& entry : text.map) {
      if (std::ranges::find(known, std::string_view(entry.key)) == known.end())
        violations_.push_back(
            {entry.where, joined(path, entry.key), "", unknown_rule("field", entry.key, known)});
    }
  }

  void write(const FieldDescription& field, const ConfigNode* value, const std::string& path) {
    if (field.shape == Shape::kSingle) return element(field, value, path);
    if (value != nullptr && !value->is_sequence()) {
      if (!value->is_null()) refuse(*value, path, "must be a list");
      value = nullptr;
    }
    const std::size_t given = value == nullptr ? 0 : value->sequence.size();
    const bool fits = field.shape == Shape::kArray ? value == nullptr || given == field.capacity
                                                   : field.capacity == 0 || given <= field.capacity;
    if (!fits) {
      refuse(*value, path,
             fmt::format("must have {}{} elements, not {}", field.shape == Shape::kArray ? "" : "at most ",
                         field.capacity, given));
    }
    const std::size_t count = field.shape == Shape::kArray ? field.capacity : given;
    if (field.shape == Shape::kSequence) writer_.write(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < count; ++i)
      element(field, i < given ? &value->sequence[i] : nullptr, joined(path, std::to_string(i)));
  }

  void element(const FieldDescription& field, const ConfigNode* value, const std::string& path) {
    if (field.kind == Kind::kMessage) return write(*field.message, value, path);
    if (field.kind == Kind::kString) return writer_.write(text_of(field, value, path));
    if (value == nullptr || value->is_null()) return write_number(field.kind, 0.0, writer_);
    // Whole numbers of 64 bits are more than a double holds.
    const std::optional<std::int64_t> whole =
        value->is_scalar() && !value->quoted ? parse_integer(value->scalar) : std::nullopt;
    if (field.kind == Kind::kInt64 && whole) return writer_.write(*whole);
    if (field.kind == Kind::kUint64 && whole && *whole >= 0)
      return writer_.write(static_cast<std::uint64_t>(*whole));
    const std::optional<double> number = number_of(field.kind, *value);
    std::optional<std::string> rule =
        number ? broken_rule(field.kind, *number)
               : std::optional<std::string>(
                     fmt::format("must be {}", field.kind == Kind::kBoolean ? "true or false" : "a number"));
    if (rule) refuse(*value, path, std::move(*rule));
    write_number(field.kind, rule ? 0.0 : *number, writer_);
  }

  static std::optional<double> number_of(Kind kind, const ConfigNode& value) {
    if (!value.is_scalar() || value.quoted) return std::nullopt;
    if (kind != Kind::kBoolean) return parse_number(value.scalar);
    const std::optional<bool> truth = parse_bool(value.scalar);
    return truth ? std::optional(*truth ? 1.0 : 0.0) : std::nullopt;
  }

  std::string_view text_of(const FieldDescription& field, const ConfigNode* value, const std::string& path) {
    if (value == nullptr || value->is_null()) return {};
    if (!value->is_scalar()) {
      refuse(*value, path, "must be a text");
      return {};
    }
    if (field.string_capacity > 0 && value->scalar.size() > field.string_capacity)
      refuse(*value, path, fmt::format("must have at most {} bytes", field.string_capacity));
    return value->scalar;
  }

  CdrWriter writer_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<std::uint8_t> message_from_yaml(const TypeDescription& type, const ConfigNode& text) {
  std::vector<std::uint8_t> cdr;
  MessageText message(cdr);
  message.write(type, &text, "");
  message.throw_if_refused();
  return cdr;
}

}  // namespace bw
