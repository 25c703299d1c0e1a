// What ROS 2 lets a name be (rosidl_adapter and rosidl_parser refuse the rest, and so do we).
#pragma once

#include <string_view>

namespace bw::idl {

/// nav_msgs, angle_min: small letters, digits and single underscores.
[[nodiscard]] bool is_field_name(std::string_view name);

/// Odometry, Point32: a capital, then letters and digits.
[[nodiscard]] bool is_type_name(std::string_view name);

/// RESULT_SUCCESS: capitals, digits and single underscores.
[[nodiscard]] bool is_constant_name(std::string_view name);

}  // namespace bw::idl
