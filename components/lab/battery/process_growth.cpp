#include "components/lab/battery/process_growth.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "runtime/process_memory.hpp"

namespace bw {
namespace {

template <class Use>
void each_from(const std::vector<ProcessSample>& samples, double warm, Use use) {
  for (const ProcessSample& one : samples) {
    if (one.t >= warm) use(one);
  }
}

}  // namespace

std::optional<ProcessSample> sample_process(pid_t process, double t) {
  const std::filesystem::path folder = std::filesystem::path("/proc") / std::to_string(process);
  ProcessSample sample{.t = t, .rss = memory_mb(std::to_string(process))};
  std::ifstream status(folder / "status");
  for (std::string word; status >> word;) {
    if (word == "Threads:") status >> sample.threads;
  }
  std::error_code fault;
  const auto open = std::filesystem::directory_iterator(folder / "fd", fault);
  if (fault || sample.threads == 0) return std::nullopt;
  sample.descriptors = static_cast<int>(std::distance(begin(open), end(open)));
  return sample;
}

double growth(const std::vector<ProcessSample>& samples, double warm) {
  double n = 0.0, t = 0.0, m = 0.0;
  each_from(samples, warm, [&](const ProcessSample& one) {
    n += 1.0;
    t += one.t;
    m += one.rss;
  });
  if (n < 2.0) return 0.0;
  double tt = 0.0, tm = 0.0;
  each_from(samples, warm, [&](const ProcessSample& one) {
    tt += (one.t - t / n) * (one.t - t / n);
    tm += (one.t - t / n) * (one.rss - m / n);
  });
  return tt > 0.0 ? 3600.0 * tm / tt : 0.0;
}

Spread spread(const std::vector<ProcessSample>& samples, double warm) {
  std::optional<ProcessSample> least, most;
  each_from(samples, warm, [&](const ProcessSample& one) {
    if (!least) least = most = one;
    least->descriptors = std::min(least->descriptors, one.descriptors);
    least->threads = std::min(least->threads, one.threads);
    most->descriptors = std::max(most->descriptors, one.descriptors);
    most->threads = std::max(most->threads, one.threads);
  });
  if (!least) return {};
  return {most->descriptors - least->descriptors, most->threads - least->threads};
}

}  // namespace bw
