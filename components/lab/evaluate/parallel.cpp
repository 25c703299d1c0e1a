#include "components/lab/evaluate/parallel.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/shards/child_pool.hpp"
#include "runtime/child_process.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

constexpr std::int64_t kShardsPerProcess = 8;  // so that all end at about the same time
constexpr int kAttempts = 2;

std::vector<std::string> command_of(const EvaluateOptions& options, std::int64_t shard, std::int64_t of,
                                    const std::filesystem::path& json) {
  std::vector<std::string> command{"/proc/self/exe", "evaluate"};
  command.insert(command.end(), options.suites.begin(), options.suites.end());
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) command.push_back(std::string(name) + "=" + value);
  };
  const auto joined = [](const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& one : list) text += (text.empty() ? "" : ",") + one;
    return text;
  };
  add("--planners", joined(options.planners));
  add("--variants", joined(options.variants));
  for (const std::string& one : options.set) add("--set", one);
  add("--seeds", options.seeds);
  add("--episode", options.only_episode);
  add("--vary", options.vary);
  add("--svg-dir", options.svg_dir);
  add("--html", options.html_dir);
  add("--shard", fmt::format("{}/{}", shard, of));
  add("--json", json.string());
  return command;
}

// Nothing where it is not there, not complete, or another one.
bool is_done(const std::filesystem::path& file, const Provenance& made) {
  try {
    const ResultsFile shard = read_results_file(file);
    return shard.made == made && shard.driven() == shard.planned;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

std::vector<ResultsFile> drive_in_shards(const EvaluateOptions& options, std::size_t count,
                                         const Provenance& made, const std::filesystem::path& folder) {
  const std::int64_t of = std::min(static_cast<std::int64_t>(count), kShardsPerProcess * options.jobs);
  const auto file_of = [&](std::int64_t shard) { return folder / fmt::format("{}.json", shard); };
  const auto made_of = [&](std::int64_t shard) {
    Provenance one = made;
    one.shard = shard;
    one.of = of;
    return one;
  };
  std::filesystem::create_directories(folder);
  std::vector<std::int64_t> left;
  for (std::int64_t shard = 1; shard <= of; ++shard)
    if (!is_done(file_of(shard), made_of(shard))) left.push_back(shard);
  if (std::ssize(left) < of)
    std::cerr << fmt::format("{}: {} of {} shards are there\n", folder.string(), of - std::ssize(left), of);
  for (int attempt = 1; !left.empty(); ++attempt) {
    std::vector<ChildJob> children;
    for (const std::int64_t shard : left)
      children.push_back({.name = fmt::format("shard {}/{}", shard, of),
                          .command = command_of(options, shard, of, file_of(shard)),
                          .log = folder / fmt::format("{}.log", shard)});
    const std::vector<int> statuses = run_children(
        children, options.jobs, [] { return cli::interrupted(); },
        [&](const ChildProgress& p) {
          if (p.job != nullptr)
            std::cerr << fmt::format("[{}/{}] {} {}, about {:.0f} s left\n", p.ended, children.size(),
                                     p.job->name, status_in_words(p.status), p.remaining);
        });
    if (cli::interrupted()) return {};
    std::vector<std::int64_t> again;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (is_done(file_of(left[i]), made_of(left[i]))) continue;
      if (attempt >= kAttempts)
        throw std::runtime_error(fmt::format("{} {}: {}", children[i].name, status_in_words(statuses[i]),
                                             last_words(children[i].log)));
      again.push_back(left[i]);
    }
    left = std::move(again);
  }
  std::vector<ResultsFile> shards;
  for (std::int64_t shard = 1; shard <= of; ++shard) shards.push_back(read_results_file(file_of(shard)));
  return shards;
}

}  // namespace bw
