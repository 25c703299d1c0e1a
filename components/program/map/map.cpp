// bandwagon map: a map from a recorded drive, by SLAM, as fast as it goes.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/files/map_file.hpp"
#include "components/program/map/map_making.hpp"
#include "components/slam/files/slam_settings.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/terminal.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

struct MapArguments {
  std::vector<std::filesystem::path> bags;
  std::filesystem::path out;
  std::vector<std::string> scans;
  std::string odometry;
  std::vector<std::string> set;
  bool overwrite = false;
  std::string json;
};

/// NAME.yaml beside NAME.pgm; what cannot be written is told before the work.
std::filesystem::path yaml_of(const MapArguments& arguments) {
  std::filesystem::path yaml = arguments.out;
  if (!yaml.has_filename()) throw std::runtime_error("-o " + yaml.string() + ": it names no file");
  if (yaml.extension() != ".yaml") yaml += ".yaml";
  const std::filesystem::path folder = yaml.has_parent_path() ? yaml.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error("-o " + yaml.string() + ": there is no folder " + folder.string());
  std::filesystem::path image = yaml;
  image.replace_extension(".pgm");
  for (const std::filesystem::path& file : {yaml, image}) {
    if (!arguments.overwrite && std::filesystem::exists(std::filesystem::symlink_status(file)))
      throw std::runtime_error(file.string() + " exists already; --overwrite replaces it");
  }
  return yaml;
}

class Progress {
 public:
  bool operator()(std::size_t done, std::size_t of) {
    if (cli::interrupted()) return false;
    const std::size_t percent = 100 * done / of;
    if (percent != shown_) line_.show(fmt::format("{} %  scan {} of {}", percent, done, of));
    shown_ = percent;
    return true;
  }

 private:
  cli::ProgressLine line_;
  std::size_t shown_ = 101;
};

nlohmann::ordered_json to_json(const MadeMap& map, const std::filesystem::path& yaml, double seconds) {
  const LoopResiduals& r = map.residuals;
  return {{"map", yaml.string()},
          {"scans", map.scans},
          {"scans_used", map.scans_used},
          {"scans_by_odometry_alone", map.unmatched},
          {"left_out", map.left_out},
          {"drive_s", map.seconds},
          {"travel_m", map.travel},
          {"submaps", map.submaps},
          {"loops",
           {{"found", map.loops.found},
            {"closed", map.loops.accepted},
            {"residual_m", {{"mean", r.mean}, {"max", r.largest}}},
            {"residual_rad", {{"mean", r.mean_turn}, {"max", r.largest_turn}}}}},
          {"free_m2", map.free_area},
          {"width", map.grid.width},
          {"height", map.grid.height},
          {"resolution_m", map.grid.resolution},
          {"real_time_s", seconds},
          {"max_rss_mb", peak_memory_mb()}};
}

int run(const MapArguments& arguments) {
  const MapMakingOptions options{arguments.odometry, arguments.scans, slam::slam_options_of(arguments.set)};
  const std::filesystem::path yaml = yaml_of(arguments);
  std::vector<std::unique_ptr<bag::Bag>> recordings;
  std::vector<DriveBag> bags;
  for (const std::filesystem::path& path : arguments.bags) {
    recordings.push_back(bag::open_bag(path));
    bags.push_back({*recordings.back(), path.string()});
  }
  cli::catch_interrupts();
  const auto before = std::chrono::steady_clock::now();
  MadeMap map;
  {
    Progress progress;
    map = make_map(bags, options, [&](std::size_t done, std::size_t of) { return progress(done, of); });
  }
  if (!map.is_whole) {
    std::cerr << "interrupted: no map is written\n";
    return 1;
  }
  if (!map.unplaced.empty()) {
    std::cerr << map.unplaced
              << ": the robot's place in the map of the bags before was not found; no map is written\n";
    return 1;
  }
  if (map.scans_used == 0) {
    std::cerr << "no scan could be used\n" << map_report(map);
    return 1;
  }
  save_map(map.grid, yaml, {}, ImageFormat::pgm, arguments.overwrite ? Existing::replace : Existing::refuse);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  std::cout << map_report(map)
            << fmt::format("work      {:.1f} s, {:.0f} times as fast as the drive; {:.0f} MB at most\n",
                           seconds, map.seconds / seconds, peak_memory_mb())
            << "map       " << yaml.string() << "\n";
  if (!arguments.json.empty())
    write_file_atomically(arguments.json, to_json(map, yaml, seconds).dump(1) + "\n");
  return 0;
}

void add_map(cli::Verb verb) {
  auto arguments = std::make_shared<MapArguments>();
  verb.option("BAG", arguments->bags,
              "Recordings with a laser's scans and odometry; several drives in one place make one map")
      .required();
  verb.option("-o,--out", arguments->out, "NAME of the map: NAME.yaml and NAME.pgm").required();
  verb.option("--scan", arguments->scans,
              "Topic of the scans, if not /scan and not the only one; once for each scanner")
      .one_each_time();
  verb.option("--odom", arguments->odometry, "Topic of the odometry, if not /odom and not the only one");
  verb.option("--set", arguments->set,
              "slam.parameter=value, such as slam.resolution=0.1; as often as needed")
      .one_each_time();
  verb.flag("--overwrite", arguments->overwrite, "Replaces a map of that name");
  verb.option("--json", arguments->json, "Writes the report here");
  verb.run([arguments] { return run(*arguments); });
}

}  // namespace

BW_VERB(drive, "map", "A map from recorded drives: map_server's pair of files, and what it is made of",
        add_map)

}  // namespace bw
