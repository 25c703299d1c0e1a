// Localization by wheels and laser in known maps: tracking, start anywhere, carried away. Conditions of the
// measurements of AMCL and Beluga: 20 x 20 m, 5 cm cells, rooms that look alike, 60 beams, an update every
// 0.26 m. Full numbers of trials: BANDWAGON_LOCALIZATION_TRIALS=20.
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/components/localization/laser_scene.hpp"
#include "tests/components/localization/map_localization_trial.hpp"
#include "tests/shortfall.hpp"

namespace bw::localization {
namespace {

using test::DriveRecord;

int trials() {
  const char* asked = std::getenv("BANDWAGON_LOCALIZATION_TRIALS");
  return asked == nullptr ? 3 : std::atoi(asked);
}

// Of several drives: how many found the pose in time, and what they cost.
struct Found {
  int trials = 0;
  int found = 0;
  double updates = 0.0;  ///< mean of those found
  int most_updates = 0;
  double milliseconds = 0.0;  ///< mean per update
  double longest = 0.0;       ///< call [ms]
  double unreported = 0.0;    ///< longest time that the estimate was wrong and health not LOST [s]
  int reported = 0;  ///< drives in which that was 3 s at most: longer only where the place looks alike

  void add(const DriveRecord& record, int limit) {
    const std::optional<int> after = record.found_after();
    if (after && *after <= limit) {
      updates = (updates * found + *after) / (found + 1);
      most_updates = std::max(most_updates, *after);
      ++found;
    }
    milliseconds = (milliseconds * trials + DriveRecord::mean(record.milliseconds)) / (trials + 1);
    ++trials;
    longest = std::max(longest, record.longest_call);
    unreported = std::max(unreported, record.longest_unreported);
    if (record.longest_unreported <= 3.05) ++reported;  // half a sweep's time for rounding
  }
  void print(const std::string& what) const {
    std::printf(
        "%-36s %d/%d, updates mean %.1f most %d, %.2f ms/update, longest call %.2f ms, unreported %.1f s (%d "
        "within 3 s)\n",
        what.c_str(), found, trials, updates, most_updates, milliseconds, longest, unreported, reported);
  }
};

// 19 of 20, and one failure in a shorter run.
int enough(int trials) { return trials - 1; }

struct Tracked {
  int trials = 0;
  double rmse = 0.0;   ///< mean over the drives [m]
  double worst = 0.0;  ///< of all [m]
  double heading = 0.0;
  double nees = 0.0;
  double particles = 0.0;
  double milliseconds = 0.0;
  int lost = 0;

