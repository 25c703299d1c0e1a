// A parameter struct as rows for people: `bandwagon param list`, the web panel, the documentation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/field_types.hpp"

namespace bw {

struct ParameterRow {
  std::string name;           ///< dotted; elements of a list of structs by index, as walls.0.x
  std::string type;           ///< bool, integer, double, string (choices too); a list: "double list"
  std::string value;          ///< as YAML
  std::string default_value;  ///< as YAML; empty for list elements that the defaults do not have
  std::string unit;
  double min;
  double max;
  std::vector<std::string> choices;
  bool first;  ///< among the few that people turn first
  std::string doc;
};

/// In the order of the field lists; `defaults` is of the same type.
std::vector<ParameterRow> list_parameters(FieldRef section, FieldRef defaults, std::string_view prefix);

template <HasFields T>
std::vector<ParameterRow> list_parameters(T& value, std::string_view prefix = "") {
  T defaults{};
  return list_parameters(FieldRef::of(value), FieldRef::of(defaults), prefix);
}

/// Every name that can be set, dotted, in the order of the field lists; those of a list of structs once,
/// without index, as walls.x. `section` holds anything afterwards.
std::vector<std::string> parameter_names(FieldRef section);

}  // namespace bw
