#include "components/lab/shards/provenance.hpp"

#include <span>

#include "runtime/build_identity.hpp"
#include "runtime/host/sample_hash.hpp"

namespace bw {

Provenance provenance_of(const std::string& drives, std::int64_t shard, std::int64_t of) {
  SampleHash hash;
  hash.add("", Time{}, std::span(reinterpret_cast<const std::uint8_t*>(drives.data()), drives.size()));
  return {build_id(), source_revision(), cpu_type(), hash.hex(), shard, of};
}

nlohmann::json to_json(const Provenance& made) {
  return {{"build", made.build},   {"revision", made.revision}, {"cpu", made.cpu},
          {"drives", made.drives}, {"shard", made.shard},       {"of", made.of}};
}

Provenance provenance_from(const nlohmann::json& json) {
  return {json.at("build"),  json.at("revision"), json.at("cpu"),
          json.at("drives"), json.at("shard"),    json.at("of")};
}

std::string difference(const Provenance& a, const Provenance& b) {
  const auto differ = [](const char* what, const std::string& x, const std::string& y) {
    return x == y ? std::string() : std::string(what) + ": " + x + ", and " + y;
  };
  for (const std::string& found :
       {differ("revision", a.revision, b.revision), differ("build", a.build, b.build),
        differ("processor", a.cpu, b.cpu), differ("what is driven", a.drives, b.drives),
        differ("number of shards", std::to_string(a.of), std::to_string(b.of))})
    if (!found.empty()) return found;
  return {};
}

}  // namespace bw
