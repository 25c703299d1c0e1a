// The leaves of a parameter struct with names, typed values and descriptors.
#pragma once

#include <string>
#include <vector>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/parameter_descriptor.hpp"
#include "runtime/parameters/parameter_value.hpp"

namespace bw {

struct ParameterEntry {
  std::string name;  ///< dotted; elements of a list of structs by index, as walls.0.x
  std::string list;  ///< the outermost list that it is part of, as walls; empty: none
  ParameterValue value;
  ParameterDescriptor descriptor;
};

/// In the order of the field lists. An empty list of structs, or of lists, has none.
std::vector<ParameterEntry> collect_parameters(FieldRef section);

template <HasFields T>
std::vector<ParameterEntry> collect_parameters(T& value) {
  return collect_parameters(FieldRef::of(value));
}

}  // namespace bw
