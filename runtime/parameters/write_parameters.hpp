// A parameter struct as YAML that reads back equal: `bandwagon param dump`, run manifests.
#pragma once

#include <cstddef>
#include <string>

#include "runtime/parameters/field_types.hpp"

namespace bw {

/// Any field value as YAML on one line.
std::string flow_text(FieldRef value);

/// The section's fields as a block map, every line indented by `indent` blanks.
std::string to_yaml(FieldRef section, std::size_t indent);

template <HasFields T>
std::string to_yaml(T value, std::size_t indent = 0) {
  return to_yaml(FieldRef::of(value), indent);
}

}  // namespace bw
