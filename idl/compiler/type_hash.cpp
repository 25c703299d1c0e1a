#include "idl/compiler/type_hash.hpp"

#include <array>
#include <map>
#include <stdexcept>

#include <openssl/sha.h>

namespace bw::idl {
namespace {

/// Ids of type_description_interfaces/msg/FieldType.
int type_id(const Member& member) {
  constexpr int kIds[] = {15, 16, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 17, 1};  // in the order of Kind
  constexpr int kBoundedString = 21;
  constexpr int kArray = 48;
  constexpr int kBoundedSequence = 96;
  constexpr int kUnboundedSequence = 144;
  int id = member.string_capacity != 0 ? kBoundedString : kIds[static_cast<int>(member.kind)];
  if (member.shape == Shape::kArray) id += kArray;
  if (member.shape == Shape::kSequence) id += member.capacity != 0 ? kBoundedSequence : kUnboundedSequence;
  return id;
}

std::string json(const Member& member) {
  return R"({"name": ")" + member.name + R"(", "type": {"type_id": )" + std::to_string(type_id(member)) +
         R"(, "capacity": )" + std::to_string(member.capacity) + R"(, "string_capacity": )" +
         std::to_string(member.string_capacity) + R"(, "nested_type_name": ")" + member.message + R"("}})";
}

std::string json(const Struct& type) {
  std::string fields;
  for (const Member& member : type.members) fields += (fields.empty() ? "" : ", ") + json(member);
  return R"({"type_name": ")" + type.ros_name() + R"(", "fields": [)" + fields + "]}";
}

/// By ROS name.
using Reached = std::map<std::string, const Struct*>;

void collect(const Struct& type, const Types& types, Reached& reached) {
  for (const Member& member : type.members) {
    if (member.kind != Kind::kMessage) continue;
    const Struct& message = nested(types, type, member);
    const auto [before, is_new] = reached.emplace(member.message, &message);
    if (before->second != &message)
      throw std::runtime_error("two layouts of " + member.message + " in one message, one of them by " +
                               type.key());
    if (is_new) collect(message, types, reached);
  }
}

}  // namespace

std::string type_description_json(const Struct& type, const Types& types) {
  Reached reached;
  collect(type, types, reached);
  std::string referenced;
  for (const auto& [name, message] : reached) referenced += (referenced.empty() ? "" : ", ") + json(*message);
  return R"({"type_description": )" + json(type) + R"(, "referenced_type_descriptions": [)" + referenced +
         "]}";
}

std::string type_hash(const Struct& type, const Types& types) {
  const std::string text = type_description_json(type, types);
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  std::string result = "RIHS01_";
  for (const unsigned char byte : digest) {
    result += "0123456789abcdef"[byte >> 4U];
    result += "0123456789abcdef"[byte & 15U];
  }
  return result;
}

}  // namespace bw::idl
