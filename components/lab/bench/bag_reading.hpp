// The reading half of `bandwagon bench bag`.
#pragma once

#include <cstdint>
#include <filesystem>

#include <nlohmann/json_fwd.hpp>

namespace bw {

/// Opens the bag, goes to random times, reads it to its end, each from a cold cache as far as the system lets
/// us: prints and returns times [s] and memory [bytes].
nlohmann::ordered_json read_figures(const std::filesystem::path& bag, int seeks, std::uint64_t seed);

/// Throws std::runtime_error.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

}  // namespace bw
