#include "components/lab/bench/slam/bench_relations.hpp"

#include <cstdio>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/slam/handicaps.hpp"
#include "components/lab/bench/slam/relations_file.hpp"
#include "components/lab/bench/slam/trajectory.hpp"
#include "components/recordings/files/imported_drive.hpp"
#include "components/slam/files/slam_settings.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;
using slam::RelationErrors;

constexpr double kDegree = std::numbers::pi / 180.0;

BagDrive read_drive(const BenchRelationsArguments& arguments) {
  if (arguments.columns.empty()) return drive_of_bag(*bag::open_bag(arguments.bag), {}, arguments.bag);
  return import_drive(arguments.columns, {arguments.bag});
}

std::string row(const char* name, const PublishedErrors& e) {
  return fmt::format("  {:<42}{:.4f} +- {:.4f} m   {:.3f} +- {:.3f} deg\n", name, e.translation,
                     e.translation_deviation, e.rotation, e.rotation_deviation);
}

PublishedErrors in_degrees(const RelationErrors& e) {
  return {e.translation, e.translation_deviation, e.rotation / kDegree, e.rotation_deviation / kDegree};
}

std::string text_of(const RelationsRun& run) {
  std::string text = fmt::format("{}: {} scans in {:.0f} s, {} of {} relations used\n", run.log, run.scans,
                                 run.seconds, run.at_the_end.relations, run.relations);
  for (const std::string& sentence : run.left_out) text += "  " + sentence + "\n";
  text += row("after the last optimisation", in_degrees(run.at_the_end));
  if (run.of_scans.relations < run.at_the_end.relations)
    text += row(fmt::format("{} of them between scans that are used", run.of_scans.relations).c_str(),
                in_degrees(run.of_scans));
  text += row("as told at the time", in_degrees(run.at_the_time));
  text += row("odometry alone", in_degrees(run.odometry));
  if (const auto published = cartographer_on(run.log))
    text += row("Cartographer (Hess et al. 2016)", *published);
  text += fmt::format(
      "  {} submaps, {} loop closures of {} found in {} pairs, {} optimisations, {} scans by odometry alone\n",
      run.submaps, run.loops.accepted, run.loops.found, run.loops.searched, run.loops.optimisations,
      run.counts.unmatched);
  text += fmt::format(
      "  CPU {:.2f} ms a scan, loops included; 99 % of scans within {:.2f} ms, of pieces of work on loops "
      "within {:.2f} ms (longest {:.2f})\n",
      run.cpu_ms_per_scan, run.scan_p99_ms, run.piece_p99_ms, run.piece_max_ms);
  return text;
}

ordered_json to_json(const PublishedErrors& e) {
  return {{"translation_m", e.translation},
          {"translation_deviation_m", e.translation_deviation},
          {"rotation_deg", e.rotation},
          {"rotation_deviation_deg", e.rotation_deviation}};
}

ordered_json json_of(const RelationsRun& run, const BenchRelationsArguments& arguments) {
  const auto published = cartographer_on(run.log);
  return {{"log", run.log},
          {"scans", run.scans},
          {"relations", run.relations},
          {"relations_used", run.at_the_end.relations},
          {"odometry_scale", arguments.odometry_scale},
          {"every", arguments.every},
          {"view_deg", arguments.view ? ordered_json(*arguments.view) : ordered_json()},
          {"at_the_end", to_json(in_degrees(run.at_the_end))},
          {"relations_of_scans", run.of_scans.relations},
          {"of_scans", to_json(in_degrees(run.of_scans))},
          {"at_the_time", to_json(in_degrees(run.at_the_time))},
          {"odometry", to_json(in_degrees(run.odometry))},
          {"cartographer", published ? to_json(*published) : ordered_json()},
          {"submaps", run.submaps},
          {"loops",
           {{"searched", run.loops.searched},
            {"found", run.loops.found},
            {"accepted", run.loops.accepted},
            {"optimisations", run.loops.optimisations}}},
          {"unmatched", run.counts.unmatched},
          {"cpu_ms_per_scan", run.cpu_ms_per_scan},
          {"scan_p99_ms", run.scan_p99_ms},
          {"piece_p99_ms", run.piece_p99_ms},
          {"piece_max_ms", run.piece_max_ms},
          {"left_out", run.left_out}};
}

}  // namespace

std::optional<PublishedErrors> cartographer_on(std::string_view log) {
  if (log == "mit_csail") return PublishedErrors{0.0319, 0.0363, 0.369, 0.365};
  if (log == "freiburg_hospital") return PublishedErrors{0.1078, 0.1943, 0.747, 2.047};
  return std::nullopt;
}

RelationsRun run_relations(const BenchRelationsArguments& arguments) {
  const slam::SlamOptions options = slam::slam_options_of(arguments.set);
  const std::vector<slam::Relation> relations = slam::read_relations(arguments.relations);
  BagDrive bag = read_drive(arguments);
  RecordedDrive& drive = bag.drive;
  if (drive.scans.empty() || drive.odometry.empty())
    throw std::runtime_error(
        fmt::format("{}: there is no {} in it", arguments.bag, drive.scans.empty() ? "scan" : "odometry"));
  slam::scale_odometry(drive, arguments.odometry_scale);
  slam::thin_out_scans(drive, static_cast<std::size_t>(arguments.every));
  if (arguments.view) slam::narrow_view(drive, *arguments.view * kDegree);

  const double before_ms = thread_cpu_ms();
  const slam::SlamReplay replayed = slam::replay(drive, options, {.clock = thread_cpu_ms});
  const double cpu_ms = thread_cpu_ms() - before_ms;
  const auto errors = [&](slam::Told told) {
    const slam::Trajectory trajectory(replayed, drive.odometry, told);
    return slam::errors_of(relations,
                           [&](Time stamp) { return trajectory.at(stamp - (bag.start - Time{})); });
  };
  RelationsRun run;
  run.log = bag.log.name;
  run.scans = drive.scans.size();
  if (run.scans > 0) run.seconds = (drive.scans.back().time - drive.scans.front().time).to_seconds();
  run.relations = relations.size();
  run.at_the_end = errors(slam::Told::at_the_end);
  const slam::Trajectory last(replayed, drive.odometry, slam::Told::at_the_end);
  run.of_scans =
      slam::errors_of(relations, [&](Time stamp) { return last.of_scan(stamp - (bag.start - Time{})); });
  run.at_the_time = errors(slam::Told::at_the_time);
  run.odometry = errors(slam::Told::by_odometry);
  run.loops = replayed.slam.loop_counts();
  run.counts = replayed.slam.counts();
  run.submaps = replayed.slam.submaps();
  run.cpu_ms_per_scan = replayed.scans.empty() ? 0.0 : cpu_ms / static_cast<double>(replayed.scans.size());
  run.scan_p99_ms = quantile(replayed.scan_times, 0.99);
  run.piece_p99_ms = quantile(replayed.piece_times, 0.99);
  run.piece_max_ms = quantile(replayed.piece_times, 1.0);
  run.left_out = bag.left_out;
  run.left_out.insert(run.left_out.end(), replayed.left_out.begin(), replayed.left_out.end());
  return run;
}

int bench_relations(const BenchRelationsArguments& arguments) {
  const RelationsRun run = run_relations(arguments);
  std::fputs(text_of(run).c_str(), stdout);
  write_json(arguments.json, json_of(run, arguments));
  return run.at_the_end.relations > 0 ? 0 : 1;
}

}  // namespace bw
