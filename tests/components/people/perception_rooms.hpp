// The twenty rooms that perception is measured in, a line of figures for each, and their sum.
//   BANDWAGON_PEOPLE_MINUTES  minutes of each room, in place of the few seconds of every day
//   BANDWAGON_PEOPLE_SEED     seed of the first room; the others follow one by one
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/components/people/perception_trial.hpp"

namespace bw::people::test {

inline constexpr std::array<int, 5> kPeopleInRooms = {1, 3, 6, 10, 20};

inline double seconds_each(double in_short) {
  const char* minutes = std::getenv("BANDWAGON_PEOPLE_MINUTES");
  return minutes == nullptr ? in_short : 60.0 * std::atof(minutes);
}

inline std::uint64_t first_seed(std::uint64_t of_every_day) {
  const char* seed = std::getenv("BANDWAGON_PEOPLE_SEED");
  return seed == nullptr ? of_every_day : std::strtoull(seed, nullptr, 10);
}

/// Of all rooms together.
struct RoomsRecord {
  Score score;
  int false_people = 0;
  int false_possible = 0;
  double minutes = 0.0;
  std::vector<double> milliseconds;

  double false_people_per_ten_minutes() const { return 10.0 * false_people / minutes; }
  void add(const TrialRecord& room, double seconds) {
    score.add(room.score);
    false_people += room.false_people;
    false_possible += room.false_possible;
    minutes += seconds / 60.0;
    milliseconds.insert(milliseconds.end(), room.milliseconds.begin(), room.milliseconds.end());
  }
};

inline void print_heading() {
  std::printf(
      "%-34s %6s  %6s %6s %6s %6s  %6s %6s  %5s %6s  %5s %5s  %6s  %5s  (switches per 10 person-min; walkers: plain "
      "view [s])\n",
      "room", "p-min", "recall", "prec.", "MOTA", "MOTP", "IDF1", "GOSPA", "sw.in", "sw.all", "w.50%",
      "w.95%", "veloc.", "steady");
}

inline void print_line(const std::string& room, const Score& score) {
  std::printf("%-34s %6.1f  %6.3f %6.4f %6.3f %6.3f  %6.3f %6.3f  %5.1f %6.1f  %5.2f %5.2f  %6.3f  %5.3f\n",
              room.c_str(), score.person_minutes(), score.recall(), score.precision(), score.mota(),
              score.motp(), score.idf1(), score.mean_gospa(), score.seen_switches_per_ten_minutes(),
              score.switches_per_ten_minutes(), score.walkers_confirmation_quantile(0.5),
              score.walkers_confirmation_quantile(0.95), score.velocity_rmse(), score.steady_rmse());
}

inline void print_false(const std::string& room, const TrialRecord& record) {
  std::printf("%-34s %d confirmed, %d possible, %.2f possible at once, %d at most; driven %.0f m\n",
              room.c_str(), record.false_people, record.false_possible, record.possible, record.most_possible,
              record.driven);
}

inline std::string name_of(const SceneOptions& scene, std::uint64_t seed) {
  return std::to_string(seed) + ": " + std::to_string(scene.people) + " people, " +
         (scene.crowded     ? "full"
          : scene.furnished ? "furnished"
                            : "bare") +
         (scene.driving ? ", driving" : ", standing");
}

inline void run_room(const SceneOptions& scene, std::uint64_t seed, double seconds, RoomsRecord& all) {
  const TrialRecord room = Trial(scene, {}, {}, seed).run(seconds);
  const std::string name = name_of(scene, seed);
  if (scene.people > 0) print_line(name, room.score);
  if (scene.people == 0) print_false(name, room);
  all.add(room, seconds);
}

/// Bare and furnished, robot standing and driving, 1 to 20 people.
inline RoomsRecord run_rooms(std::uint64_t seed, double seconds) {
  RoomsRecord all;
  print_heading();
  for (const bool furnished : {false, true})
    for (const bool driving : {false, true})
      for (const int people : kPeopleInRooms)
        run_room({.people = people, .furnished = furnished, .driving = driving}, seed++, seconds, all);
  print_line("all rooms", all.score);
  return all;
}

/// Full of furniture, robot driving; nobody there, or 1 to 20 people as above.
inline RoomsRecord run_full_rooms(std::uint64_t seed, double seconds, bool with_people,
                                  std::size_t rooms = 20) {
  RoomsRecord all;
  if (with_people) print_heading();
  for (std::size_t i = 0; i < rooms; ++i) {
    const int people = with_people ? kPeopleInRooms[i % kPeopleInRooms.size()] : 0;
    run_room({.people = people, .crowded = true}, seed++, seconds, all);
  }
  if (with_people) print_line("all full rooms", all.score);
  std::printf("%s: %d false people (%.2f in 10 minutes), %d possible, in %.0f minutes\n",
              with_people ? "beside people" : "nobody there", all.false_people,
              all.false_people_per_ten_minutes(), all.false_possible, all.minutes);
  return all;
}

}  // namespace bw::people::test
