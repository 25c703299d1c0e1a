// bandwagon_idl_compiler ROOT OUT FILE...: reads the IDL files (paths relative to ROOT) and writes C++ below
// OUT. bandwagon_idl_compiler --ros2-package ROOT OUT PACKAGE...: writes packages of ROOT as ROS 2 builds
// them, OUT/PACKAGE.
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "idl/compiler/emit.hpp"
#include "idl/compiler/files.hpp"
#include "idl/compiler/ros2_package.hpp"

namespace bw::idl {
namespace {

/// By their folders below OUT: "nav2_msgs", "humble/nav2_msgs".
using Packages = std::map<std::string, std::vector<File>>;

Packages by_package(const std::vector<File>& files) {
  Packages packages;
  for (const File& file : files) {
    const Interface interface = interface_of(file.path);
    packages[(std::filesystem::path(interface.distro) / interface.package).string()].push_back(file);
  }
  return packages;
}

void compile(const std::filesystem::path& root, const std::filesystem::path& out,
             const std::vector<std::string>& paths) {
  const std::vector<File> files = read_interfaces(root, paths);
  const Types types = link(files);
  for (const File& file : files) write(out / header_path(file.path), message_header(file, types));
  for (const auto& [package, members] : by_package(files))
    write(out / package / "wire.cpp", package_source(members, types));
  write(out / "type_registry.cpp", registry_source(files, types));
  write(out / "all_messages.hpp", all_messages_header(files));
}

void export_packages(const std::filesystem::path& root, const std::filesystem::path& out,
                     const std::vector<std::string>& names) {
  const std::vector<File> files = read_interfaces(root, find_interfaces(root));
  static_cast<void>(link(files));  // refuses what does not fit together
  const Packages packages = by_package(files);
  for (const std::string& name : names) {
    if (!packages.contains(name)) throw std::runtime_error("no package " + name + " in " + root.string());
  }
  for (const std::string& name : names) {
    const auto texts = ros2_package(packages.at(name), BANDWAGON_VERSION);
    write_all(out / name, texts, kRos2PackageMark);
    std::cout << "Wrote " << texts.size() << " files to " << (out / name).string() << "\n";
  }
}

}  // namespace
}  // namespace bw::idl

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool exports = !arguments.empty() && arguments[0] == "--ros2-package";
  if (exports) arguments.erase(arguments.begin());
  if (arguments.size() < 3) {
    std::cerr << "usage: bandwagon_idl_compiler ROOT OUT FILE...\n"
                 "       bandwagon_idl_compiler --ros2-package ROOT OUT PACKAGE...\n";
    return 2;
  }
  try {
    (exports ? bw::idl::export_packages : bw::idl::compile)(arguments[0], arguments[1],
                                                            {arguments.begin() + 2, arguments.end()});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bandwagon_idl_compiler: " << error.what() << "\n";
    return 1;
  }
}
