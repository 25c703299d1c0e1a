#include "runtime/wire/validate.hpp"

#include <algorithm>
#include <optional>

#include "runtime/wire/cdr_reader.hpp"

namespace bw {
namespace {

struct Fault {
  const TypeDescription* type;
  const FieldDescription* field;
  const char* what;
};

std::optional<Fault> check(const TypeDescription& type, CdrReader& reader);

const char* check_elements(const FieldDescription& field, std::uint32_t count, CdrReader& reader) {
  if (field.kind == Kind::kString) {
    for (std::uint32_t i = 0; i < count; ++i) {
      std::string_view text;
      if (!reader.read(text)) return "string runs past the end or lacks its NUL";
      if (field.string_capacity != 0 && text.size() > field.string_capacity)
        return "string exceeds its bound";
    }
    return nullptr;
  }
  const std::uint8_t* first = nullptr;
  if (!reader.skip(count, wire_size(field.kind), &first)) return "runs past the end";
  if (field.kind == Kind::kBoolean && count != 0 &&
      std::any_of(first, first + count, [](std::uint8_t b) { return b > 1; })) {
    return "boolean is neither 0 nor 1";
  }
  return nullptr;
}

std::optional<Fault> check_field(const TypeDescription& type, const FieldDescription& field,
                                 CdrReader& reader) {
  std::uint32_t count = field.shape == Shape::kArray ? field.capacity : 1;
  if (field.shape == Shape::kSequence) {
    if (!reader.read(count)) return Fault{&type, &field, "runs past the end"};
    if (field.capacity != 0 && count > field.capacity)
      return Fault{&type, &field, "sequence exceeds its bound"};
  }
  if (field.kind != Kind::kMessage) {
    if (const char* what = check_elements(field, count, reader)) return Fault{&type, &field, what};
    return std::nullopt;
  }
  // Every struct has at least one byte on the wire, so an absurd count ends with the bytes.
  for (std::uint32_t i = 0; i < count; ++i) {
    if (auto fault = check(*field.message, reader)) return fault;
  }
  return std::nullopt;
}

std::optional<Fault> check(const TypeDescription& type, CdrReader& reader) {
  for (const FieldDescription& field : type.fields) {
    if (auto fault = check_field(type, field, reader)) return fault;
  }
  return std::nullopt;
}

}  // namespace

bool validate(const TypeDescription& type, std::span<const std::uint8_t> cdr, std::string* error) {
  CdrReader reader(cdr);
  if (!reader.open()) {
    if (error != nullptr)
      *error = std::string(type.ros_name) + ": not plain CDR (encapsulation 00 00 or 00 01)";
    return false;
  }
  const std::optional<Fault> fault = check(type, reader);
  if (fault && error != nullptr) {
    *error = std::string(fault->type->ros_name) + "." + std::string(fault->field->name) + ": " + fault->what +
             " (byte " + std::to_string(reader.offset() + 4) + " of " + std::to_string(cdr.size()) + ")";
  }
  return !fault;
}

std::optional<std::size_t> message_size(const TypeDescription& type, std::span<const std::uint8_t> cdr) {
  CdrReader reader(cdr);
  if (!reader.open() || check(type, reader)) return std::nullopt;
  return reader.offset() + 4;
}

}  // namespace bw
