#include "components/lab/shards/provenance.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <span>

#include "runtime/build_identity.hpp"
#include "runtime/host/sample_hash.hpp"

namespace bw {

Provenance provenance_of(const std::string& drives, std::int64_t shard, std::int64_t of) {
  SampleHash hash;
  hash.add("", Time{}, std::span(reinterpret_cast<const std::uint8_t*>(drives.data()), drives.size()));
  return {build_id(), source_revision(), cpu_type(), hash.hex(), shard, of};
}

nlohmann::ordered_json citation() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::string command;
  for (std::string word; std::getline(in, word, '\0');)
    command += command.empty() ? std::filesystem::path(word).filename().string() : " " + word;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char date[16];
  const std::size_t length = std::strftime(date, sizeof date, "%Y-%m-%d", &utc);
  return {{"revision", source_revision()},
          {"build", build_id()},
          {"cpu", cpu_type()},
          {"date", std::string(date, length)},
          {"command", command}};
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
