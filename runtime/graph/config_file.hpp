// Graphs, robots, suites and imports by their names, from whatever folder the program was started.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/parameters/config_error.hpp"

namespace bw {

/// Where they are looked for, each kind in a folder of its own, the first that has a name wins: the user's
/// ($XDG_CONFIG_HOME/bandwagon, else ~/.config/bandwagon), what was installed with the program, the tree that
/// it was built in. Folders that are not there are left out.
std::vector<std::filesystem::path> config_folders();

struct ConfigFile {
  std::string name;  ///< kobuki, nav2/amcl
  std::filesystem::path path;
};

/// Those of one kind (`graphs`, `robots`, `suites`), by name.
std::vector<ConfigFile> config_files(const std::string& kind);

/// `asked` itself where it ends like a file or there is one of that name, and otherwise the file of that kind
/// and name. Throws ConfigError, as of `where`, with the names that there are.
std::filesystem::path config_file(const std::string& kind, const std::filesystem::path& asked,
                                  const Location& where = {"command line", 0});

}  // namespace bw
