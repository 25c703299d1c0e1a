#include "idl/compiler/ros2_package.hpp"

#include <algorithm>
#include <set>

#include "idl/compiler/msg_text.hpp"

namespace bw::idl {
namespace {

const std::string kMark = std::string(kRos2PackageMark) + "; changes to this file will be lost.";

/// "msg/Track.msg"
std::string path_of(const Interface& interface) {
  return interface.category + "/" + interface.name + "." + interface.category;
}

std::string interface_text(const File& file) {
  std::string text = comment_lines(file.comment);
  if (!text.empty()) text += "\n";
  bool first = true;
  for (const Struct& type : file.structs) {
    if (type.line == 0) break;  // from here on derived
    text += (first ? "" : "---\n") + msg_text(type, file.constants);
    first = false;
  }
  // Last: what comes first is what `ros2 interface show` and generated documentation begin with.
  return text + "\n# " + kMark + "\n";
}

std::set<std::string> dependencies(const std::vector<File>& files) {
  std::set<std::string> packages;
  for (const File& file : files) {
    for (const Struct& type : file.structs) {
      if (type.line == 0) break;
      for (const Member& member : type.members) {
        if (member.kind == Kind::kMessage)
          packages.insert(member.message.substr(0, member.message.find('/')));
      }
      packages.erase(type.package);
    }
    // ROS 2's generator asks for it where there are actions.
    if (interface_of(file.path).category == "action") packages.insert("action_msgs");
  }
  return packages;
}

std::string package_xml(const std::string& package, const std::string& version,
                        const std::set<std::string>& depends) {
  std::string text = "<?xml version=\"1.0\"?>\n<!-- " + kMark +
                     " -->\n"
                     "<package format=\"3\">\n"
                     "  <name>" +
                     package + "</name>\n  <version>" + version +
                     "</version>\n"
                     "  <description>" +
                     package +
                     " as Bandwagon publishes them.</description>\n"
                     "  <maintainer email=\"maintainers@bandwagon.invalid\">Bandwagon</maintainer>\n"
                     "  <license>Apache-2.0</license>\n\n"
                     "  <buildtool_depend>ament_cmake</buildtool_depend>\n"
                     "  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n\n";
  for (const std::string& name : depends) text += "  <depend>" + name + "</depend>\n";
  return text +
         "  <exec_depend>rosidl_default_runtime</exec_depend>\n\n"
         "  <member_of_group>rosidl_interface_packages</member_of_group>\n\n"
         "  <export>\n    <build_type>ament_cmake</build_type>\n  </export>\n</package>\n";
}

std::string cmake_lists(const std::string& package, const std::vector<File>& files,
                        const std::set<std::string>& depends) {
  std::string text = "# " + kMark + "\ncmake_minimum_required(VERSION 3.8)\nproject(" + package +
                     ")\n\nfind_package(ament_cmake REQUIRED)\n"
                     "find_package(rosidl_default_generators REQUIRED)\n";
  for (const std::string& name : depends) text += "find_package(" + name + " REQUIRED)\n";
  text += "\nrosidl_generate_interfaces(${PROJECT_NAME}\n";
  for (const File& file : files) text += "  \"" + path_of(interface_of(file.path)) + "\"\n";
  if (!depends.empty()) text += "  DEPENDENCIES\n";
  for (const std::string& name : depends) text += "    " + name + "\n";
  return text + ")\n\nament_export_dependencies(rosidl_default_runtime)\nament_package()\n";
}

}  // namespace

std::map<std::string, std::string> ros2_package(const std::vector<File>& files, const std::string& version) {
  std::map<std::string, std::string> package;
  const std::string name = interface_of(files.front().path).package;
  const std::set<std::string> depends = dependencies(files);
  package["package.xml"] = package_xml(name, version, depends);
  package["CMakeLists.txt"] = cmake_lists(name, files, depends);
  for (const File& file : files) package[path_of(interface_of(file.path))] = interface_text(file);
  return package;
}

}  // namespace bw::idl
