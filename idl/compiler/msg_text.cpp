#include "idl/compiler/msg_text.hpp"

#include <algorithm>

namespace bw::idl {
namespace {

std::string msg_type(Kind kind) {
  constexpr const char* kNames[] = {"bool",   "byte",  "int8",   "uint8",   "int16",   "uint16", "int32",
                                    "uint32", "int64", "uint64", "float32", "float64", "string"};
  return kNames[static_cast<int>(kind)];
}

std::string msg_type(const Member& member) {
  std::string type = member.kind == Kind::kMessage ? member.message : msg_type(member.kind);
  if (member.kind == Kind::kMessage) {
    // nav_msgs/msg/Odometry is nav_msgs/Odometry in a .msg file.
    type.erase(type.find('/'), type.rfind('/') - type.find('/'));
  }
  if (member.string_capacity > 0) type += "<=" + std::to_string(member.string_capacity);
  if (member.shape == Shape::kArray) type += "[" + std::to_string(member.capacity) + "]";
  if (member.shape == Shape::kSequence) {
    type += member.capacity > 0 ? "[<=" + std::to_string(member.capacity) + "]" : "[]";
  }
  return type;
}

}  // namespace

std::string comment_lines(const std::string& comment) {
  std::string text;
  for (std::size_t begin = 0; begin < comment.size();) {
    const std::size_t end = comment.find('\n', begin);
    text += "# " + comment.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string msg_text(const Struct& type, const std::vector<Constants>& constants_of_file) {
  std::string text;
  for (const Constants& constants : constants_of_file) {
    if (constants.name != type.name + "_Constants") continue;
    for (const Constant& c : constants.values)
      text += comment_lines(c.comment) + msg_type(c.kind) + " " + c.name + "=" + c.value + "\n";
  }
  for (const Member& member : type.members) {
    if (member.name == kEmptyMessageMember) return text + "# no fields\n";
    text += comment_lines(member.comment) + msg_type(member) + " " + member.name + "\n";
  }
  return text;
}

}  // namespace bw::idl
