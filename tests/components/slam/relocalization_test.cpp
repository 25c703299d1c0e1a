// A robot that finds itself in a map that was made before. Truth: where the building's drive says that it
// stands.
#include "components/slam/relocalization.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/walkable_cells.hpp"
#include "components/slam/graph_file.hpp"
#include "tests/components/slam/building_slam.hpp"

namespace bw::slam {
namespace {

using buildings::Building;
using buildings::BuildingKind;

int setting(const char* name, int fallback) {
  const char* text = std::getenv(name);
  return text == nullptr ? fallback : std::atoi(text);
}

/// Others than offices have places that look alike: there nothing is asked but that none is wrong.
BuildingKind kind() {
  return buildings::kBuildingKinds.at(static_cast<std::size_t>(setting("BANDWAGON_RELOCALIZATION_KIND", 0)));
}
bool is_office() { return kind() == BuildingKind::office; }

/// A map of a building, saved and read back, with nothing under way.
struct KnownBuilding {
  explicit KnownBuilding(std::uint64_t seed, double seconds)
      : building(buildings::make_building(kind(), seed)),
        walls(building.walls),
        drive(test::drive_in(building, seed, seconds)) {
    Slam made{SlamOptions{}};
    test::map_along(made, drive, 0, drive.scans.size());
    SavedGraph graph = *read_graph(graph_bytes({{}, made.save()})).graph;
    map = std::make_unique<Slam>(std::move(graph.slam));
    map->finish();
  }

  /// Where the map has what is at X_WB: by the scan of the map nearest to it, so that how far the map is
  /// bent does not count.
  Pose2 in_map(const Pose2& X_WB) const {
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < drive.X_WB.size(); ++k)
      if ((drive.X_WB[k].position() - X_WB.position()).norm() <
          (drive.X_WB[nearest].position() - X_WB.position()).norm())
        nearest = k;
    const Time time = drive.scans[nearest].time;
    const auto of_map =
        std::min_element(map->nodes().begin(), map->nodes().end(), [&](const auto& a, const auto& b) {
          return std::abs((a.second.time - time).nanoseconds) < std::abs((b.second.time - time).nanoseconds);
        });
    const Node& node = of_map->second;
    const auto scan = std::find_if(drive.scans.begin(), drive.scans.end(),
                                   [&](const Scan& s) { return s.time == node.time; });
    const Pose2& X_WN = drive.X_WB[static_cast<std::size_t>(scan - drive.scans.begin())];
    return map->pose(node.placement) * (inverse(X_WN) * X_WB);
  }

  Building building;
  buildings::WallIndex walls;
  test::BuildingDrive drive;
  std::unique_ptr<Slam> map;
};

const KnownBuilding& office() {
  static const KnownBuilding known(3, setting("BANDWAGON_RELOCALIZATION_SECONDS", 90));
  return known;
}

bool is_right(const Pose2& X_MB, const Pose2& truth) {
  const Eigen::Vector3d d = difference(X_MB, truth);
  return d.head<2>().norm() < 0.15 && std::abs(d.z()) < 0.05;
}

struct Tally {
  int right = 0;
  int wrong = 0;
  int doubt = 0;
};

// Standing still, facing anywhere, up to 1 m beside where the robot of the map drove. One scan may fit
// several places; then nothing is said.
TEST(Relocalization, OneScanTellsThePlaceOrNothing) {
  const KnownBuilding& known = office();
  Random random(5);
  Tally tally;
  const int places = setting("BANDWAGON_RELOCALIZATIONS", 20);
  for (int n = 0; n < places;) {
    const auto k =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(known.drive.X_WB.size())));
    const Pose2 X_WB{known.drive.X_WB[k].x + random.uniform(-0.7, 0.7),
                     known.drive.X_WB[k].y + random.uniform(-0.7, 0.7), random.uniform(-3.1, 3.1)};
    if (known.walls.clearance(X_WB.position(), 1.0) < 0.3) continue;
    const Vector2 way = X_WB.position() - known.drive.X_WB[k].position();
    if (known.walls.ray_hit(known.drive.X_WB[k].position(), way.normalized(), 2.0) < way.norm()) continue;
    ++n;
    PlaceSearch search(*known.map);
    search.add(test::scan_at(known.walls, X_WB, random), {});
    while (search.advance()) {
    }
    if (!search.place()) {
      ++tally.doubt;
    } else if (is_right(search.place()->X_MB, known.in_map(X_WB))) {
      ++tally.right;
    } else {
      ++tally.wrong;
    }
  }
  std::printf("standing at %d places: %d right, %d wrong, %d in doubt\n", places, tally.right, tally.wrong,
              tally.doubt);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GE(tally.right, is_office() ? places * 9 / 10 : 0);
}

