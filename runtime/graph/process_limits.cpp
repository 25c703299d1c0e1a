#include "runtime/graph/process_limits.hpp"

#include <algorithm>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

constexpr std::string_view kProcesses = "processes";
constexpr std::uint64_t kLeastMemory = 100'000'000;  // [bytes] a process with nothing in it takes half of it

void read_memory(ParameterReader& reader, ProcessLimits& limits) {
  const ConfigNode* node = reader.find("memory");
  if (node == nullptr) return;
  const std::optional<std::uint64_t> size = node->is_scalar() ? parse_size(node->scalar) : std::nullopt;
  if (size && *size >= kLeastMemory) {
    limits.memory = *size;
  } else {
    reader.refuse(*node, "memory", "must be a size of at least 100MB, such as 800MB");
  }
}

}  // namespace

std::map<std::string, ProcessLimits> read_process_limits(const ConfigNode& section,
                                                         const std::vector<std::string>& known,
                                                         std::vector<Violation>& violations) {
  std::map<std::string, ProcessLimits> all;
  if (!is_section(section, std::string(kProcesses), violations)) return all;
  for (const ConfigEntry& entry : section.map) {
    const std::string key = joined(kProcesses, entry.key);
    if (std::ranges::find(known, entry.key) == known.end())
      violations.push_back(
          {entry.where, key, "", unknown_rule("process", entry.key, {known.begin(), known.end()})});
    if (!is_section(entry.value, key, violations)) continue;
    ParameterReader reader(entry.value, key, violations);
    ProcessLimits limits;
    read_memory(reader, limits);
    double cpu = 1.0;
    reader("cpu", cpu, {.unit = "cores", .min = 0.05, .max = 1024});
    if (entry.value.find("cpu") != nullptr) limits.cpu = cpu;
    reader.refuse_unknown_keys();
    all[entry.key] = limits;
  }
  return all;
}

}  // namespace bw
