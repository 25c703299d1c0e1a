#include "components/lab/bench/slam/bench_slam.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/buildings/known_map.hpp"
#include "components/slam/files/slam_settings.hpp"
#include "components/slam/map_painter.hpp"
#include "runtime/base/quantile.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;

OccupancyGrid painted_at_truth(const slam::Slam& made, double resolution, const slam::TruthOfScans& truth) {
  slam::MapRendering rendering(resolution);
  for (const auto& [number, node] : made.nodes()) rendering.draw(*node.ranges, truth.at(node.time));
  return rendering.grid();
}

/// A scan as the component handles it: its own work, the next pieces of the work on loops, and some scans of the map.
class OnlineCost {
 public:
  OnlineCost(double resolution, const Pose2& X_WM)
      : painter_(resolution, X_WM), memory_before_(bw::memory_mb()) {}

  void look(const slam::SlamReplay& so_far) {
    double ms = so_far.scan_times.back();
    const std::size_t end = std::min(so_far.piece_times.size(), piece_ + slam::kPiecesPerScan);
    for (; piece_ < end; ++piece_) ms += so_far.piece_times[piece_];
    const double before_ms = thread_cpu_ms();
    painter_.update(so_far.slam, slam::kDrawnPerScan);
    times_.push_back(ms + thread_cpu_ms() - before_ms);
    if (times_.size() % kLooksAtMemory == 0) memory_ = std::max(memory_, bw::memory_mb() - memory_before_);
  }
  const std::vector<double>& times() const { return times_; }  ///< [ms]
  double memory_mb() const { return memory_; }

 private:
  static constexpr std::size_t kLooksAtMemory = 200;  // scans
  slam::MapPainter painter_;
  std::size_t piece_ = 0;  ///< that is done next
  std::vector<double> times_;
  double memory_before_;
  double memory_ = 0.0;  ///< [bytes] more than before
};

std::string line_of(const SlamDrive& d) {
  return fmt::format(
      "{:<14}{:6.0f} m  ATE {:.3f} m (at most {:.3f})  map F1 {:.3f} (at the truth {:.3f})  loops {}, wrong {}, gross {} "
      "({} kept)  missed {} of {}  ANEES {:.2f} (95 %: {:.0f} %)  CPU {:.2f} ms, 99 %: {:.1f}, pieces {:.1f}, at most {:.1f}; "
      "online 99 %: {:.1f}, at most {:.1f}; beside {:.1f}, at most {:.1f}; {:.0f} MB\n",
      d.building, d.way, d.trajectory.rms, d.trajectory.largest, d.map.f1(), d.map_at_truth.f1(),
      d.loops.loops, d.loops.wrong, d.loops.gross, d.loops.gross_kept, d.missed, d.revisits,
      d.consistency.anees, 100.0 * d.consistency.share_in_95, d.cpu_ms_per_scan, d.scan_p99_ms,
      d.piece_p99_ms, d.piece_most_ms, d.online_p99_ms, d.online_most_ms, d.graph_p99_ms, d.graph_most_ms,
      d.memory_mb);
}

ordered_json json_of(const SlamDrive& d) {
  return {{"building", d.building},
          {"scans", d.scans},
          {"way_m", d.way},
          {"ate_m", {{"rms", d.trajectory.rms}, {"max", d.trajectory.largest}}},
          {"map", {{"f1", d.map.f1()}, {"precision", d.map.precision()}, {"recall", d.map.recall()}}},
          {"map_at_truth_f1", d.map_at_truth.f1()},
          {"loops",
           {{"closed", d.loops.loops},
            {"wrong", d.loops.wrong},
            {"gross", d.loops.gross},
            {"gross_kept", d.loops.gross_kept}}},
          {"revisits", d.revisits},
          {"missed", d.missed},
          {"anees", d.consistency.anees},
          {"share_in_95", d.consistency.share_in_95},
          {"cpu_ms_per_scan", d.cpu_ms_per_scan},
          {"scan_p99_ms", d.scan_p99_ms},
          {"piece_p99_ms", d.piece_p99_ms},
          {"piece_most_ms", d.piece_most_ms},
          {"graph_p99_ms", d.graph_p99_ms},
          {"graph_most_ms", d.graph_most_ms},
          {"online_p99_ms", d.online_p99_ms},
          {"online_most_ms", d.online_most_ms},
          {"memory_mb", d.memory_mb}};
}

/// Of the drives of one kind: medians, and sums of what is counted.
struct Summary {
  std::string kind;
  std::size_t drives = 0;
  double ate = 0.0;
  double worst_ate = 0.0;
  double f1 = 0.0;
  double anees = 0.0;
  double cpu_ms = 0.0;
  slam::LoopFaults loops;
  std::size_t revisits = 0;
  std::size_t missed = 0;
};

Summary summary_of(const std::string& kind, const std::vector<SlamDrive>& drives) {
  Summary sum;
  sum.kind = kind;
  sum.drives = drives.size();
  const auto median = [&drives](const auto& figure) {
    std::vector<double> values;
    for (const SlamDrive& d : drives) values.push_back(figure(d));
    return quantile(std::move(values), 0.5);
  };
  sum.ate = median([](const SlamDrive& d) { return d.trajectory.rms; });
  sum.f1 = median([](const SlamDrive& d) { return d.map.f1(); });
  sum.anees = median([](const SlamDrive& d) { return d.consistency.anees; });
  sum.cpu_ms = median([](const SlamDrive& d) { return d.cpu_ms_per_scan; });
  for (const SlamDrive& d : drives) {
    sum.worst_ate = std::max(sum.worst_ate, d.trajectory.rms);
    sum.loops.loops += d.loops.loops;
    sum.loops.wrong += d.loops.wrong;
    sum.loops.gross += d.loops.gross;
    sum.loops.gross_kept += d.loops.gross_kept;
    sum.revisits += d.revisits;
    sum.missed += d.missed;
  }
  return sum;
}