// Driving on from moments of another drive, with other noise and odometry that counts from where it
// starts.
TEST(Relocalization, ADriveTellsThePlaceWithinFiveMetres) {
  const KnownBuilding& known = office();
  const test::BuildingDrive drive =
      test::drive_in(known.building, 77, setting("BANDWAGON_RELOCALIZATION_SECONDS", 90));
  Random random(6);
  Tally tally;
  const int places = setting("BANDWAGON_RELOCALIZATIONS", 20) / 2;
  for (int n = 0; n < places; ++n) {
    const auto first =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(drive.scans.size() - 60)));
    PlaceSearch search(*known.map);
    double travel = 0.0;
    std::size_t k = first;
    for (; k < drive.scans.size() && travel < 5.0 && !search.place(); ++k) {
      if (k > first) travel += (drive.X_WB[k].position() - drive.X_WB[k - 1].position()).norm();
      search.add(drive.scans[k], inverse(drive.X_OB[first]) * drive.X_OB[k]);
      while (search.advance()) {
      }
    }
    if (!search.place()) {
      ++tally.doubt;
    } else if (is_right(search.place()->X_MB, known.in_map(drive.X_WB[k - 1]))) {
      ++tally.right;
    } else {
      ++tally.wrong;
    }
  }
  std::printf("driving from %d places: %d right, %d wrong, %d in doubt after 5 m\n", places, tally.right,
              tally.wrong, tally.doubt);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GE(tally.right, is_office() ? places * 19 / 20 : 0);
}

// In another office, whose rooms are much like those of the map: no place is the right answer.
TEST(Relocalization, FindsNoPlaceInAnotherBuilding) {
  const KnownBuilding& known = office();
  const test::BuildingDrive elsewhere =
      test::drive_in(buildings::make_building(BuildingKind::office, 8), 8, 60.0);
  const auto tries = static_cast<std::size_t>(setting("BANDWAGON_RELOCALIZATIONS", 20) / 10);
  for (std::size_t n = 0; n < tries; ++n) {
    const std::size_t first = n * (elsewhere.scans.size() - 60) / tries;
    PlaceSearch search(*known.map);
    for (std::size_t k = first; k < first + 50; ++k) {  // 5 m
      search.add(elsewhere.scans[k], elsewhere.X_OB[k]);
      while (search.advance()) {
      }
    }
    EXPECT_FALSE(search.place()) << "from scan " << first;
  }
}

// A click that is 0.6 m and 20 degrees off, and one in another room.
TEST(Relocalization, AGivenPoseIsCorrectedOrRefused) {
  const KnownBuilding& known = office();
  const test::BuildingDrive& drive = known.drive;
  Random random(7);
  int right = 0;
  for (int n = 0; n < 20; ++n) {
    const auto k = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(drive.scans.size())));
    const Pose2 truth = known.in_map(drive.X_WB[k]);
    const auto place =
        place_near(*known.map, drive.scans[k].points,
                   {truth.x + 0.4, truth.y - 0.4, wrap_angle(truth.theta + 0.35)}, {1.0, 1.0, 0.6});
    // Along a bare corridor a scan does not say where: the place that was given is kept.
    if (place && is_right(place->X_MB, truth)) ++right;
  }
  EXPECT_GE(right, 15);
  const Pose2 far = known.in_map(drive.X_WB.front());
  EXPECT_FALSE(
      place_near(*known.map, drive.scans.back().points, {far.x + 300.0, far.y, 0.0}, {1.0, 1.0, 0.6}));
}

}  // namespace
}  // namespace bw::slam
