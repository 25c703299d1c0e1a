#include "runtime/graph/config_file.hpp"

#include <cstdlib>
#include <map>
#include <string_view>

#include "runtime/parameters/nearest.hpp"

namespace bw {
namespace fs = std::filesystem;

namespace {

/// What the XDG base directory specification ignores is ignored: a path that is not absolute.
fs::path users_folder() {
  const auto folder = [](const char* variable) {
    const char* text = std::getenv(variable);
    const fs::path path = text == nullptr ? "" : text;
    return path.is_absolute() ? path : fs::path();
  };
  if (const fs::path config = folder("XDG_CONFIG_HOME"); !config.empty()) return config / "bandwagon";
  const fs::path home = folder("HOME");
  return home.empty() ? fs::path() : home / ".config" / "bandwagon";
}

}  // namespace

std::vector<fs::path> config_folders() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<fs::path> folders;
  for (const fs::path& folder :
       {users_folder(), program / "../share/bandwagon/config", program / "../../../config"}) {
    if (!folder.empty() && fs::is_directory(folder, error)) folders.push_back(fs::weakly_canonical(folder));
  }
  return folders;
}

std::vector<ConfigFile> config_files(const std::string& kind) {
  std::map<std::string, fs::path> found;
  for (const fs::path& folder : config_folders()) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder / kind, error)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".yaml")
        found.emplace(path.lexically_relative(folder / kind).replace_extension().string(), path);
    }
  }
  std::vector<ConfigFile> files;
  for (const auto& [name, path] : found) files.push_back({name, path});
  return files;
}

fs::path config_file(const std::string& kind, const fs::path& asked, const Location& where) {
  if (asked.has_extension() || fs::exists(asked)) return asked;
  std::vector<std::string> names;
  for (const ConfigFile& file : config_files(kind)) {
    if (file.name == asked) return file.path;
    names.push_back(file.name);
  }
  const std::string what = kind.substr(0, kind.size() - 1);  // graphs: a graph
  throw ConfigError(Violation{where, what, asked.string(),
                              unknown_rule(what, asked.string(), {names.begin(), names.end()})});
}

}  // namespace bw
