// Reads the subset of OMG IDL that ROS 2 interfaces need: package and category modules, structs of
// primitives, strings, nested structs, one-dimensional arrays and sequences, and numeric constants in a
// module <Name>_Constants.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// Throws std::runtime_error "<path>:<line>: what" on anything else.
[[nodiscard]] File parse(std::string_view text, const std::string& path);

/// All structs by Interface::key().
using Types = std::map<std::string, Struct>;

/// What `member`, of kind kMessage, of `user` is: the layout of the user's distribution where that has one of
/// its own, the base's otherwise.
[[nodiscard]] const Struct& nested(const Types& types, const Struct& user, const Member& member);

/// Throws std::runtime_error if a type is defined twice, unknown, contains itself, or is used without its
/// include.
[[nodiscard]] Types link(const std::vector<File>& files);

}  // namespace bw::idl
