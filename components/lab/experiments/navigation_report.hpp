// The integrated drives on the source's robots (components/README.md 7.5): Eddie and QBot 2e cross a hallway
// among people by their own senses, EKF, A* and a local planner. No number is published for it: asked is the
// goal, without a contact.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/success.hpp"
#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/published_value.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// A robot and the planner that drives it.
struct NavigationPair {
  std::string robot;       ///< "Eddie"
  std::string robot_file;  ///< by its name, in config/robots
  std::string planner;     ///< of local_planner
  std::string source;      ///< where the source shows it
  std::string published;   ///< what it says of it
  bool as_published =
      false;  ///< EDWA by dwa/theory.md 5.4 and not by the plan (dwa/theory.md 5.9); driven and reported, not judged
};

const std::vector<NavigationPair>& navigation_pairs();

inline constexpr std::int64_t kNavigationSeeds = 20;

/// The hallway of E6 that is judged: three walkers. The source's pictures show one to a few people; "full",
/// with six, is reported.
inline constexpr const char* kNavigationHallway = "light";

/// One drive, from its score card. Lengths in metres, times in seconds.
struct NavigationDrive {
  std::size_t pair = 0;  ///< of navigation_pairs()
  std::string hallway = kNavigationHallway;
  std::int64_t seed = 0;
  bool reached = false;
  std::string reason;  ///< why it ended
  int contacts = 0;    ///< of any kind: a person who walks into the standing robot counts too
  int contacts_at_speed = 0;
  double time = 0.0, path_length = 0.0, closest_person = 0.0;
  double max_collision_index = 0.0;
  double localization_rms = 0.0;
  std::string page = {};  ///< that plays the drive, beside the results; empty: none

  /// What is judged (components/evaluation/success.hpp).
  bool succeeded() const { return is_success(reached, contacts); }
};

/// What the card does not say stays 0.
NavigationDrive navigation_drive(std::size_t pair, const std::string& hallway, std::int64_t seed,
                                 const nlohmann::json& card);

struct NavigationResults {
  bool emulated =
      true;  ///< bases and lasers by their emulators; otherwise the world moves wheels and makes scans
  std::vector<NavigationDrive> drives;
};

/// Of one pair in one hallway over its seeds.
struct NavigationRow {
  std::size_t pair = 0;
  std::string hallway;
  std::size_t drives = 0, reached = 0, successes = 0;
  int contacts = 0, contacts_at_speed = 0;
  Spread time, path_length;  ///< of drives that reached the goal
  Spread closest_person, max_collision_index, localization_rms;
};
std::vector<NavigationRow> navigation_rows(const NavigationResults& results);

/// Each pair that is judged reaches the goal without a contact in all its drives through a hallway; with any
/// number of seeds.
std::vector<Criterion> navigation_criteria(const NavigationResults& results, const std::string& hallway);
std::vector<PublishedValue> published_values(const NavigationResults& results);

/// {experiment, emulated, rows, drives}
nlohmann::ordered_json navigation_json(const NavigationResults& results);
/// One line per row below a head.
std::string navigation_table(const NavigationResults& results);
/// What the page shows; `figures` of drives among it.
report::Document navigation_page(const NavigationResults& results,
                                 const std::vector<report::Figure>& figures);

}  // namespace bw
