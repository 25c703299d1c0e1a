// The figures of `bandwagon bench people` as text and JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/lab/bench/bench_people.hpp"

namespace bw {

/// A track from its first report to its last; times since the first scan [s].
struct TrackLife {
  std::uint32_t id = 0;
  double begin = 0.0;
  double end = 0.0;
  std::size_t sweeps = 0;            ///< in which it was reported
  std::size_t confirmed_sweeps = 0;  ///< of them
  std::optional<double> confirmed;   ///< first time; nothing: only ever possible
};

/// By id.
std::vector<TrackLife> lives_of(const std::vector<people::TrackedSweep>& sweeps);

std::string people_text(const PeopleRun& run, bool with_errors);
nlohmann::ordered_json people_json(const PeopleRun& run);

}  // namespace bw
