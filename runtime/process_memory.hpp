// What memory a process holds, and the most that this one ever held. [MB, of 1,000,000 bytes]
#pragma once

#include <fstream>
#include <string>

#include <sys/resource.h>
#include <sys/types.h>

namespace bw {

/// Peak of the resident set; 0 if the system does not say.
inline double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;  // it comes in KiB
}

/// The line `key` of /proc/PROCESS/status, the resident set (VmRSS) or its peak (VmHWM); 0 where there is none.
inline double memory_mb(const std::string& process = "self", const std::string& key = "VmRSS") {
  std::ifstream status("/proc/" + process + "/status");
  for (std::string word; status >> word;) {
    double kib = 0.0;
    if (word == key + ":" && status >> kib) return kib * 1024e-6;
  }
  return 0.0;
}

}  // namespace bw
