// The most memory that this process ever held.
#pragma once

#include <sys/resource.h>

namespace bw {

/// Peak of the resident set [MB, of 1,000,000 bytes]; 0 if the system does not say.
inline double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;  // it comes in KiB
}

}  // namespace bw
