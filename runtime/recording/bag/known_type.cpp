#include "runtime/recording/bag/known_type.hpp"

#include <optional>
#include <string>

#include "runtime/recording/bag/ros2msg.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {

namespace {

std::optional<std::string> difference_from(const TypeDescription& type, const BagTopic& topic) {
  return first_difference(parse_ros2msg(topic.type, topic.schema_text),
                          parse_ros2msg(topic.type, schema_text(type)));
}

/// What some recorders write in place of a hash is none.
bool is_hash(const std::string& text) { return text.starts_with("RIHS01_"); }

}  // namespace

KnownType known_type(const BagTopic& topic) {
  const TypeDescription* type = find_type(topic.type);
  if (type == nullptr) return {};
  if (topic.serialization_format != "cdr")
    return {nullptr, "its messages are encoded as " + topic.serialization_format + ", not cdr"};
  if (is_hash(topic.type_hash)) {
    if (const TypeDescription* layout = find_type(topic.type, topic.type_hash)) return {layout, ""};
  }
  if (topic.schema_encoding == "ros2msg" && !topic.schema_text.empty()) {
    const std::optional<std::string> difference = difference_from(*type, topic);
    if (difference && !is_hash(topic.type_hash)) {
      for (const TypeDescription* layout : other_layouts()) {
        if (layout->ros_name == topic.type && !difference_from(*layout, topic)) return {layout, ""};
      }
    }
    if (difference) return {nullptr, *difference};
  }
  if (!is_hash(topic.type_hash)) return {type, ""};
  return {nullptr,
          "its type hash " + topic.type_hash + " is not this build's " + std::string(type->type_hash)};
}

}  // namespace bw::bag
