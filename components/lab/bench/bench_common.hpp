// Timing and statistics of the benches.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/comparison/rate_interval.hpp"

namespace bw {

/// CPU time so far [ms].
using CpuClock = std::function<double()>;

/// CPU time of this process [ms].
double process_cpu_ms();

/// CPU time of the calling thread [ms].
double thread_cpu_ms();

/// 0 without samples.
double mean(const std::vector<double>& samples);

/// What write_json() says of every object, as `made`: program and command. Nothing until it is told.
void tell_provenance(std::function<nlohmann::ordered_json()> made);

/// Throws std::runtime_error when the file cannot be written. An empty path writes nothing.
void write_json(const std::string& path, const nlohmann::ordered_json& value);

}  // namespace bw
