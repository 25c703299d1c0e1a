// Which processes have a device open. Those of other users are seen by root alone.
#pragma once

#include <string>
#include <vector>

#include <sys/stat.h>
#include <sys/types.h>

#include "runtime/serial/system_folders.hpp"

namespace bw {

struct PortHolder {
  int pid = 0;
  std::string name;  ///< of the program
};

/// In the order of their ids. `port` is the device's, as stat() has it: a device is one whatever its name, but a
/// pseudo-terminal counts with its file system, since every container numbers its own. `except` is a descriptor of
/// this process that does not count.
std::vector<PortHolder> holders_of(const struct stat& port, int except = -1, const SystemFolders& folders = {});

/// By its major number.
bool is_pseudo_terminal(dev_t device);

/// "process 1234 (minicom)", or all of them.
std::string in_words(const std::vector<PortHolder>& holders);

}  // namespace bw
