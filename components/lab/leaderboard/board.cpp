#include "components/lab/leaderboard/board.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "components/model/random.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

constexpr double kWorse = 0.05;  // p below which a difference is shown

struct Start {
  int drives = 0;
  int successes = 0;
};

std::vector<Start> starts_of(const std::vector<BoardDrive>& drives) {
  std::map<std::string, Start> by_name;
  for (const BoardDrive& drive : drives) {
    Start& start = by_name[drive.start];
    ++start.drives;
    start.successes += drive.success ? 1 : 0;
  }
  std::vector<Start> starts;
  for (const auto& [name, start] : by_name) starts.push_back(start);
  return starts;
}

template <class Figure>
std::optional<double> mean_of(const std::vector<BoardDrive>& drives, bool of_successes, Figure figure) {
  double sum = 0.0;
  int count = 0;
  for (const BoardDrive& drive : drives) {
    const std::optional<double> value = figure(drive);
    if (!value || (of_successes && !drive.success)) continue;
    sum += *value;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::vector<PairedEpisode> paired(const std::vector<BoardDrive>& drives) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<PairedEpisode> episodes;
  for (const BoardDrive& drive : drives)
    episodes.push_back({.key = drive.key,
                        .success = drive.success,
                        .collision_index = drive.collision_index.value_or(kNone),
                        .closest = kNone,
                        .jerk = drive.jerk.value_or(kNone),
                        .time = drive.time.value_or(kNone)});
  return episodes;
}

BoardFigures figures_of(const BoardRow& row) {
  BoardFigures f;
  f.planner = row.planner;
  f.drives = static_cast<int>(row.drives.size());
  f.starts = static_cast<int>(starts_of(row.drives).size());
  for (const BoardDrive& drive : row.drives) {
    f.successes += drive.success ? 1 : 0;
    f.contacts.add(drive.contacts);
  }
  f.success = success_over_starts(row.drives);
  f.time = mean_of(row.drives, true, [](const BoardDrive& d) { return d.time; });
  f.path = mean_of(row.drives, true, [](const BoardDrive& d) { return d.path; });
  f.jerk = mean_of(row.drives, false, [](const BoardDrive& d) { return d.jerk; });
  f.collision_index = mean_of(row.drives, false, [](const BoardDrive& d) { return d.collision_index; });
  f.cycle = mean_of(row.drives, false, [](const BoardDrive& d) { return d.cycle; });
  f.score = mean_of(row.drives, false, [](const BoardDrive& d) { return d.score; });
  return f;
}

}  // namespace

Interval success_over_starts(const std::vector<BoardDrive>& drives) {
  const std::vector<Start> starts = starts_of(drives);
  const auto all = static_cast<int>(drives.size());
  const auto successes =
      static_cast<int>(std::ranges::count_if(drives, [](const BoardDrive& d) { return d.success; }));
  if (successes == 0 || successes == all) {
    const auto count = static_cast<int>(starts.size());
    return wilson95(successes == 0 ? 0 : count, count);
  }
  Random random(kBootstrapSeed);
  std::vector<double> shares;
  shares.reserve(kBootstrapSamples);
  for (int sample = 0; sample < kBootstrapSamples; ++sample) {
    Start sum;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Start& drawn =
          starts[static_cast<std::size_t>(random.uniform() * static_cast<double>(starts.size()))];
      sum.drives += drawn.drives;
      sum.successes += drawn.successes;
    }
    shares.push_back(static_cast<double>(sum.successes) / sum.drives);
  }
  return {quantile(shares, 0.025), quantile(shares, 0.975)};
}

std::vector<BoardFigures> figures_of(const BoardSuite& suite) {
  std::vector<std::size_t> order(suite.rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<BoardFigures> all;
  for (const BoardRow& row : suite.rows) all.push_back(figures_of(row));
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (all[a].share() != all[b].share()) return all[a].share() > all[b].share();
    return all[a].time.value_or(1e9) < all[b].time.value_or(1e9);
  });
  std::vector<BoardFigures> sorted;
  for (const std::size_t k : order) {
    sorted.push_back(all[k]);
    BoardFigures& f = sorted.back();
    f.against_best = compare(paired(suite.rows[order.front()].drives), paired(suite.rows[k].drives));
    f.wins = k == order.front() || (f.against_best.pairs > 0 && f.against_best.p >= kWorse);
  }
  return sorted;
}

}  // namespace bw
