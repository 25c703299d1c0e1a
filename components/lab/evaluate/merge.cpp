#include "components/lab/evaluate/merge.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace bw {

std::size_t ResultsFile::driven() const {
  std::size_t count = 0;
  for (const SuiteResult& result : results) count += result.episodes.size();
  return count;
}

ResultsFile read_results_file(const std::filesystem::path& file) {
  ResultsFile read{.file = file, .made = {}, .planned = 0, .results = {}};
  const nlohmann::json root = read_results(file, "", read.results);
  read.planned = root.value("planned", read.driven());
  if (root.contains("made")) read.made = provenance_from(root.at("made"));
  return read;
}

std::vector<SuiteResult> merge(const std::vector<ResultsFile>& shards) {
  if (shards.empty()) throw std::runtime_error("no shards to merge");
  const ResultsFile& first = shards.front();
  const auto count = static_cast<std::size_t>(first.made.of);
  std::vector<const ResultsFile*> by_number(count, nullptr);
  for (const ResultsFile& shard : shards) {
    const std::string file = shard.file.string();
    if (const std::string differ = difference(first.made, shard.made); !differ.empty())
      throw std::runtime_error(
          fmt::format("{} and {} do not go together; {}", first.file.string(), file, differ));
    if (shard.made.shard < 1 || shard.made.shard > first.made.of)
      throw std::runtime_error(fmt::format("{}: shard {} of {}", file, shard.made.shard, first.made.of));
    if (shard.driven() != shard.planned)
      throw std::runtime_error(
          fmt::format("{} is not complete: {} of {} drives", file, shard.driven(), shard.planned));
    const ResultsFile*& place = by_number[static_cast<std::size_t>(shard.made.shard - 1)];
    if (place != nullptr)
      throw std::runtime_error(
          fmt::format("{} and {} are both shard {}", place->file.string(), file, shard.made.shard));
    place = &shard;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (by_number[i] == nullptr)
      throw std::runtime_error(fmt::format("shard {}/{} is missing: evaluate ... --shard {}/{} makes it",
                                           i + 1, count, i + 1, count));

  // Each shard's drives one after the other, as it drove them.
  struct Drive {
    const std::string* suite;
    const EpisodeResult* episode;
  };
  std::vector<std::vector<Drive>> drives(count);
  std::size_t all = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (const SuiteResult& result : by_number[i]->results)
      for (const EpisodeResult& episode : result.episodes) drives[i].push_back({&result.suite, &episode});
    all += drives[i].size();
  }
  std::vector<SuiteResult> merged;
  for (const ResultsFile* shard : by_number)
    for (const SuiteResult& result : shard->results)
      if (std::ranges::find(merged, result.suite, &SuiteResult::suite) == merged.end())
        merged.push_back({result.suite, {}});
  for (std::size_t k = 0; k < all; ++k) {
    const std::vector<Drive>& shard = drives[k % count];
    if (k / count >= shard.size())
      throw std::runtime_error(by_number[k % count]->file.string() + ": has fewer drives than its share");
    const Drive& drive = shard[k / count];
    std::ranges::find(merged, *drive.suite, &SuiteResult::suite)->episodes.push_back(*drive.episode);
  }
  return merged;
}

}  // namespace bw
