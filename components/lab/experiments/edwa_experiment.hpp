// Experiments E3 and E4 (Table 3.2, Figure 3.4; protocols.md 8.3, 8.4): DWA against EDWA where the obstacles
// are robots with a planner of their own.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/edwa_scenes.hpp"
#include "components/lab/experiments/shared_floor.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw {

/// Robot under test and the others, by planner name.
struct EdwaPairing {
  std::string_view robot;
  std::string_view others;
};

/// "EDWA-DWA": robot under test first, as Table 3.2 writes it.
std::string to_string(const EdwaPairing& pairing);

constexpr std::array<EdwaPairing, 3> kEdwaPairings = {EdwaPairing{"dwa", "dwa"}, EdwaPairing{"edwa", "dwa"},
                                                      EdwaPairing{"edwa", "edwa"}};

/// Table 3.1, and no more than what was published: no carrot, no evasive move, no way out of the margin.
PlannerOptions published_edwa_options();
FloorRules published_edwa_rules();

inline constexpr std::uint64_t kEdwaSeeds = 40;  ///< with fewer only what must hold of every run is judged

struct EdwaExperimentOptions {
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = kEdwaSeeds;
  PlannerOptions planners = published_edwa_options();
  FloorRules rules = published_edwa_rules();
};

/// One run. Of all, contacts and timeouts too, except where said.
struct EdwaRun {
  std::uint64_t seed = 0;
  FloorOutcome outcome = FloorOutcome::timeout;
  double time = 0.0;          ///< [s]
  double mean_speed = 0.0;    ///< average passing velocity (dwa/theory.md 5.5) [m/s]
  double smallest_gap = 0.0;  ///< [m]
  double max_delta = 0.0;     ///< largest delta_min(t); 1 on contact
  double lowest_v = 0.0;      ///< commanded after the time that speeding up from rest takes [m/s]
  bool others_touched = false;
  int not_ok = 0;  ///< cycles without an admissible velocity
};

struct EdwaRow {
  int scene = 0;  ///< from 0
  EdwaPairing pairing;
  double published = 0.0;  ///< [m/s]
  // Passing velocity over the runs that reached the goal [m/s]; NaN without one.
  double mean = 0.0;
  double sd = 0.0;
  int success = 0;
  int contacts = 0;
  int timeouts = 0;
  double mean_max_delta = 0.0;
  double lowest_v = 0.0;
  /// Over the seeds that reached the goal both here and with DWA-DWA: mean of this row's passing velocity
  /// less that one's [m/s]. The means alone compare all runs of EDWA with the easy ones of DWA.
  double gain_on_same_seeds = 0.0;
  std::vector<EdwaRun> runs;
  std::vector<FloorSample> example;  ///< course of the first seed's run
};

struct EdwaTable {
  std::vector<EdwaRow> rows;  ///< scene by scene, in the order of kEdwaPairings
  std::vector<Criterion> criteria;
};

/// Called after every row with its number from 1 and the count of rows.
using EdwaProgress = std::function<void(const EdwaRow& row, int done, int all)>;

/// delta_min of a gap [m], exp(-(d/3)^2) (dwa/theory.md 5.5; as printed the sign is inside the square); 1 on
/// contact.
double delta_min(double gap);

EdwaTable run_edwa_experiment(const EdwaExperimentOptions& options, const EdwaProgress& progress = {});

/// One run with its course.
FloorRun run_edwa_scene(int scene, const EdwaPairing& pairing, std::uint64_t seed,
                        const EdwaExperimentOptions& options);

}  // namespace bw
