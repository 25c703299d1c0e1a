#include "runtime/ros/type_description_messages.hpp"

#include <array>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

using type_description_interfaces::msg::IndividualTypeDescription;
using type_description_interfaces::msg::TypeSource;
using Description = type_description_interfaces::msg::TypeDescription;

/// By name, which is the order that the hash asks for.
using Referenced = std::map<std::string, IndividualTypeDescription>;

/// Constants of type_description_interfaces/msg/FieldType.
std::uint8_t type_id(const FieldDescription& field) {
  constexpr std::array<int, 14> kIds = {15, 16, 2, 3,  4,  5,  6,
                                        7,  8,  9, 10, 11, 17, 1};  // in the order of Kind
  constexpr int kBoundedString = 21, kArray = 48, kBoundedSequence = 96, kUnboundedSequence = 144;
  int id = field.string_capacity != 0 ? kBoundedString : kIds.at(static_cast<std::size_t>(field.kind));
  if (field.shape == Shape::kArray) id += kArray;
  if (field.shape == Shape::kSequence) id += field.capacity != 0 ? kBoundedSequence : kUnboundedSequence;
  return static_cast<std::uint8_t>(id);
}

IndividualTypeDescription alone(const TypeDescription& type) {
  IndividualTypeDescription result;
  result.type_name(std::string(type.ros_name));
  for (const FieldDescription& field : type.fields) {
    auto& f = result.fields().emplace_back();
    f.name(std::string(field.name));
    f.type().type_id(type_id(field));
    f.type().capacity(field.capacity);
    f.type().string_capacity(field.string_capacity);
    if (field.message != nullptr) f.type().nested_type_name(std::string(field.message->ros_name));
  }
  return result;
}

void collect(const TypeDescription& type, Referenced& referenced) {
  for (const FieldDescription& field : type.fields) {
    if (field.message == nullptr) continue;
    const auto [entry, is_new] = referenced.emplace(field.message->ros_name, IndividualTypeDescription{});
    if (!is_new) continue;
    entry->second = alone(*field.message);
    collect(*field.message, referenced);
  }
}

Description whole(IndividualTypeDescription type, Referenced& referenced) {
  Description result;
  result.type_description(std::move(type));
  for (auto& [name, one] : referenced) result.referenced_type_descriptions().push_back(std::move(one));
  return result;
}

/// The text of which REP 2011 takes the hash; default values are no part of it.
std::string json(const IndividualTypeDescription& type) {
  std::string fields;
  for (const auto& field : type.fields()) {
    fields += fmt::format(
        R"({}{{"name": "{}", "type": {{"type_id": {}, "capacity": {}, "string_capacity": {}, "nested_type_name": "{}"}}}})",
        fields.empty() ? "" : ", ", field.name(), field.type().type_id(), field.type().capacity(),
        field.type().string_capacity(), field.type().nested_type_name());
  }
  return fmt::format(R"({{"type_name": "{}", "fields": [{}]}})", type.type_name(), fields);
}

TypeSource source_of(const IndividualTypeDescription& type) {
  TypeSource source;
  source.type_name(type.type_name());
  const TypeDescription* known = find_type(type.type_name());
  const bool has_file = known != nullptr && type.type_name().find("/msg/") != std::string::npos;
  source.encoding(has_file ? "msg" : "implicit");
  if (has_file) source.raw_file_contents(std::string(known->definition));
  return source;
}

}  // namespace

Description to_message(const TypeDescription& type) {
  Referenced referenced;
  collect(type, referenced);
  return whole(alone(type), referenced);
}

Description join_parts(std::string_view ros_name,
                       const std::vector<std::pair<std::string, Description>>& parts) {
  constexpr std::uint8_t kNestedType = 1;
  IndividualTypeDescription joined;
  joined.type_name(std::string(ros_name));
  Referenced referenced;
  for (const auto& [name, part] : parts) {
    auto& field = joined.fields().emplace_back();
    field.name(name);
    field.type().type_id(kNestedType);
    field.type().nested_type_name(part.type_description().type_name());
    referenced[part.type_description().type_name()] = part.type_description();
    for (const IndividualTypeDescription& one : part.referenced_type_descriptions())
      referenced[one.type_name()] = one;
  }
  return whole(std::move(joined), referenced);
}

std::string type_hash_of(const Description& description) {
  std::string referenced;
  for (const IndividualTypeDescription& type : description.referenced_type_descriptions())
    referenced += (referenced.empty() ? "" : ", ") + json(type);
  const std::string text = fmt::format(R"({{"type_description": {}, "referenced_type_descriptions": [{}]}})",
                                       json(description.type_description()), referenced);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL offers no SHA-256");
  std::string hash = "RIHS01_";
  for (unsigned int i = 0; i < length; ++i) hash += fmt::format("{:02x}", digest.at(i));
  return hash;
}

std::vector<TypeSource> sources_of(const Description& description) {
  std::vector<TypeSource> sources{source_of(description.type_description())};
  for (const IndividualTypeDescription& type : description.referenced_type_descriptions())
    sources.push_back(source_of(type));
  return sources;
}

}  // namespace bw
