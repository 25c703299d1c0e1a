// What Fast DDS has in shared memory, of one process or one domain: others on this machine have theirs in the
// same folder.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <sys/types.h>

namespace bw::test {

/// Of what the process maps and holds open, the parts in shared memory: a line each. Fast DDS maps its
/// segments and ports, and keeps their locks open, for as long as a participant lives.
inline std::string in_shared_memory(pid_t process) {
  const std::filesystem::path proc = "/proc/" + std::to_string(process);
  std::string found;
  std::ifstream maps(proc / "maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find("/dev/shm/") != std::string::npos) found += line + "\n";
  }
  for (const auto& entry : std::filesystem::directory_iterator(proc / "fd")) {
    std::error_code gone;
    const std::string target = std::filesystem::read_symlink(entry, gone).string();
    if (target.starts_with("/dev/shm/")) found += target + "\n";
  }
  return found;
}

/// Fast DDS's files for the ports of a domain, a line each: fastrtps_port32410, sem.fastrtps_port32410_mutex;
/// fastdds_port32410 from version 3 on. Their owners may be gone.
inline std::string shared_ports_of(int domain) {
  std::string found;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) {
    const std::string name = entry.path().filename();
    for (const std::string mark : {"fastrtps_port", "fastdds_port"}) {
      const std::size_t begin = name.find(mark);
      if (begin != std::string::npos &&
          (std::atoi(name.c_str() + begin + mark.size()) - 7400) / 250 == domain)
        found += name + "\n";
    }
  }
  return found;
}

}  // namespace bw::test
