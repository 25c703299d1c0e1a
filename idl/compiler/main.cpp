// bandwagon_idl_compiler ROOT OUT FILE...: reads the IDL files (paths relative to ROOT) and writes C++ below
// OUT. A file whose text stays the same is left alone, so that its users are not compiled again.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "idl/compiler/emit.hpp"
#include "idl/compiler/parser.hpp"

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& path, const std::string& text) {
  if (std::filesystem::exists(path) && read(path) == text) return;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void compile(const std::filesystem::path& root, const std::filesystem::path& out,
             std::vector<std::string> paths) {
  std::sort(paths.begin(), paths.end());
  std::vector<bw::idl::File> files;
  std::map<std::string, std::vector<bw::idl::File>> packages;
  for (const std::string& path : paths) {
    files.push_back(bw::idl::parse(read(root / path), path));
    packages[path.substr(0, path.find('/'))].push_back(files.back());
  }
  const bw::idl::Types types = bw::idl::link(files);
  for (const bw::idl::File& file : files)
    write(out / bw::idl::header_path(file.path), message_header(file, types));
  for (const auto& [package, members] : packages)
    write(out / package / "wire.cpp", package_source(members, types));
  write(out / "type_registry.cpp", registry_source(files, types));
  write(out / "all_messages.hpp", all_messages_header(files));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: bandwagon_idl_compiler ROOT OUT FILE...\n";
    return 2;
  }
  try {
    compile(argv[1], argv[2], {argv + 3, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bandwagon_idl_compiler: " << error.what() << "\n";
    return 1;
  }
}
