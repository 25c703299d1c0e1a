// Types as type_description_interfaces has them on the wire: what GetTypeDescription answers with, and the
// hash (REP 2011) by which it is asked for.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <type_description_interfaces/msg/type_description.hpp>
#include <type_description_interfaces/msg/type_source.hpp>

#include "runtime/wire/type_description.hpp"

namespace bw {

type_description_interfaces::msg::TypeDescription to_message(const TypeDescription& type);

/// A service or an action, which has no bytes of its own: its parts by their field names, each with all that
/// it refers to.
type_description_interfaces::msg::TypeDescription join_parts(
    std::string_view ros_name,
    const std::vector<std::pair<std::string, type_description_interfaces::msg::TypeDescription>>& parts);

/// "RIHS01_" and 64 hexadecimal digits. Throws std::runtime_error when OpenSSL offers no SHA-256.
std::string type_hash_of(const type_description_interfaces::msg::TypeDescription& description);

/// Of the described type and of all that it refers to: for a message the fields and constants of its .msg
/// file, without the comments; a part of a service or an action is `implicit`, as rosidl calls what has no
/// file of its own, and its text is empty.
std::vector<type_description_interfaces::msg::TypeSource> sources_of(
    const type_description_interfaces::msg::TypeDescription& description);

}  // namespace bw