  void add(const DriveRecord& r) {
    const auto average = [this](double mean, double next) { return (mean * trials + next) / (trials + 1); };
    rmse = average(rmse, r.rmse());
    heading = average(heading, DriveRecord::mean(r.heading_errors));
    nees = average(nees, DriveRecord::mean(r.nees));
    particles = average(particles, DriveRecord::mean(r.particles));
    milliseconds = average(milliseconds, DriveRecord::mean(r.milliseconds));
    worst = std::max(worst, r.worst());
    lost += r.lost_sweeps;
    ++trials;
  }
  void print(const std::string& what) const {
    std::printf(
        "%-36s RMSE %.3f m, max %.3f m, heading %.4f rad, NEES(3) %.2f, particles %.0f, %.2f ms/update, LOST "
        "%d\n",
        what.c_str(), rmse, worst, heading, nees, particles, milliseconds, lost);
  }
};

const ParticleFilterOptions kDefaults;
const test::SensorNoise kPeople{.people = 6, .random_returns = 0.05};

std::uint64_t seed(int base, int trial) { return static_cast<std::uint64_t>(base + trial); }

// The bounds are the best that AMCL and Beluga reached on a map of this kind (0.074 m, 0.21 m, 837
// particles).
class Rooms : public testing::TestWithParam<bool> {
 protected:
  test::SensorNoise noise() const { return GetParam() ? kPeople : test::SensorNoise{}; }
  std::string named(const std::string& what) const {
    return (GetParam() ? "rooms, people: " : "rooms: ") + what;
  }
};
INSTANTIATE_TEST_SUITE_P(MapLocalization, Rooms, testing::Bool(),
                         [](const auto& people) { return people.param ? "WithPeople" : "Empty"; });

TEST_P(Rooms, Tracking) {
  Tracked tracked;
  for (int t = 0; t < trials(); ++t) {
    const OccupancyGrid map = test::repeated_rooms(seed(1, t));
    const DriveRecord record = test::track(map, test::Roads(map), kDefaults, noise(), seed(100, t), 332);
    EXPECT_EQ(record.errors.size(), 332U);
    EXPECT_LE(record.rmse(), 0.08);
    tracked.add(record);
  }
  tracked.print(named("tracking"));
  EXPECT_LE(tracked.worst, 0.21);
  EXPECT_LE(tracked.particles, 850.0);
  EXPECT_EQ(tracked.lost, 0);
}

TEST_P(Rooms, StartAnywhere) {
  Found found;
  for (int t = 0; t < trials(); ++t) {
    const OccupancyGrid map = test::repeated_rooms(seed(1, t));
    found.add(test::start_anywhere(map, test::Roads(map), kDefaults, noise(), seed(200, t), 60), 25);
  }
  found.print(named("start anywhere"));
  EXPECT_GE(found.found, enough(trials()));
  EXPECT_GE(found.reported, enough(trials()));
}

TEST_P(Rooms, CarriedAway) {
  Found found;
  // In a crowd what is asked is not reached: as many drives as the README's figure has, so that a loss is
  // seen.
  const int drives = GetParam() ? std::max(trials(), 20) : trials();
  for (int t = 0; t < drives; ++t) {
    const OccupancyGrid map = test::repeated_rooms(seed(1, t));
    found.add(test::kidnap(map, test::Roads(map), kDefaults, noise(), seed(300, t), 60, 8.0), 30);
  }
  found.print(named("carried away"));
  EXPECT_GE(found.found, enough(drives));
  // In a crowd a look-alike room agrees for a while: 17 of 20. Seeds are fixed, so that one drive more or
  // less is what a change of something else, or another CPU, may do; binomial noise of 20 drives would be
  // 2.6.
  if (GetParam()) {
    bw::test::expect_at_least("share of drives in which LOST is said within 3 s",
                              {.asked = 1.0, .measured = 17.0 / 20.0, .noise = 1.0 / drives},
                              found.reported / double(drives));
  } else {
    EXPECT_GE(found.reported, enough(trials()));
  }
}

struct Recorded {
  const char* name;
  double away;  ///< as far as the map allows [m]
};

class RecordedMap : public testing::TestWithParam<Recorded> {};
TEST_P(RecordedMap, TrackingAmongPeopleStartAnywhereCarriedAway) {
  const auto map = test::recorded_map(GetParam().name);
  if (!map) GTEST_SKIP() << "BANDWAGON_SHARED is not set: recorded maps are not at hand";
  const test::Roads roads(map->grid);
  Tracked tracked;
  Found anywhere;
  Found away;
  for (int t = 0; t < trials(); ++t) {
    tracked.add(test::track(map->grid, roads, kDefaults, kPeople, seed(400, t), 332));
    anywhere.add(test::start_anywhere(map->grid, roads, kDefaults, {}, seed(500, t), 60), 25);
    away.add(test::kidnap(map->grid, roads, kDefaults, {}, seed(600, t), 60, GetParam().away), 30);
  }
  tracked.print(map->name + ": tracking among people");
  anywhere.print(map->name + ": start anywhere");
  away.print(map->name + ": carried away");
  EXPECT_LE(tracked.rmse, 0.08);
  EXPECT_GE(anywhere.found, enough(trials()));
  EXPECT_GE(away.found, enough(trials()));
}
INSTANTIATE_TEST_SUITE_P(MapLocalization, RecordedMap,
                         testing::Values(Recorded{"tb3_sandbox", 2.0}, Recorded{"small_house", 4.0},
                                         Recorded{"warehouse", 8.0}),
                         [](const auto& map) { return std::string(map.param.name); });

}  // namespace
}  // namespace bw::localization
