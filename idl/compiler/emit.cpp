#include "idl/compiler/emit.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "idl/compiler/emit_class.hpp"
#include "idl/compiler/msg_text.hpp"
#include "idl/compiler/type_hash.hpp"

namespace bw::idl {
namespace {

constexpr const char* kBanner = "// Generated from the IDL files by idl/compiler.\n";

std::string include(const std::string& path) { return "#include \"" + path + "\"\n"; }

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string traits(const Struct& type) { return "MessageTraits<" + type.cpp_name() + ">"; }

/// The constant that describes a type: k_nav_msgs_msg_Odometry.
std::string constant(const Struct& type) {
  std::string name = type.key();
  for (char& c : name) c = c == '/' ? '_' : c;
  return "k_" + name;
}

std::string enumerator(Kind kind) {
  constexpr const char* kNames[] = {"kBoolean", "kByte",    "kInt8",   "kUint8",  "kInt16",
                                    "kUint16",  "kInt32",   "kUint32", "kInt64",  "kUint64",
                                    "kFloat32", "kFloat64", "kString", "kMessage"};
  return std::string("Kind::") + kNames[static_cast<int>(kind)];
}

std::string enumerator(Shape shape) {
  constexpr const char* kNames[] = {"kSingle", "kArray", "kSequence"};
  return std::string("Shape::") + kNames[static_cast<int>(shape)];
}

/// .msg texts by key.
std::map<std::string, std::string> definitions(const std::vector<File>& files) {
  std::map<std::string, std::string> texts;
  for (const File& file : files) {
    for (const Struct& type : file.structs) texts[type.key()] = msg_text(type, file.constants);
  }
  return texts;
}

/// A description after those of the types it contains.
void describe(const Struct& type, const Types& types, const std::map<std::string, std::string>& texts,
              std::set<std::string>& done, std::string& out) {
  if (!done.insert(type.key()).second) return;
  for (const Member& member : type.members) {
    if (member.kind == Kind::kMessage) describe(nested(types, type, member), types, texts, done, out);
  }
  const std::string name = constant(type);
  out += "constexpr FieldDescription " + name + "_fields[] = {\n";
  for (const Member& member : type.members) {
    out += "    {" + quoted(member.name) + ", " + enumerator(member.kind) + ", " + enumerator(member.shape) +
           ", " + std::to_string(member.capacity) + ", " + std::to_string(member.string_capacity) + ", " +
           (member.kind == Kind::kMessage ? "&" + constant(nested(types, type, member)) : "nullptr") + "},\n";
  }
  out += "};\nconstexpr TypeDescription " + name + "{" + traits(type) + "::ros_name, " + traits(type) +
         "::dds_name,\n    " + traits(type) + "::type_hash, " + name + "_fields,\n    R\"msg(" +
         texts.at(type.key()) + ")msg\"};\n";
}

}  // namespace

std::string header_path(const std::string& idl_path) {
  constexpr std::string_view kDistros = "distros/";
  const std::size_t folder = idl_path.starts_with(kDistros) ? kDistros.size() : 0;
  const std::size_t begin = idl_path.rfind('/') + 1;
  const std::string name = idl_path.substr(begin, idl_path.rfind('.') - begin);
  const auto upper = [&](std::size_t i) { return std::isupper(static_cast<unsigned char>(name[i])) != 0; };
  const auto lower = [&](std::size_t i) {
    return i < name.size() && std::islower(static_cast<unsigned char>(name[i])) != 0;
  };
  // A word begins at a capital that follows a small letter or digit, or that a small letter follows:
  // TFMessage is tf_message.
  std::string snake;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && upper(i) && (!upper(i - 1) || lower(i + 1))) snake += '_';
    snake += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return idl_path.substr(folder, begin - folder) + snake + ".hpp";
}

