// Which processes have a device open. Those of other users are seen by root alone.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "runtime/serial/system_folders.hpp"

namespace bw {

struct PortHolder {
  int pid = 0;
  std::string name;  ///< of the program
};

/// In the order of their ids. `except` is a descriptor of this process that does not count.
std::vector<PortHolder> holders_of(dev_t device, int except = -1, const SystemFolders& folders = {});

/// "process 1234 (minicom)", or all of them.
std::string in_words(const std::vector<PortHolder>& holders);

}  // namespace bw
