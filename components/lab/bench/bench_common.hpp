// Timing and statistics of the benches.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/comparison/rate_interval.hpp"

namespace bw {

/// CPU time of this process [ms].
double process_cpu_ms();

/// CPU time of the calling thread [ms].
double thread_cpu_ms();

/// 0 without samples.
double mean(const std::vector<double>& samples);

/// Throws std::runtime_error when the file cannot be written. An empty path writes nothing.
void write_json(const std::string& path, const nlohmann::ordered_json& value);

}  // namespace bw
