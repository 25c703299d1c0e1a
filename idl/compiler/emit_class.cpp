#include "idl/compiler/emit_class.hpp"

#include <algorithm>
#include <initializer_list>

#include "idl/compiler/emit.hpp"

namespace bw::idl {
namespace {

std::string cpp_type(Kind kind) {
  constexpr const char* kNames[] = {"bool",         "std::uint8_t",  "std::int8_t",  "std::uint8_t",
                                    "std::int16_t", "std::uint16_t", "std::int32_t", "std::uint32_t",
                                    "std::int64_t", "std::uint64_t", "float",        "double",
                                    "std::string"};
  return kNames[static_cast<int>(kind)];
}

/// As a class of `user` names it. Inside humble::nav2_msgs a name that begins with nav2_msgs would not be the
/// base's.
std::string cpp_name(const Struct& type, const Struct& user) {
  return (user.distro.empty() ? "" : "::") + type.cpp_name();
}

std::string cpp_type(const Member& member, const Struct& user, const Types& types) {
  std::string element =
      member.kind == Kind::kMessage ? cpp_name(nested(types, user, member), user) : cpp_type(member.kind);
  switch (member.shape) {
    case Shape::kArray:
      return "std::array<" + element + ", " + std::to_string(member.capacity) + ">";
    case Shape::kSequence:
      return "std::vector<" + element + ">";
    case Shape::kSingle:
      break;
  }
  return element;
}

bool is_number(const Member& member) { return member.shape == Shape::kSingle && wire_size(member.kind) > 0; }

bool owns_memory(const Struct& type, const Types& types);

bool owns_memory(const Member& member, const Struct& user, const Types& types) {
  return member.shape == Shape::kSequence || member.kind == Kind::kString ||
         (member.kind == Kind::kMessage && owns_memory(nested(types, user, member), types));
}

bool owns_memory(const Struct& type, const Types& types) {
  return std::any_of(type.members.begin(), type.members.end(),
                     [&](const Member& member) { return owns_memory(member, type, types); });
}

/// Whether its setters are compiled once, not by each user: they instantiate the assignment of a vector.
bool has_setters_apart(const Member& member, const Struct& user, const Types& types) {
  return member.shape == Shape::kSequence ||
         (member.kind == Kind::kMessage && owns_memory(member, user, types));
}

std::string accessors(const Member& member, const std::string& type, bool has_setters_apart) {
  const std::string& name = member.name;
  const std::string field = name + "_";
  const std::string refer = "  " + type + "& " + name + "() { return " + field + "; }\n";
  if (is_number(member)) {
    return "  [[nodiscard]] " + type + " " + name + "() const { return " + field + "; }\n" + refer +
           "  void " + name + "(" + type + " to) { " + field + " = to; }\n";
  }
  const std::string readers =
      "  [[nodiscard]] const " + type + "& " + name + "() const { return " + field + "; }\n" + refer;
  if (has_setters_apart) {
    return readers + "  void " + name + "(const " + type + "& to);\n  void " + name + "(" + type +
           "&& to);\n";
  }
  return readers + "  void " + name + "(const " + type + "& to) { " + field + " = to; }\n  void " + name +
         "(" + type + "&& to) { " + field + " = std::move(to); }\n";
}

std::string open_namespace(const Interface& interface) {
  return "\nnamespace " + interface.cpp_scope() + " {\n";
}

/// struct <name> { the ROS name of `interface`, and `using <part> = <interface>_<part>;` of each part.
std::string parts(const std::string& name, const Interface& interface,
                  std::initializer_list<const char*> names) {
  std::string out = "struct " + name + " {\n  static constexpr std::string_view ros_name = \"" +
                    interface.ros_name() + "\";\n";
  for (const char* part : names)
    out.append("  using ")
        .append(part)
        .append(" = ")
        .append(interface.name)
        .append("_")
        .append(part)
        .append(";\n");
  return out;
}

}  // namespace

std::string class_includes(const File& file) {
  std::string out =
      "#include <array>\n#include <cstdint>\n#include <string>\n#include <string_view>\n#include <utility>\n#include <vector>\n\n";
  for (const std::string& include : file.includes) out += "#include \"" + header_path(include) + "\"\n";
  return out;
}

std::string constants_definition(const Constants& constants) {
  std::string out = open_namespace(constants) + "namespace " + constants.name + " {\n";
  for (const Constant& constant : constants.values) {
    out +=
        "inline constexpr " + cpp_type(constant.kind) + " " + constant.name + " = " + constant.value + ";\n";
  }
  return out + "}\n}\n";
}

std::string class_definition(const Struct& type, const Types& types) {
  const std::string& name = type.name;
  std::string out = open_namespace(type) + "\nclass " + name + " {\n public:\n";
  if (owns_memory(type, types)) {
    out += "  " + name + "();\n  ~" + name + "();\n  " + name + "(const " + name + "&);\n  " + name + "(" +
           name + "&&) noexcept;\n  " + name + "& operator=(const " + name + "&);\n  " + name +
           "& operator=(" + name + "&&) noexcept;\n";
  }
  out += "  [[nodiscard]] bool operator==(const " + name + "&) const = default;\n\n";
  std::string visits;
  std::string fields;
  for (const Member& member : type.members) {
    const std::string type_of_member = cpp_type(member, type, types);
    out += accessors(member, type_of_member, has_setters_apart(member, type, types));
    visits += " f(" + member.name + "_);";
    fields += "  " + type_of_member + " " + member.name + "_{};\n";
  }
  for (const char* constness : {"", " const"}) {
    out += std::string("  template <class F>\n  void for_each_field(F&& f)") + constness + " {" + visits +
           " }\n";
  }
  return out + "\n private:\n" + fields + "};\n\n}\n";
}

std::string interface_definition(const Interface& interface) {
  std::string out = open_namespace(interface) + "\n";
  if (interface.category == "srv") {
    out += parts(interface.name, interface, {"Request", "Response", "Event"});
  } else if (interface.category == "action") {
    out += parts(interface.name, interface, {"Goal", "Result", "Feedback", "FeedbackMessage"});
    for (const char* name : {"SendGoal", "GetResult"}) {
      Interface service = interface;
      service.name.append("_").append(name);
      out += parts(name, service, {"Request", "Response", "Event"}) + "};\n";
    }
  } else {
    return "";
  }
  return out + "};\n\n}\n";
}

std::string special_members(const Struct& type, const Types& types) {
  if (!owns_memory(type, types)) return "";
  const std::string& name = type.name;
  const std::string scope = name + "::";
  std::string setters;
  for (const Member& member : type.members) {
    if (!has_setters_apart(member, type, types)) continue;
    const std::string head = "void " + scope + member.name + "(";
    const std::string type_of_member = cpp_type(member, type, types);
    setters += head + "const " + type_of_member + "& to) { " + member.name + "_ = to; }\n" + head +
               type_of_member + "&& to) { " + member.name + "_ = std::move(to); }\n";
  }
  return open_namespace(type) + scope + name + "() = default;\n" + scope + "~" + name + "() = default;\n" +
         scope + name + "(const " + name + "&) = default;\n" + scope + name + "(" + name +
         "&&) noexcept = default;\n" + name + "& " + scope + "operator=(const " + name + "&) = default;\n" +
         name + "& " + scope + "operator=(" + name + "&&) noexcept = default;\n" + setters + "}\n";
}

}  // namespace bw::idl
