// Drives among people in which processes fail: killed, stopped, spinning, leaking. Each drive is kept, so that a longer run goes
// on from a shorter one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace bw {

struct InjectionsOptions {
  int injections = 300;
  int each = 3;  ///< a drive
  std::uint64_t seed = 1;
  std::filesystem::path out = "injections";
  double longest = 150.0;  ///< [s] a drive
};

/// The table in words, and {n, failures, ...}: what `bandwagon-lab injections` prints and writes.
struct InjectionsReport {
  std::string text;
  nlohmann::ordered_json json;
  bool is_good = false;
};

/// Of drives as they are kept: [{seed, reached, status, caused_contacts, injections: [...]}].
InjectionsReport report_of_injections(const nlohmann::json& drives);

/// Drives what is missing. Throws std::runtime_error.
InjectionsReport drive_injections(const InjectionsOptions& options);

}  // namespace bw
