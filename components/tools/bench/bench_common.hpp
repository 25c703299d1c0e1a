// Timing and statistics of the benches.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace bw {

/// CPU time of this process [ms].
double process_cpu_ms();

/// CPU time of the calling thread [ms].
double thread_cpu_ms();

/// 0 without samples.
double mean(const std::vector<double>& samples);

/// Wilson interval of a success rate at 95 %.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};
Interval wilson95(int successes, int count);

/// Throws std::runtime_error when the file cannot be written. An empty path writes nothing.
void write_json(const std::string& path, const nlohmann::ordered_json& value);

}  // namespace bw
