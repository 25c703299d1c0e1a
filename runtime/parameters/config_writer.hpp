// A parameter struct as the tree it would be read from.
#pragma once

#include "runtime/parameters/config_node.hpp"
#include "runtime/parameters/field_types.hpp"

namespace bw {

/// Reads back equal. Located in kOverrideFile, so that paths are read as they stand.
ConfigNode to_config(FieldRef value);

}  // namespace bw
