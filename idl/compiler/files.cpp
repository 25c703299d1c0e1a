#include "idl/compiler/files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "idl/compiler/parser.hpp"

namespace bw::idl {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<File> read_interfaces(const std::filesystem::path& root, std::vector<std::string> paths) {
  std::sort(paths.begin(), paths.end());
  std::vector<File> files;
  for (const std::string& path : paths) files.push_back(parse(read(root / path), path));
  return files;
}

std::vector<std::string> find_interfaces(const std::filesystem::path& root) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string path = entry.path().lexically_relative(root).string();
    if (entry.path().extension() == ".idl" && interface_of(path).distro.empty()) paths.push_back(path);
  }
  return paths;
}

void write(const std::filesystem::path& path, const std::string& text) {
  if (std::filesystem::exists(path) && read(path) == text) return;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_all(const std::filesystem::path& folder, const std::map<std::string, std::string>& texts,
               const std::string& mark) {
  for (const auto& [name, text] : texts) {
    const std::filesystem::path path = folder / name;
    if (std::filesystem::exists(path) && read(path).find(mark) == std::string::npos)
      throw std::runtime_error(path.string() +
                               ": exists and was not written by this program; nothing was written");
  }
  for (const auto& [name, text] : texts) write(folder / name, text);
}

}  // namespace bw::idl
