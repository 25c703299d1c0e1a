// What a process holds while it runs for hours, and whether it grows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace bw {

struct ProcessSample {
  double t = 0.0;       ///< [s] of the run
  double rss = 0.0;     ///< resident memory [MB, of 1,000,000 bytes]
  int descriptors = 0;  ///< open ones
  int threads = 0;
};

/// Of /proc; nothing where there is no such process, or it is not ours to look at.
std::optional<ProcessSample> sample_process(pid_t process, double t);

/// [MB/h] of resident memory by least squares over the samples from `warm` [s] on; 0 with fewer than two.
double growth(const std::vector<ProcessSample>& samples, double warm);

/// The most less the least, from `warm` [s] on.
struct Spread {
  int descriptors = 0;
  int threads = 0;
};
Spread spread(const std::vector<ProcessSample>& samples, double warm);

}  // namespace bw
