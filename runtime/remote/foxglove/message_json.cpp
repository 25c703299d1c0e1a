#include "runtime/remote/foxglove/message_json.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "runtime/parameters/yaml_file.hpp"
#include "runtime/remote/foxglove/json_bounds.hpp"
#include "runtime/ros/message_from_yaml.hpp"
#include "runtime/wire/cdr_reader.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::foxglove {
namespace {

using Ordered = nlohmann::ordered_json;  // slow with many keys: for what we write
using Json = nlohmann::json;

constexpr const char* kFile = "JSON";

bool is_time(const TypeDescription& type) {
  return type.ros_name == "builtin_interfaces/msg/Time" || type.ros_name == "builtin_interfaces/msg/Duration";
}

/// The tree that messages are made of; as deep as the type, whatever the JSON.
class Tree {
 public:
  ConfigNode of(const TypeDescription& type, const Json& value) {
    ConfigNode node = empty(value);
    if (!value.is_object()) return node;
    for (const auto& [key, member] : value.items()) {
      if (key == "seq" && type.ros_name == "std_msgs/msg/Header") continue;  // ROS 1's
      const std::string name = key == "nsec" && is_time(type) ? "nanosec" : key;
      const auto field = std::ranges::find(type.fields, std::string_view(name), &FieldDescription::name);
      node.map.push_back({.key = name,
                          .where = where_,
                          .value = field == type.fields.end() ? empty(member) : of(*field, member)});
    }
    return node;
  }

 private:
  ConfigNode of(const FieldDescription& field, const Json& value) {
    if (!value.is_array() || field.shape == Shape::kSingle) return element(field, value);
    ConfigNode node = empty(value);
    node.sequence.reserve(value.size());
    for (const Json& one : value) node.sequence.push_back(element(field, one));
    return node;
  }
  ConfigNode element(const FieldDescription& field, const Json& value) {
    return field.message != nullptr && value.is_object() ? of(*field.message, value) : empty(value);
  }
  /// A scalar whole; of a list or an object that it is one.
  ConfigNode empty(const Json& value) const {
    ConfigNode node;
    node.where = where_;
    if (value.is_null()) return node;
    node.kind = value.is_object()  ? ConfigNode::Kind::kMap
                : value.is_array() ? ConfigNode::Kind::kSequence
                                   : ConfigNode::Kind::kScalar;
    if (!node.is_scalar()) return node;
    node.quoted = value.is_string();
    node.scalar = node.quoted ? value.get<std::string>() : value.dump();
    return node;
  }

  const Location where_{.file = kFile};
};

/// Walks a validated message: reads cannot fail.
class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> cdr) : reader_(cdr) { static_cast<void>(reader_.open()); }

  Ordered fields(const TypeDescription& type) {
    Ordered object = Ordered::object();
    for (const FieldDescription& field : type.fields) {
      Ordered value = of(field);
      if (field.name != kEmptyMessageMember) object[std::string(field.name)] = std::move(value);
    }
    return object;
  }

 private:
  Ordered of(const FieldDescription& field) {
    if (field.shape == Shape::kSingle) return element(field);
    const std::uint32_t count =
        field.shape == Shape::kSequence ? take<std::uint32_t>().get<std::uint32_t>() : field.capacity;
    Ordered list = Ordered::array();
    for (std::uint32_t i = 0; i < count; ++i) list.push_back(element(field));
    return list;
  }

  Ordered element(const FieldDescription& field) {
    switch (field.kind) {
      case Kind::kMessage:
        return fields(*field.message);
      case Kind::kBoolean:
        return take<std::uint8_t>() != 0;
      case Kind::kByte:
      case Kind::kUint8:
        return take<std::uint8_t>();
      case Kind::kInt8:
        return take<std::int8_t>();
      case Kind::kInt16:
        return take<std::int16_t>();
      case Kind::kUint16:
        return take<std::uint16_t>();
      case Kind::kInt32:
        return take<std::int32_t>();
      case Kind::kUint32:
        return take<std::uint32_t>();
      case Kind::kInt64:
        return take<std::int64_t>();
      case Kind::kUint64:
        return take<std::uint64_t>();
      case Kind::kFloat32:
        return take<float>();
      case Kind::kFloat64:
        return take<double>();
      case Kind::kString:
        return take<std::string_view>();
    }
    return nullptr;
  }

  template <class T>
  Ordered take() {
    T value{};
    static_cast<void>(reader_.read(value));
    return value;
  }

  CdrReader reader_;
};

}  // namespace

std::vector<std::uint8_t> message_from_json(const TypeDescription& type, std::string_view json) {
  if (const auto broken = broken_bound(json, kMaxYamlDepth, kMaxYamlNodes))
    throw std::runtime_error("a message " + *broken);
  const Json parsed = Json::parse(json, nullptr, false);
  if (!parsed.is_object())
    throw std::runtime_error("a " + std::string(type.ros_name) + " is an object of JSON with its fields");
  return message_from_yaml(type, Tree().of(type, parsed));
}

std::string message_to_json(const TypeDescription& type, std::span<const std::uint8_t> cdr) {
  std::string error;
  if (!validate(type, cdr, &error))
    throw std::runtime_error("no " + std::string(type.ros_name) + ": " + error);
  return Walk(cdr).fields(type).dump(-1, ' ', false, Ordered::error_handler_t::replace);
}

}  // namespace bw::foxglove
