#include "runtime/graph/config_file.hpp"

#include <map>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/own_program.hpp"
#include "runtime/parameters/xdg_folder.hpp"

namespace bw {
namespace fs = std::filesystem;

namespace {

/// The first that has a name wins.
std::vector<fs::path> config_folders() {
  std::error_code error;
  const fs::path program = own_program().parent_path();
  std::vector<fs::path> folders;
  for (const fs::path& folder : {xdg_folder("XDG_CONFIG_HOME", ".config"),
                                 program / "../share/bandwagon/config", program / "../../../config"}) {
    if (!folder.empty() && fs::is_directory(folder, error)) folders.push_back(fs::weakly_canonical(folder));
  }
  return folders;
}

}  // namespace

std::vector<ConfigFile> config_files(const std::string& kind) {
  std::map<std::string, fs::path> found;
  for (const fs::path& folder : config_folders()) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(
             folder / kind, fs::directory_options::skip_permission_denied, error)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".yaml" && !entry.is_directory(error))
        found.emplace(path.lexically_relative(folder / kind).replace_extension().string(), path);
    }
  }
  std::vector<ConfigFile> files;
  for (const auto& [name, path] : found) files.push_back({name, path});
  return files;
}

std::optional<fs::path> find_config_file(const std::string& kind, const fs::path& asked) {
  if (asked.has_extension() || (fs::exists(asked) && !fs::is_directory(asked))) return asked;
  for (const ConfigFile& file : config_files(kind)) {
    if (file.name == asked) return file.path;
  }
  return std::nullopt;
}

fs::path config_file(const std::string& kind, const fs::path& asked, const Location& where) {
  if (auto found = find_config_file(kind, asked)) return *std::move(found);
  const std::vector<ConfigFile> files = config_files(kind);
  std::vector<std::string_view> names;
  for (const ConfigFile& file : files) names.push_back(file.name);
  const std::string what = kind.substr(0, kind.size() - 1);  // graphs: a graph
  throw ConfigError(Violation{where, what, asked.string(), unknown_rule(what, asked.string(), names)});
}

}  // namespace bw
