// Message definitions as bags carry them (encoding `ros2msg`), read as far as they tell how bytes are laid
// out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw::bag {

struct MsgField {
  std::string type;   ///< float32, or std_msgs/Header; `char` and `byte` are uint8
  std::string array;  ///< empty, [], [9] or [<=9]
  std::string name;
};

/// The fields of a type, without its constants, and of every type that the text brings along.
struct MsgDefinition {
  std::vector<MsgField> fields;
  std::map<std::string, std::vector<MsgField>> contained;  ///< by package/Name
};

/// `type` is the message's name, nav_msgs/msg/Odometry: types named without a package are of its own.
[[nodiscard]] MsgDefinition parse_ros2msg(std::string_view type, std::string_view text);

/// The first field that is not the same in both, in words; nothing when bytes mean the same. A contained type
/// that one of them does not define is taken as equal by its name.
[[nodiscard]] std::optional<std::string> first_difference(const MsgDefinition& bag,
                                                          const MsgDefinition& here);

}  // namespace bw::bag
