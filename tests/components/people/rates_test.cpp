// Detector and tracker at other rates and with other scanners than parameters were chosen for, with two
// lasers and with a camera: a row for each, in the same rooms.
//
//   BANDWAGON_PEOPLE_MINUTES=2 test_people_rates          the table of components/people/README.md
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/people/perception_rooms.hpp"

namespace bw::people::test {
namespace {

struct Row {
  std::string name;
  SceneOptions scene;
};

const std::vector<Row> kRows = {
    {"5 Hz, 720 beams", {.laser_rate = 5.0}},
    {"10 Hz, 720 beams", {}},
    {"20 Hz, 720 beams", {.laser_rate = 20.0}},
    {"40 Hz, 720 beams", {.laser_rate = 40.0}},
    {"10 Hz, 360 beams", {.beams = 360}},
    {"10 Hz, 1440 beams", {.beams = 1440}},
    {"5 Hz, 360 beams", {.laser_rate = 5.0, .beams = 360}},
    {"40 Hz, 1440 beams", {.laser_rate = 40.0, .beams = 1440}},
    {"front, 180 degrees", {.beams = 480, .front = true}},
    {"front and rear", {.beams = 480, .front = true, .rear = true}},
    {"270 degrees, camera", {.camera = true}},
    {"front and rear, camera", {.beams = 480, .front = true, .rear = true, .camera = true}},
};

/// Bare and furnished, robot standing and driving, 3 and 8 people.
RoomsRecord run_row(const SceneOptions& row, double seconds) {
  RoomsRecord all;
  std::uint64_t seed = first_seed(2951);
  for (const bool furnished : {false, true})
    for (const bool driving : {false, true})
      for (const int people : {3, 8}) {
        SceneOptions scene = row;
        scene.people = people;
        scene.furnished = furnished;
        scene.driving = driving;
        all.add(Trial(scene, {}, {}, seed++).run(seconds), seconds);
      }
  return all;
}

void print_costs(const RoomsRecord& rooms) {
  const std::vector<double>& all = rooms.milliseconds;
  const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  std::printf("%-34s a sweep costs %.2f ms, %.1f ms at most; %d false people, %d possible\n", "", mean,
              std::ranges::max(all), rooms.false_people, rooms.false_possible);
}

// Floors for a few seconds of each room, below what is asked at 10 Hz and what the table of the README has.
TEST(Rates, FollowPeopleWithAnyScanner) {
  const double seconds = seconds_each(6.0);
  print_heading();
  for (const Row& row : kRows) {
    const RoomsRecord rooms = run_row(row.scene, seconds);
    print_line(row.name, rooms.score);
    print_costs(rooms);
    EXPECT_GE(rooms.score.recall(), 0.6) << row.name;
    EXPECT_GE(rooms.score.precision(), 0.85) << row.name;
    EXPECT_LE(rooms.score.motp(), 0.1) << row.name;
  }
}

}  // namespace
}  // namespace bw::people::test
