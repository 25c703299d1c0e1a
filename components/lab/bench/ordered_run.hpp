// Episodes handed to threads one by one, told of in the order of their numbers.
#pragma once

#include <cstdio>
#include <future>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "components/lab/bench/bench_common.hpp"

namespace bw {

/// run(index, clock) for 0 ... count - 1, `jobs` at a time; in_a_line(episode) of those that have one is printed in order,
/// once all before it are there. With one job the clock is the process's, else the thread's.
template <class Run>
auto run_in_order(std::size_t count, int jobs, const Run& run) {
  using Episode = decltype(run(std::size_t{}, CpuClock{}));
  std::vector<std::optional<Episode>> done(count);
  std::mutex mutex;
  std::size_t next = 0;
  std::size_t told = 0;
  const auto work = [&](const CpuClock& clock) {
    while (true) {
      std::size_t index = 0;
      {
        const std::lock_guard lock(mutex);
        if (next == count) return;
        index = next++;
      }
      Episode episode = run(index, clock);
      const std::lock_guard lock(mutex);
      done[index] = std::move(episode);
      for (; told < count && done[told]; ++told) {
        if constexpr (requires { in_a_line(*done[told]); }) {
          std::fputs(in_a_line(*done[told]).c_str(), stdout);
          std::fflush(stdout);
        }
      }
    }
  };
  if (jobs <= 1) {
    work(process_cpu_ms);
  } else {
    std::vector<std::future<void>> workers;
    workers.reserve(static_cast<std::size_t>(jobs));
    for (int job = 0; job < jobs; ++job)
      workers.push_back(std::async(std::launch::async, [&] { work(thread_cpu_ms); }));
    for (std::future<void>& worker : workers) worker.get();
  }
  std::vector<Episode> episodes;
  episodes.reserve(count);
  for (std::optional<Episode>& episode : done) episodes.push_back(std::move(*episode));
  return episodes;
}

}  // namespace bw
