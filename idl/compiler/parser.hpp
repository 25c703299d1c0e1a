// Reads the subset of OMG IDL that ROS 2 interfaces need: package and category modules, structs of
// primitives, strings, nested structs, one-dimensional arrays and sequences, and numeric constants in a module
// <Name>_Constants.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// Throws std::runtime_error "<path>:<line>: what" on anything else.
[[nodiscard]] File parse(std::string_view text, const std::string& path);

/// All structs by ROS name.
using Types = std::map<std::string, Struct>;

/// Throws std::runtime_error if a type is defined twice, unknown, contains itself, or is used without its
/// include.
[[nodiscard]] Types link(const std::vector<File>& files);

}  // namespace bw::idl
