// The C++ class of a message: accessors as eProsima's generator names them (`message.header()` reads and
// refers, `message.header(value)` sets), equality, and for_each_field() for whoever walks the fields in the
// order of the wire.
#pragma once

#include <string>

#include "idl/compiler/parser.hpp"

namespace bw::idl {

/// The #include lines that the classes of `file` need.
[[nodiscard]] std::string class_includes(const File& file);

[[nodiscard]] std::string constants_definition(const Constants& constants);

[[nodiscard]] std::string class_definition(const Struct& type, const Types& types);

/// struct GetState { using Request = GetState_Request; ... }; likewise of an action. Empty for a message.
[[nodiscard]] std::string interface_definition(const Interface& interface);

/// Constructors, destructor, assignments, and setters of what owns memory: compiled once, not by each user.
/// Empty for a class of numbers alone, whose own are trivial.
[[nodiscard]] std::string special_members(const Struct& type, const Types& types);

}  // namespace bw::idl
