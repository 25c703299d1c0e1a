// What the compiler knows of an IDL file: its structs, in the kinds the wire knows
// (runtime/wire/type_description.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/wire/type_description.hpp"

namespace bw::idl {

struct Member {
  std::string name;
  Kind kind = Kind::kBoolean;
  Shape shape = Shape::kSingle;
  std::uint32_t capacity = 0;
  std::uint32_t string_capacity = 0;
  std::string message;  ///< ROS name of the nested type if kind is kMessage
  std::string comment;  ///< what stands above it, line by line
};

/// What a file is named after: a message, a service or an action.
struct Interface {
  std::string package;   ///< "nav_msgs"
  std::string category;  ///< "msg", "srv" or "action"
  std::string name;      ///< "Odometry"
  std::string distro;    ///< "humble": the layout under this name in that distribution; empty: the base's

  [[nodiscard]] std::string ros_name() const { return package + "/" + category + "/" + name; }
  [[nodiscard]] std::string cpp_name() const { return cpp_scope() + "::" + name; }
  [[nodiscard]] std::string cpp_scope() const {
    return (distro.empty() ? "" : distro + "::") + package + "::" + category;
  }
  /// "nav_msgs/msg/Odometry", "humble/nav2_msgs/action/Spin": unlike the ROS name, of one layout alone.
  [[nodiscard]] std::string key() const { return (distro.empty() ? "" : distro + "/") + ros_name(); }
};

/// "nav_msgs/msg/Odometry.idl", "distros/humble/nav2_msgs/action/Spin.idl" -> its parts; those that a path
/// does not have are empty.
[[nodiscard]] Interface interface_of(const std::string& path);

struct Struct : Interface {
  std::vector<Member> members;
  int line = 0;  ///< where its file defines it; 0: derived

  [[nodiscard]] std::string dds_name() const { return package + "::" + category + "::dds_::" + name + "_"; }
};

struct Constant {
  Kind kind = Kind::kInt32;
  std::string name;
  std::string value;  ///< as written, sign included
  std::string comment;
};

/// module <Name>_Constants. Constants do not travel: they exist in C++ alone.
struct Constants : Interface {  // its name: "Marker_Constants"
  std::vector<Constant> values;
  int line = 0;
};

/// One IDL file. Includes and the file's own path are relative to the root of the interfaces.
struct File {
  std::string path;  ///< "nav_msgs/msg/Odometry.idl"
  std::vector<std::string> includes;
  std::vector<Struct> structs;
  std::vector<Constants> constants;
  std::string comment;  ///< at its head
  int lines = 0;
};

}  // namespace bw::idl
