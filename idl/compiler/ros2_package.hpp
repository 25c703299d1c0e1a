// One of our packages in the form that ROS 2 builds with colcon.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// Every file of a package carries it.
inline constexpr const char* kRos2PackageMark = "Written by Bandwagon's export_ros2_messages.sh";

/// package.xml, CMakeLists.txt, and .msg, .srv and .action files with the comments of the IDL: text by path
/// below the package's folder. It depends on the packages of the types that its own refer to. `files` are all
/// of one package.
[[nodiscard]] std::map<std::string, std::string> ros2_package(const std::vector<File>& files,
                                                              const std::string& version);

}  // namespace bw::idl
