// The C++ that the compiler writes. Everything is a pure function of the parsed types.
#pragma once

#include <string>
#include <vector>

#include "idl/compiler/parser.hpp"

namespace bw::idl {

/// "nav_msgs/msg/Odometry.idl" -> "nav_msgs/msg/odometry.hpp", the header name ROS 2 gives a message;
/// "distros/humble/nav2_msgs/action/Spin.idl" -> "humble/nav2_msgs/action/spin.hpp".
[[nodiscard]] std::string header_path(const std::string& idl_path);

/// <package>/<category>/<name>.hpp: the classes, their bw::MessageTraits, and of a service or an action the
/// struct that names its parts.
[[nodiscard]] std::string message_header(const File& file, const Types& types);

/// <package>/wire.cpp, <distro>/<package>/wire.cpp: what the headers of a package declare and what need not
/// be compiled by each of their users.
[[nodiscard]] std::string package_source(const std::vector<File>& files_of_package, const Types& types);

/// type_registry.cpp: all descriptions as constants, and the lists of runtime/wire/type_registry.hpp.
[[nodiscard]] std::string registry_source(const std::vector<File>& files, const Types& types);

/// all_messages.hpp: bw::for_each_message(f) calls f.operator()<M>() for every type. Heavy; for tests.
[[nodiscard]] std::string all_messages_header(const std::vector<File>& files);

}  // namespace bw::idl