std::string message_header(const File& file, const Types& types) {
  std::string out = std::string(kBanner) + "#pragma once\n\n" + class_includes(file) +
                    include("runtime/wire/serialization.hpp");
  for (const Constants& constants : file.constants) out += constants_definition(constants);
  for (const Struct& type : file.structs) out += class_definition(type, types);
  out += interface_definition(interface_of(file.path)) + "\nnamespace bw {\n";
  for (const Struct& type : file.structs) {
    out += "\ntemplate <>\nstruct " + traits(type) + " {\n  using Message = " + type.cpp_name() +
           ";\n  static constexpr std::string_view ros_name = " + quoted(type.ros_name()) +
           ";\n  static constexpr std::string_view dds_name = " + quoted(type.dds_name()) +
           ";\n  static constexpr std::string_view type_hash =\n      " + quoted(type_hash(type, types)) +
           ";\n  static const TypeDescription& description();\n"
           "  static void serialize(const Message& message, std::vector<std::uint8_t>& bytes);\n"
           "  static bool deserialize(std::span<const std::uint8_t> bytes, Message& message, std::string* "
           "reason);\n"
           "};\n";
  }
  return out + "\n}  // namespace bw\n";
}

std::string package_source(const std::vector<File>& files_of_package, const Types& types) {
  std::string out = kBanner;
  for (const File& file : files_of_package) out += include(header_path(file.path));
  out += include("idl/fast_cdr.hpp");
  for (const File& file : files_of_package) {
    for (const Struct& type : file.structs) out += special_members(type, types);
  }
  out += "\nnamespace bw {\n";
  for (const File& file : files_of_package) {
    for (const Struct& type : file.structs) {
      out += "\nvoid " + traits(type) +
             "::serialize(const Message& message, std::vector<std::uint8_t>& bytes) {\n"
             "  fast_cdr::serialize(message, bytes);\n}\nbool " +
             traits(type) +
             "::deserialize(std::span<const std::uint8_t> bytes, Message& message, std::string* reason) {\n"
             "  return fast_cdr::deserialize(description(), bytes, message, reason);\n}\n";
    }
  }
  return out + "\n}  // namespace bw\n";
}

std::string registry_source(const std::vector<File>& files, const Types& types) {
  std::string out = kBanner;
  for (const File& file : files) out += include(header_path(file.path));
  out += include("runtime/wire/type_registry.hpp") + "\nnamespace bw {\nnamespace {\n\n";
  std::set<std::string> done;
  const std::map<std::string, std::string> texts = definitions(files);
  for (const auto& [name, type] : types) describe(type, types, texts, done, out);
  for (const bool is_base : {true, false}) {
    out += std::string("\nconstexpr std::array<const TypeDescription*, ") +
           std::to_string(
               std::count_if(types.begin(), types.end(),
                             [&](const auto& entry) { return entry.second.distro.empty() == is_base; })) +
           (is_base ? "> kAllTypes = {\n" : "> kOtherLayouts = {\n");
    for (const auto& [name, type] : types) {
      if (type.distro.empty() == is_base) out += "    &" + constant(type) + ",\n";
    }
    out += "};\n";
  }
  out += "constexpr std::array<RosDistro, kOtherLayouts.size()> kOtherDistros = {\n";
  for (const auto& [name, type] : types) {
    if (!type.distro.empty()) out += "    RosDistro::" + type.distro + ",\n";
  }
  out += "};\n\n}  // namespace\n\n";
  for (const auto& [name, type] : types) {
    out += "const TypeDescription& " + traits(type) + "::description() { return " + constant(type) + "; }\n";
  }
  return out +
         "\nstd::span<const TypeDescription* const> all_types() { return kAllTypes; }\n"
         "std::span<const TypeDescription* const> other_layouts() { return kOtherLayouts; }\n"
         "std::span<const RosDistro> distros_of_other_layouts() { return kOtherDistros; }\n\n"
         "}  // namespace bw\n";
}

std::string all_messages_header(const std::vector<File>& files) {
  std::string out = std::string(kBanner) + "#pragma once\n\n";
  for (const File& file : files) out += include(header_path(file.path));
  out += "\nnamespace bw {\n\ntemplate <class F>\nvoid for_each_message(F&& f) {\n";
  for (const File& file : files) {
    for (const Struct& type : file.structs) out += "  f.template operator()<" + type.cpp_name() + ">();\n";
  }
  return out + "}\n\n}  // namespace bw\n";
}

}  // namespace bw::idl
