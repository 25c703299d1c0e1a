// A robot that drives to and fro among people for hours while something fails each half minute: a day in virtual time with
// the graph's faults, or in real time with its processes killed, stopped, spinning and leaking.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace bw {

struct SoakOptions {
  std::string faults = "senses";  ///< of the graph, in virtual time
  double hours = 24.0;
  std::uint64_t seed = 1;
  bool is_real = false;  ///< real time, and processes that fail
  std::filesystem::path out = "soak";
};

/// Prints a line each hour (each ten minutes in real time) and a summary; writes all samples to `out`. True: no contact that
/// the robot caused, no growth, nothing ended that was not made to. Throws ConfigError or std::runtime_error.
bool soak(const SoakOptions& options);

}  // namespace bw
