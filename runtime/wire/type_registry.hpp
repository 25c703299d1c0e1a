// Every message type this program was built with, for the tools that learn a type's name at run time.
// Implemented by the generated library bandwagon_idl.
#pragma once

#include <span>
#include <string_view>

#include "runtime/wire/type_description.hpp"

namespace bw {

/// All types, sorted by ROS name.
[[nodiscard]] std::span<const TypeDescription* const> all_types();

/// By ROS name ("nav_msgs/msg/Odometry") or DDS name ("nav_msgs::msg::dds_::Odometry_"); null if unknown.
[[nodiscard]] const TypeDescription* find_type(std::string_view name);

}  // namespace bw
