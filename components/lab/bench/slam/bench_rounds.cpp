#include "components/lab/bench/slam/bench_rounds.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/buildings/known_map.hpp"
#include "components/model/rigid_fit.hpp"
#include "components/slam/files/slam_settings.hpp"
#include "components/slam/map_painter.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kCompared = 2;  // the third round: all that stays has been seen by then

SlamRound held_by(const slam::Slam& slam) {
  SlamRound round;
  double bytes = 0.0;
  for (const slam::Submap& submap : slam.map()) {
    if (!submap.marginalised) ++round.submaps;
    bytes += static_cast<double>(sizeof submap + submap.surfaces.size() * sizeof(slam::Surface));
  }
  round.scans = slam.nodes().size();
  for (const auto& [number, node] : slam.nodes())
    bytes +=
        static_cast<double>(sizeof node + sizeof(slam::RangeImage) + 2 * node.ranges->millimetres.size());
  round.edges = slam.edges().size();
  round.memory_mb = 1e-6 * (bytes + static_cast<double>(round.edges * sizeof(slam::Edge)));
  return round;
}

// What stands there in either of two arrangements.
OccupancyGrid either(OccupancyGrid a, const OccupancyGrid& b) {
  for (std::size_t k = 0; k < a.cells.size(); ++k)
    if (b.cells[k] == OccupancyGrid::kOccupied) a.cells[k] = OccupancyGrid::kOccupied;
  return a;
}

std::string line_of(std::size_t number, const SlamRound& r) {
  return fmt::format(
      "round {:>3}: {:>4} submaps, {:>5} scans, {:>5} edges, {:.2f} MB; CPU {:.2f} ms a scan; of {} cells {} stale, "
      "recall {:.3f}; pose {:.3f} m off, frame {:.3f} m\n",
      number, r.submaps, r.scans, r.edges, r.memory_mb, r.cpu_ms_per_scan, r.drawn, r.stale, r.recall,
      r.error, r.frame);
}

ordered_json json_of(const SlamRound& r) {
  return {{"submaps", r.submaps},
          {"scans", r.scans},
          {"edges", r.edges},
          {"memory_mb", r.memory_mb},
          {"cpu_ms_per_scan", r.cpu_ms_per_scan},
          {"drawn", r.drawn},
          {"stale", r.stale},
          {"recall", r.recall},
          {"error_m", r.error},
          {"frame_m", r.frame}};
}

std::string beside_third(const std::vector<SlamRound>& rounds) {
  if (rounds.size() <= kCompared + 1) return {};
  const SlamRound& third = rounds[kCompared];
  const SlamRound& last = rounds.back();
  const auto ratio = [](auto a, auto b) { return static_cast<double>(a) / static_cast<double>(b); };
  return fmt::format(
      "the last round to the third: submaps {:.2f}, scans {:.2f}, edges {:.2f}, memory {:.2f}, CPU {:.2f}\n",
      ratio(last.submaps, third.submaps), ratio(last.scans, third.scans), ratio(last.edges, third.edges),
      ratio(last.memory_mb, third.memory_mb), ratio(last.cpu_ms_per_scan, third.cpu_ms_per_scan));
}

}  // namespace

std::vector<SlamRound> drive_slam_rounds(std::uint64_t seed, int rounds,
                                         buildings::BuildingDriveOptions options,
                                         const slam::SlamOptions& slam) {
  options.seed = seed;
  std::vector<buildings::Building> arrangements;
  for (int k = 0; k < rounds; ++k)
    arrangements.push_back(buildings::make_office(seed, static_cast<std::uint64_t>(k)));
  const buildings::Rounds driven = buildings::drive_rounds(arrangements, options);
  const slam::TruthOfScans truth(driven.drive);

  std::vector<SlamRound> result;
  double before_ms = 0.0;
  std::size_t scans_before = 0;
  const auto judge = [&](const slam::SlamReplay& so_far) {
    const std::size_t k = result.size();
    SlamRound round = held_by(so_far.slam);
    const double spent = std::accumulate(so_far.scan_times.begin(), so_far.scan_times.end(), 0.0) +
                         std::accumulate(so_far.piece_times.begin(), so_far.piece_times.end(), 0.0) +
                         std::accumulate(so_far.graph_times.begin(), so_far.graph_times.end(), 0.0);
    round.cpu_ms_per_scan = (spent - before_ms) / static_cast<double>(so_far.scans.size() - scans_before);
    before_ms = spent;
    RigidFit fit;
    for (; scans_before < so_far.scans.size(); ++scans_before)
      fit.add(truth.at(so_far.scans[scans_before].time).position(), so_far.pose(scans_before).position());
    const Pose2 X_WM = truth.at(so_far.scans.front().time);
    const Pose2 X_laid = fit.X_AB();
    round.frame = (X_laid * fit.mean_B() - X_WM * fit.mean_B()).norm();
    const OccupancyGrid made = slam::render(slam::placed_scans(so_far.slam, X_laid), slam.resolution);
    const OccupancyGrid now = buildings::known_map(arrangements[k], slam.resolution);
    const OccupancyGrid before = buildings::known_map(arrangements[k == 0 ? 0 : k - 1], slam.resolution);
    const slam::MapScore lately = slam::score_map(made, either(now, before), {});
    round.drawn = lately.drawn;
    round.stale = lately.drawn - lately.right;
    round.recall = slam::score_map(made, now, {}).recall();
    round.error = ((X_WM * so_far.pose(so_far.scans.size() - 1)).position() -
                   truth.at(so_far.scans.back().time).position())
                      .norm();
    result.push_back(round);
  };
  const auto after_scan = [&](const slam::SlamReplay& so_far) {
    const std::size_t next = result.size() + 1;
    if (next < driven.begin.size() && so_far.scans.back().time >= driven.begin[next]) judge(so_far);
  };
  const slam::SlamReplay replayed =
      slam::replay(driven.drive, slam, {.clock = thread_cpu_ms, .after_scan = after_scan});
  judge(replayed);
  return result;
}

int bench_rounds(const BenchSlamArguments& arguments) {
  const slam::SlamOptions slam = slam::slam_options_of(arguments.set);
  ordered_json offices = ordered_json::array();
  for (int i = 0; i < arguments.seeds; ++i) {
    const buildings::BuildingDriveOptions options = drive_options(arguments, i);
    const std::vector<SlamRound> rounds = drive_slam_rounds(options.seed, arguments.rounds, options, slam);
    std::printf("office %llu\n", static_cast<unsigned long long>(options.seed));
    ordered_json lines = ordered_json::array();
    for (std::size_t k = 0; k < rounds.size(); ++k) {
      std::fputs(line_of(k + 1, rounds[k]).c_str(), stdout);
      lines.push_back(json_of(rounds[k]));
    }
    std::fputs(beside_third(rounds).c_str(), stdout);
    offices.push_back({{"seed", options.seed}, {"rounds", lines}});
  }
  write_json(arguments.json, {{"base", buildings::to_text(arguments.drive.base)}, {"offices", offices}});
  return 0;
}

}  // namespace bw
