#include "components/lab/bench/explore/bench_explore.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/files/map_file.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/buildings/building_of_map.hpp"
#include "components/lab/bench/explore/coverage.hpp"
#include "components/lab/bench/explore/ideal_exploration.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;

constexpr double kResolution = 0.05;     // of the true map [m]
constexpr double kTourResolution = 0.1;  // of the tour's [m]
constexpr double kTourRange = 12.0;      // of the emulated laser [m]

struct Row {
  ExploreDrive drive;
  double known = 0.0;
  double tour = 0.0;   ///< [m]
  double cpu_s = 0.0;  ///< of the whole simulation
};

// Of a Kobuki.
Row explored_ideally(const buildings::Building& building, const BenchExploreArguments& arguments) {
  Row row;
  IdealExplorationOptions options;
  options.range = kTourRange;
  options.longest = arguments.drive.longest;
  const Explorable place = explorable(building, options.radius, kTourResolution);
  const double before = process_cpu_ms();
  const IdealExploration made = explore_ideally(place, options);
  row.cpu_s = 1e-3 * (process_cpu_ms() - before);
  row.known = made.known;
  row.tour = greedy_tour(place, kTourRange);
  row.drive.complete = made.complete;
  row.drive.travel = made.travel;
  row.drive.time = made.travel / options.speed;
  row.drive.status = fmt::format("{} goals, {} left", made.goals, made.left);
  return row;
}

Row explored(const buildings::Building& building, const BenchExploreArguments& arguments) {
  if (arguments.ideal) return explored_ideally(building, arguments);
  Row row;
  const double before = process_cpu_ms();
  row.drive = explore_building(building, arguments.drive);
  row.cpu_s = 1e-3 * (process_cpu_ms() - before);
  if (row.drive.map)
    row.known = coverage(explorable(building, row.drive.radius, kResolution), *row.drive.map);
  row.tour = greedy_tour(explorable(building, row.drive.radius, kTourResolution), kTourRange);
  if (!arguments.maps.empty() && row.drive.map) {
    std::string name = building.name;
    std::ranges::replace(name, ' ', '_');
    std::filesystem::create_directories(arguments.maps);
    save_map(*row.drive.map, std::filesystem::path(arguments.maps) / (name + ".yaml"), {});
  }
  return row;
}

void print(const std::string& building, const Row& r) {
  std::printf("%s",
              fmt::format("{:<14} known {:.2f} %  travel {:.0f} m ({:.2f} of the tour's {:.0f} m)  {:.0f} s  "
                          "contacts {}  CPU {:.0f} s  {}\n",
                          building, 100.0 * r.known, r.drive.travel, r.drive.travel / r.tour, r.tour,
                          r.drive.time, r.drive.contacts, r.cpu_s, r.drive.status)
                  .c_str());
  std::fflush(stdout);
}

ordered_json json_of(const std::string& building, const Row& r) {
  return {{"building", building},
          {"complete", r.drive.complete},
          {"known", r.known},
          {"travel_m", r.drive.travel},
          {"tour_m", r.tour},
          {"time_s", r.drive.time},
          {"contacts", r.drive.contacts},
          {"status", r.drive.status},
          {"cpu_s", r.cpu_s},
          {"samples_sha256", r.drive.samples_sha256}};
}

void sum_up(const std::string& kind, const std::vector<Row>& rows) {
  std::vector<double> known;
  std::vector<double> ratios;
  std::vector<double> travels;
  std::uint32_t contacts = 0;
  std::size_t complete = 0;
  for (const Row& row : rows) {
    known.push_back(row.known);
    ratios.push_back(row.drive.travel / row.tour);
    travels.push_back(row.drive.travel);
    contacts += row.drive.contacts;
    complete += row.drive.complete ? 1 : 0;
  }
  std::printf(
      "%s",
      fmt::format("{}: {} of {} complete, known {:.2f} % on average, {:.2f} % at least; travel {:.0f} m, "
                  "{:.2f} of the tour's; {} contacts\n",
                  kind, complete, known.size(), 100.0 * mean(known), 100.0 * *std::ranges::min_element(known),
                  mean(travels), mean(ratios), contacts)
          .c_str());
}

/// What is explored with a seed.
using MakeBuilding = std::function<buildings::Building(std::uint64_t)>;

void explore_all(const std::string& kind, const MakeBuilding& make, const BenchExploreArguments& arguments,
                 ordered_json& drives) {
  std::vector<Row> rows;
  for (int i = 0; i < arguments.seeds; ++i) {
    BenchExploreArguments one = arguments;
    one.drive.seed = arguments.first + static_cast<std::uint64_t>(i);
    const buildings::Building building = make(one.drive.seed);
    rows.push_back(explored(building, one));
    print(building.name, rows.back());
    drives.push_back(json_of(building.name, rows.back()));
  }
  sum_up(kind, rows);
}

}  // namespace

int bench_explore(const BenchExploreArguments& arguments) {
  ordered_json drives = ordered_json::array();
  if (!arguments.map.empty()) {
    const OccupancyGrid map = load_map(arguments.map);
    const std::string name = std::filesystem::path(arguments.map).stem().string();
    if (arguments.start.size() != 2) throw std::runtime_error("--start: must be X,Y [m]");
    const Vector2 start{arguments.start[0], arguments.start[1]};
    const auto make = [&](std::uint64_t seed) {
      return buildings::building_of_map(fmt::format("{} {}", name, seed), map, start);
    };
    explore_all(name, make, arguments, drives);
  } else {
    for (const buildings::BuildingKind kind : arguments.kinds) {
      const auto make = [&](std::uint64_t seed) { return buildings::make_building(kind, seed); };
      explore_all(buildings::to_text(kind), make, arguments, drives);
    }
  }
  write_json(arguments.json, {{"drives", std::move(drives)}});
  return 0;
}

}  // namespace bw
