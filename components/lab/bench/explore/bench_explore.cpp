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

/// One rule to choose the next frontier.
struct Rule {
  const char* name;
  explore::ExplorerOptions options;
};

struct Row {
  std::string choice;
  ExploreDrive drive;
  double known = 0.0;
  double tour = 0.0;   ///< [m]
  double cpu_s = 0.0;  ///< of the whole simulation
};

std::vector<Rule> choices_of(const BenchExploreArguments& arguments) {
  explore::ExplorerOptions chosen = arguments.drive.explorer;
  chosen.return_to_init = false;
  std::vector<Rule> choices = {{"chosen", chosen}};
  chosen.gain_scale = 0.0;
  chosen.hysteresis = 0.0;
  if (arguments.nearest) choices.push_back({"nearest", chosen});
  return choices;
}

// Of a Kobuki.
Row explored_ideally(const buildings::Building& building, const Rule& choice,
                     const BenchExploreArguments& arguments) {
  Row row;
  row.choice = choice.name;
  IdealExplorationOptions options;
  options.range = kTourRange;
  options.longest = arguments.drive.longest;
  options.explorer = choice.options;
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

Row explored(const buildings::Building& building, const Rule& choice,
             const BenchExploreArguments& arguments) {
  if (arguments.ideal) return explored_ideally(building, choice, arguments);
  Row row;
  row.choice = choice.name;
  ExploreDriveOptions options = arguments.drive;
  options.explorer = choice.options;
  const double before = process_cpu_ms();
  row.drive = explore_building(building, options);
  row.cpu_s = 1e-3 * (process_cpu_ms() - before);
  if (row.drive.map)
    row.known = coverage(explorable(building, row.drive.radius, kResolution), *row.drive.map);
  row.tour = greedy_tour(explorable(building, row.drive.radius, kTourResolution), kTourRange);
  if (!arguments.maps.empty() && row.drive.map) {
    std::string name = building.name + "_" + choice.name;
    std::ranges::replace(name, ' ', '_');
    std::filesystem::create_directories(arguments.maps);
    save_map(*row.drive.map, std::filesystem::path(arguments.maps) / (name + ".yaml"), {});
  }
  return row;
}

void print(const std::string& building, const Row& r) {
  std::printf(
      "%s",
      fmt::format("{:<14} {:<8} known {:.2f} %  travel {:.0f} m ({:.2f} of the tour's {:.0f} m)  {:.0f} s  "
                  "contacts {}  CPU {:.0f} s  {}\n",
                  building, r.choice, 100.0 * r.known, r.drive.travel, r.drive.travel / r.tour, r.tour,
                  r.drive.time, r.drive.contacts, r.cpu_s, r.drive.status)
          .c_str());
  std::fflush(stdout);
}

ordered_json json_of(const std::string& building, const Row& r) {
  return {{"building", building},
          {"choice", r.choice},
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

void sum_up(const char* kind, const char* choice, const std::vector<Row>& rows) {
  std::vector<double> known;
  std::vector<double> ratios;
  std::vector<double> travels;
  std::uint32_t contacts = 0;
  std::size_t complete = 0;
  for (const Row& row : rows) {
    if (row.choice != choice) continue;
    known.push_back(row.known);
    ratios.push_back(row.drive.travel / row.tour);
    travels.push_back(row.drive.travel);
    contacts += row.drive.contacts;
    complete += row.drive.complete ? 1 : 0;
  }
  if (known.empty()) return;
  std::printf(
      "%s",
      fmt::format("{} {}: {} of {} complete, known {:.2f} % on average, {:.2f} % at least; travel {:.0f} m, "
                  "{:.2f} of the tour's; {} contacts\n",
                  kind, choice, complete, known.size(), 100.0 * mean(known),
                  100.0 * *std::ranges::min_element(known), mean(travels), mean(ratios), contacts)
          .c_str());
}

/// What is explored with a seed.
using MakeBuilding = std::function<buildings::Building(std::uint64_t)>;

void explore_all(const std::string& kind, const MakeBuilding& make, const BenchExploreArguments& arguments,
                 ordered_json& drives) {
  std::vector<Row> rows;
  const std::vector<Rule> choices = choices_of(arguments);
  for (int i = 0; i < arguments.seeds; ++i) {
    BenchExploreArguments one = arguments;
    one.drive.seed = arguments.first + static_cast<std::uint64_t>(i);
    const buildings::Building building = make(one.drive.seed);
    for (const Rule& choice : choices) {
      rows.push_back(explored(building, choice, one));
      print(building.name, rows.back());
      drives.push_back(json_of(building.name, rows.back()));
    }
  }
  for (const Rule& choice : choices) sum_up(kind.c_str(), choice.name, rows);
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
