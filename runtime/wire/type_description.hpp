// What a message type looks like on the wire, known without DDS and without its generated class. The build
// makes one description per IDL struct (idl/compiler); they are constants and live as long as the program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace bw {

/// Element kinds of the IDL subset in use. `byte` is IDL octet, which ROS 2 keeps apart from uint8.
enum class Kind : std::uint8_t {
  kBoolean,
  kByte,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kMessage,
};

enum class Shape : std::uint8_t { kSingle, kArray, kSequence };

struct TypeDescription;

struct FieldDescription {
  std::string_view name;
  Kind kind = Kind::kBoolean;
  Shape shape = Shape::kSingle;
  std::uint32_t capacity = 0;                ///< array: its length; sequence: its bound, 0 if it has none
  std::uint32_t string_capacity = 0;         ///< bound of a string [bytes, without NUL], 0 if it has none
  const TypeDescription* message = nullptr;  ///< the nested type if kind is kMessage, else null
};

struct TypeDescription {
  std::string_view ros_name;   ///< "nav_msgs/msg/Odometry"
  std::string_view dds_name;   ///< "nav_msgs::msg::dds_::Odometry_"
  std::string_view type_hash;  ///< "RIHS01_" and 64 hexadecimal digits (REP 2011)
  std::span<const FieldDescription> fields;
  std::string_view definition;  ///< as a .msg file has it: constants and fields, nested types as package/Name
};

/// Size of one element on the wire [bytes], which is also its alignment; 0 for strings and messages.
constexpr std::uint32_t wire_size(Kind kind) {
  switch (kind) {
    case Kind::kBoolean:
    case Kind::kByte:
    case Kind::kInt8:
    case Kind::kUint8:
      return 1;
    case Kind::kInt16:
    case Kind::kUint16:
      return 2;
    case Kind::kInt32:
    case Kind::kUint32:
    case Kind::kFloat32:
      return 4;
    case Kind::kInt64:
    case Kind::kUint64:
    case Kind::kFloat64:
      return 8;
    case Kind::kString:
    case Kind::kMessage:
      break;
  }
  return 0;
}

/// ROS 2 cannot express an empty struct: such a message carries this one uint8, which its tools never show.
inline constexpr std::string_view kEmptyMessageMember = "structure_needs_at_least_one_member";

}  // namespace bw
