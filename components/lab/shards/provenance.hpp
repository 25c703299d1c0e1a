// What a file of results was made of: two files go together where all of it is the same.
#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

namespace bw {

struct Provenance {
  std::string build;     ///< of program and libraries (runtime/build_identity.hpp)
  std::string revision;  ///< of the sources
  std::string cpu;       ///< type: other processors round otherwise
  std::string
      drives;  ///< SHA-256 of all that one run would drive: graphs with the files that they name, and seeds
  std::int64_t shard = 1;  ///< of these every `of`-th, from this one on
  std::int64_t of = 1;

  bool operator==(const Provenance&) const = default;
};

/// With what this program is. `drives`: texts of all drives in their order.
Provenance provenance_of(const std::string& drives, std::int64_t shard, std::int64_t of);

/// For who cites a result: {revision, build, cpu, date, command}; the date is today's, UTC.
nlohmann::ordered_json citation();

nlohmann::json to_json(const Provenance& made);
/// Throws nlohmann::json::exception.
Provenance provenance_from(const nlohmann::json& json);

/// In what two shards of one evaluation differ that they may not: "build: a1, b2"; empty where in nothing.
std::string difference(const Provenance& a, const Provenance& b);

}  // namespace bw
