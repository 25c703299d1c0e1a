// Graphs, robots, suites and imports by their names, from whatever folder the program was started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/parameters/config_error.hpp"

namespace bw {

struct ConfigFile {
  std::string name;  ///< kobuki, nav2/amcl
  std::filesystem::path path;
};

/// Those of one kind (`graphs`, `robots`, `suites`, `imports`), by name. Each kind has a folder of its own in
/// the user's ($XDG_CONFIG_HOME/bandwagon, else ~/.config/bandwagon), in what was installed with the program,
/// and in the tree that it was built in; the first that has a name wins.
std::vector<ConfigFile> config_files(const std::string& kind);

/// `asked` itself where it ends like a file or there is one of that name (a folder is none), and otherwise the
/// file of that kind and name; nothing where there is none.
std::optional<std::filesystem::path> find_config_file(const std::string& kind,
                                                      const std::filesystem::path& asked);

/// The same. Throws ConfigError, as of `where`, with the names that there are.
std::filesystem::path config_file(const std::string& kind, const std::filesystem::path& asked,
                                  const Location& where = {"command line", 0});

}  // namespace bw
