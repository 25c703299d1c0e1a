#include "components/lab/evaluate/jobs.hpp"

#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace bw {
namespace {

/// Two whole numbers, 0 to 10^9, around `separator`; nothing for any other text.
std::optional<std::pair<std::int64_t, std::int64_t>> number_pair(const std::string& text,
                                                                 const std::string& separator) {
  constexpr std::int64_t kLargest = 1'000'000'000;
  std::pair<std::int64_t, std::int64_t> out;
  const std::size_t middle = text.find(separator);
  if (middle == std::string::npos) return std::nullopt;
  const auto read = [](const char* begin, const char* end, std::int64_t& value) {
    const auto [stop, error] = std::from_chars(begin, end, value);
    return error == std::errc() && stop == end && value >= 0 && value <= kLargest;
  };
  const char* begin = text.data();
  if (!read(begin, begin + middle, out.first)) return std::nullopt;
  if (!read(begin + middle + separator.size(), begin + text.size(), out.second)) return std::nullopt;
  return out;
}

SeedRange seeds_of(const EvaluateOptions& options, const Suite& suite) {
  if (options.seeds.empty()) return suite.options.seeds;
  const auto range = number_pair(options.seeds, "..");
  if (!range || range->second < range->first) {
    throw std::runtime_error("--seeds " + options.seeds + ": must be A..B with A <= B");
  }
  return {range->first, range->second};
}

}  // namespace

Varied varied_of(const EvaluateOptions& options) {
  Varied varied;
  if (options.vary.empty()) return varied;
  const std::size_t equals = options.vary.find('=');
  const auto refuse = [&] {
    throw std::runtime_error(
        "--vary " + options.vary +
        ": must have the form component.param=value,value,... with plain words or numbers");
  };
  if (equals == std::string::npos || equals == 0) refuse();
  varied.parameter = options.vary.substr(0, equals);
  varied.values.clear();
  std::istringstream rest(options.vary.substr(equals + 1));
  for (std::string value; std::getline(rest, value, ',');) {
    if (!is_episode_name(value)) refuse();
    varied.values.push_back(value);
  }
  if (varied.values.empty()) refuse();
  return varied;
}

Shard shard_of(const EvaluateOptions& options) {
  if (options.shard.empty()) return {};
  const auto given = number_pair(options.shard, "/");
  if (!given || given->first < 1 || given->first > given->second)
    throw std::runtime_error("--shard " + options.shard + ": must be I/N with 1 <= I <= N");
  return {given->first, given->second};
}

std::vector<Job> part_of(const std::vector<Job>& jobs, const Shard& shard) {
  std::vector<Job> part;
  for (auto k = static_cast<std::size_t>(shard.number - 1); k < jobs.size();
       k += static_cast<std::size_t>(shard.of))
    part.push_back(jobs[k]);
  if (part.empty()) throw std::runtime_error("no episode is chosen");
  return part;
}

std::vector<Job> jobs_of(const EvaluateOptions& options, const std::vector<Suite>& suites) {
  const Varied varied = varied_of(options);
  std::vector<Job> jobs;
  for (std::size_t suite = 0; suite < suites.size(); ++suite) {
    const SeedRange seeds = seeds_of(options, suites[suite]);
    const std::vector<SuiteEpisode>& episodes = suites[suite].options.episodes;
    const auto add = [&](std::size_t episode, const std::string& planner, const std::string& variant) {
      for (const std::string& value : varied.values) {
        for (std::int64_t seed = seeds.first; seed <= seeds.last; ++seed)
          jobs.push_back({suite, episode, seed, planner, variant, value});
      }
    };
    for (const std::string& planner : options.planners) {
      for (const std::string& variant : options.variants) {
        for (std::size_t episode = 0; episode < episodes.size(); ++episode) {
          if (options.only_episode.empty() || episodes[episode].name == options.only_episode)
            add(episode, planner, variant);
        }
      }
    }
  }
  if (jobs.empty()) throw std::runtime_error("no episode is chosen");
  return jobs;
}

}  // namespace bw
