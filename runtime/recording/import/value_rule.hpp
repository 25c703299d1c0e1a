// One entry below `fields` or `constants` of a columns file.
#pragma once

#include <string>
#include <vector>

#include "runtime/parameters/config_node.hpp"
#include "runtime/recording/import/columns_file.hpp"

namespace bw::imports {

/// The value of a field is the name of a column, or a section; that of a constant a text or a number with or
/// without its unit (`-90 deg`), or a section. `key`: of the section it stands in. Adds what it refuses to
/// `violations`.
ValueRule read_value_rule(const ConfigEntry& entry, const std::string& key, bool constant,
                          std::vector<Violation>& violations);

/// "-90 deg" is -90 and deg; the unit is empty when there is none. Nothing for what is no number.
struct Quantity {
  double number = 0.0;
  std::string unit;
};
std::optional<Quantity> quantity_of(const std::string& text);

}  // namespace bw::imports