std::string text_of(const Summary& s) {
  return fmt::format(
      "{}, {} drives: median ATE {:.3f} m (worst {:.3f}), map F1 {:.3f}, ANEES {:.2f}, CPU {:.2f} ms; of {} loops {} wrong, "
      "{} gross ({} kept); missed {} of {} revisits\n",
      s.kind, s.drives, s.ate, s.worst_ate, s.f1, s.anees, s.cpu_ms, s.loops.loops, s.loops.wrong,
      s.loops.gross, s.loops.gross_kept, s.missed, s.revisits);
}

ordered_json json_of(const Summary& s) {
  return {{"kind", s.kind},
          {"drives", s.drives},
          {"median_ate_m", s.ate},
          {"worst_ate_m", s.worst_ate},
          {"median_f1", s.f1},
          {"median_anees", s.anees},
          {"median_cpu_ms_per_scan", s.cpu_ms},
          {"loops", s.loops.loops},
          {"wrong", s.loops.wrong},
          {"gross", s.loops.gross},
          {"gross_kept", s.loops.gross_kept},
          {"revisits", s.revisits},
          {"missed", s.missed}};
}

}  // namespace

buildings::BuildingDriveOptions drive_options(const BenchSlamArguments& arguments, int i) {
  buildings::BuildingDriveOptions options = arguments.drive;
  options.seed = arguments.first + static_cast<std::uint64_t>(i);
  if (arguments.calibrated) options.wheels = buildings::calibrated_wheels_of(options.base);
  return options;
}

SlamDrive drive_slam(const buildings::Building& building, const buildings::BuildingDriveOptions& options,
                     const slam::SlamOptions& slam) {
  const RecordedDrive drive = buildings::drive_through(building, options);
  const slam::TruthOfScans truth(drive);
  const buildings::WallIndex walls(building.walls);
  slam::Revisits revisits(truth, walls);
  double judging_ms = 0.0;
  OnlineCost online(slam.resolution, truth.at(drive.scans.front().time));
  const auto look = [&](const slam::SlamReplay& so_far) {
    const double before_ms = thread_cpu_ms();
    revisits.look(so_far);
    online.look(so_far);
    judging_ms += thread_cpu_ms() - before_ms;
  };
  const double before_ms = thread_cpu_ms();
  const slam::SlamReplay replayed = slam::replay(drive, slam, {.clock = thread_cpu_ms, .after_scan = look});
  const double cpu_ms = thread_cpu_ms() - before_ms - judging_ms;

  std::vector<Pose2> estimated;
  std::vector<Pose2> truth_of_scans;
  for (std::size_t k = 0; k < replayed.scans.size(); ++k) {
    estimated.push_back(replayed.pose(k));
    truth_of_scans.push_back(truth.at(replayed.scans[k].time));
  }
  SlamDrive result;
  result.building = building.name;
  result.scans = replayed.scans.size();
  for (std::size_t i = 1; i < drive.truth.size(); ++i)
    result.way += (drive.truth[i].position - drive.truth[i - 1].position).norm();
  result.trajectory = slam::trajectory_error(estimated, truth_of_scans);
  const OccupancyGrid known = buildings::known_map(building, slam.resolution);
  result.map = slam::score_map(
      slam::render(slam::placed_scans(replayed.slam, truth_of_scans.front()), slam.resolution), known, {});
  result.map_at_truth = slam::score_map(painted_at_truth(replayed.slam, slam.resolution, truth), known, {});
  result.loops = slam::loop_faults(replayed.slam, truth);
  result.revisits = revisits.count();
  result.missed = revisits.missed();
  result.consistency = slam::consistency(replayed, truth_of_scans);
  result.cpu_ms_per_scan = cpu_ms / static_cast<double>(replayed.scans.size());
  result.scan_p99_ms = quantile(replayed.scan_times, 0.99);
  result.piece_p99_ms = quantile(replayed.piece_times, 0.99);
  result.piece_most_ms = quantile(replayed.piece_times, 1.0);
  result.graph_p99_ms = quantile(replayed.graph_times, 0.99);
  result.graph_most_ms = quantile(replayed.graph_times, 1.0);
  result.online_p99_ms = quantile(online.times(), 0.99);
  result.online_most_ms = quantile(online.times(), 1.0);
  result.memory_mb = online.memory_mb();
  return result;
}

int bench_slam(const BenchSlamArguments& arguments) {
  const slam::SlamOptions slam = slam::slam_options_of(arguments.set);
  ordered_json drives = ordered_json::array();
  ordered_json summaries = ordered_json::array();
  std::string sums;
  for (const buildings::BuildingKind kind : arguments.kinds) {
    std::vector<SlamDrive> of_kind;
    for (int i = 0; i < arguments.seeds; ++i) {
      const buildings::BuildingDriveOptions options = drive_options(arguments, i);
      of_kind.push_back(drive_slam(buildings::make_building(kind, options.seed), options, slam));
      std::fputs(line_of(of_kind.back()).c_str(), stdout);
      std::fflush(stdout);
      drives.push_back(json_of(of_kind.back()));
    }
    const Summary summary = summary_of(buildings::to_text(kind), of_kind);
    sums += text_of(summary);
    summaries.push_back(json_of(summary));
  }
  std::fputs(sums.c_str(), stdout);
  write_json(arguments.json, {{"base", buildings::to_text(arguments.drive.base)},
                              {"calibrated", arguments.calibrated},
                              {"walkers", arguments.drive.walkers},
                              {"drives", drives},
                              {"summary", summaries}});
  return 0;
}

}  // namespace bw
