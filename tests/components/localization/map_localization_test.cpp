// Localization by wheels and laser in known maps: tracking, start anywhere, carried away. Conditions of the
// measurements of AMCL and Beluga: 20 x 20 m, 5 cm cells, rooms that look alike, 60 beams, an update every
// 0.26 m. Full numbers of trials: BANDWAGON_LOCALIZATION_TRIALS=20.
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/components/localization/laser_scene.hpp"
#include "tests/components/localization/map_localization_trial.hpp"

namespace bw::localization {
namespace {

using test::DriveRecord;

int trials() {
  const char* asked = std::getenv("BANDWAGON_LOCALIZATION_TRIALS");
  return asked == nullptr ? 5 : std::atoi(asked);
}

struct Summary {
  int trials = 0;
  int found = 0;
  double updates = 0.0;  ///< mean of those found
  int most_updates = 0;
  double milliseconds = 0.0;  ///< mean per update
  double longest = 0.0;       ///< call [ms]
  double lost_after = 0.0;    ///< longest [s]; infinite when not every trial reported LOST

  void add(const DriveRecord& record, int limit) {
    ++trials;
    const std::optional<int> after = record.found_after();
    if (after && *after <= limit) {
      ++found;
      updates += *after;
      most_updates = std::max(most_updates, *after);
    }
    milliseconds += DriveRecord::mean(record.milliseconds);
    longest = std::max(longest, record.longest_call);
    lost_after = std::max(lost_after, record.lost_after.value_or(1e9));
  }
  void print(const std::string& what) {
    std::printf(
        "%-40s found %d/%d, mean %.1f, most %d updates; %.2f ms/update, longest call %.2f ms; LOST after <= "
        "%.1f s\n",
        what.c_str(), found, trials, updates / std::max(1, found), most_updates, milliseconds / trials,
        longest, lost_after);
  }
};

void print_tracking(const std::string& what, const DriveRecord& r) {
  std::printf(
      "%-40s RMSE %.3f m, max %.3f m, heading %.4f rad, NEES %.2f, particles %.0f, %.2f ms/update, longest "
      "%.2f ms, LOST %d of %d\n",
      what.c_str(), r.rmse(), r.worst(), DriveRecord::mean(r.heading_errors), DriveRecord::mean(r.nees),
      DriveRecord::mean(r.particles), DriveRecord::mean(r.milliseconds), r.longest_call, r.lost_sweeps,
      r.sweeps);
}

const test::SensorNoise kPeople{.people = 6, .random_returns = 0.05};

TEST(MapLocalization, Tracking) {
  for (int t = 0; t < trials(); ++t) {
    const OccupancyGrid map = test::repeated_rooms(1 + static_cast<std::uint64_t>(t));
    const test::Roads roads(map);
    print_tracking("rooms", test::track(map, roads, {}, {}, 100 + static_cast<std::uint64_t>(t), 332));
    print_tracking("rooms, people",
                   test::track(map, roads, {}, kPeople, 100 + static_cast<std::uint64_t>(t), 332));
  }
}

TEST(MapLocalization, StartAnywhere) {
  Summary plain;
  Summary people;
  for (int t = 0; t < trials(); ++t) {
    const OccupancyGrid map = test::repeated_rooms(1 + static_cast<std::uint64_t>(t));
    const test::Roads roads(map);
    plain.add(test::start_anywhere(map, roads, {}, {}, 200 + static_cast<std::uint64_t>(t), 80), 25);
    people.add(test::start_anywhere(map, roads, {}, kPeople, 200 + static_cast<std::uint64_t>(t), 80), 25);
  }
  plain.print("rooms, start anywhere");
  people.print("rooms, people, start anywhere");
}

TEST(MapLocalization, CarriedAway) {
  Summary plain;
  Summary people;
  for (int t = 0; t < trials(); ++t) {
    const OccupancyGrid map = test::repeated_rooms(1 + static_cast<std::uint64_t>(t));
    const test::Roads roads(map);
    plain.add(test::kidnap(map, roads, {}, {}, 300 + static_cast<std::uint64_t>(t), 80, 8.0), 30);
    people.add(test::kidnap(map, roads, {}, kPeople, 300 + static_cast<std::uint64_t>(t), 80, 8.0), 30);
  }
  plain.print("rooms, carried away");
  people.print("rooms, people, carried away");
}

class RecordedMap : public testing::TestWithParam<std::pair<const char*, double>> {};
TEST_P(RecordedMap, TrackingStartAnywhereCarriedAway) {
  const auto map = test::recorded_map(GetParam().first);
  if (!map) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded maps are not at hand";
  const test::Roads roads(map->grid);
  Summary anywhere;
  Summary away;
  for (int t = 0; t < trials(); ++t) {
    print_tracking(map->name,
                   test::track(map->grid, roads, {}, kPeople, 400 + static_cast<std::uint64_t>(t), 332));
    anywhere.add(test::start_anywhere(map->grid, roads, {}, kPeople, 500 + static_cast<std::uint64_t>(t), 80),
                 25);
    away.add(test::kidnap(map->grid, roads, {}, kPeople, 600 + static_cast<std::uint64_t>(t), 80,
                          GetParam().second),
             30);
  }
  anywhere.print(map->name + ", start anywhere");
  away.print(map->name + ", carried away");
}
INSTANTIATE_TEST_SUITE_P(MapLocalization, RecordedMap,
                         testing::Values(std::pair{"tb3_sandbox", 2.0}, std::pair{"small_house", 4.0},
                                         std::pair{"warehouse", 8.0}));

}  // namespace
}  // namespace bw::localization
