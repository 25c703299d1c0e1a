// Every message type this program was built with, for the tools that learn a type's name at run time.
// Implemented by the generated library bandwagon_idl.
#pragma once

#include <span>
#include <string_view>

#include "runtime/base/ros_distro.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw {

/// All types, each as Jazzy has it, sorted by ROS name.
[[nodiscard]] std::span<const TypeDescription* const> all_types();

/// What other distributions have under names of all_types() with other fields, sorted by distribution and ROS
/// name.
[[nodiscard]] std::span<const TypeDescription* const> other_layouts();
/// Whose each of them is.
[[nodiscard]] std::span<const RosDistro> distros_of_other_layouts();

/// By ROS name ("nav_msgs/msg/Odometry") or DDS name ("nav_msgs::msg::dds_::Odometry_"), of all_types(); null
/// if unknown.
[[nodiscard]] const TypeDescription* find_type(std::string_view name);

/// The layout under this name that has this hash, of all_types() or of other_layouts(); null if none has. An
/// empty hash, as Humble leaves it, asks for nothing: find_type(name).
[[nodiscard]] const TypeDescription* find_type(std::string_view name, std::string_view type_hash);

/// The layout under this name in a distribution; `automatic` is Jazzy's. Null if the name is unknown.
[[nodiscard]] const TypeDescription* find_type(std::string_view name, RosDistro distro);

}  // namespace bw
