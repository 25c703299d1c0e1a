// Names of nested fields, and the texts that a field may have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/field_ref.hpp"

namespace bw {

/// `path.name`, or `name` at the top.
inline std::string joined(std::string_view path, std::string_view name) {
  return path.empty() ? std::string(name) : std::string(path) + "." + std::string(name);
}

/// Of a choice, of a list of them, or of a text whose field says so; empty: any, or it is no text.
inline std::vector<std::string_view> texts_allowed(const FieldType& type, const Field& field) {
  if (type.kind == FieldKind::list) return texts_allowed(type.element(), field);
  return type.kind == FieldKind::choice ? type.texts() : field.choices.all();
}

}  // namespace bw
