// Experiment E2 (particle_filter/theory.md 4.3, protocols.md 8.2): the particle filter of the dissertation's
// Table 2.1. A circle, its middle third under a roof, where four sets of readings are available.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "components/lab/experiments/criterion.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// What is received under the roof; outside all three.
struct PfRow {
  std::string_view name;
  bool position;
  bool heading;
  double published_encoder;   ///< mean error [m]
  double published_proposed;  ///< the same
};

constexpr std::array<PfRow, 4> kPfRows{{
    {"[x, y, theta]", true, true, 0.2510, 0.1098},
    {"[x, y]", true, false, 0.2479, 0.1451},
    {"[theta]", false, true, 0.9648, 0.2406},
    {"[]", false, false, 0.9722, 0.3957},
}};

enum class PfMethod {
  encoder,           ///< the last fix with its heading, and from there wheels alone (reading D3)
  dead_reckoning,    ///< wheels alone from the start
  gaussian,          ///< particle filter, weights exp(-d^2 / 2): the default here
  printed,           ///< exp(-EN^0.4 / 2) as printed, errors in standard deviations
  printed_unscaled,  ///< the same with errors in metres and radians as they are
};
constexpr std::array<PfMethod, 5> kPfMethods{PfMethod::encoder, PfMethod::dead_reckoning, PfMethod::gaussian,
                                             PfMethod::printed, PfMethod::printed_unscaled};
std::string_view to_string(PfMethod method);

inline constexpr std::uint64_t kPfSeeds = 100;  ///< with fewer nothing is judged

struct PfExperimentOptions {
  int particles = 1000;
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = kPfSeeds;
};

/// Of the circle driven, from (0, 0) along x to the left [m].
inline constexpr double kPfRadius = 15.0;
/// Under the roof lie the times after `kPfRoofFrom` up to `kPfRoofTo` [s].
inline constexpr double kPfRoofFrom = 28.0;
inline constexpr double kPfRoofTo = 56.0;

/// One step of a run.
struct PfSample {
  double time = 0.0;  ///< [s]
  Vector2 truth{0.0, 0.0};
  Vector2 estimate{0.0, 0.0};
};

/// The course of one run. The same seed has the same motion and the same readings for every row and method.
std::vector<PfSample> drive_pf(const PfRow& row, PfMethod method, std::uint64_t seed, int particles);

/// Mean over all steps of one run of the distance [m] between estimate and truth.
double run_pf_experiment(const PfRow& row, PfMethod method, std::uint64_t seed, int particles);

/// One cell of the table.
struct PfCell {
  PfMethod method = PfMethod::encoder;
  std::vector<double> errors;  ///< by seed [m]
  double mean = 0.0;
  double low = 0.0;               ///< quantile 5 %
  double high = 0.0;              ///< quantile 95 %
  std::vector<PfSample> example;  ///< course of the first seed
};

struct PfTable {
  PfExperimentOptions options;
  std::array<std::vector<PfCell>, kPfRows.size()> cells;  ///< by row, in the order of kPfMethods
  std::vector<Criterion> criteria;                        ///< of `gaussian`
};

/// Called after every cell with its number from 1.
using PfProgress = std::function<void(const PfRow& row, const PfCell& cell, int done, int all)>;

PfTable run_pf_experiments(const PfExperimentOptions& options, const PfProgress& progress = {});

/// What E2 must show (protocols.md 8.2), asked of one method.
std::vector<Criterion> pf_criteria(const PfTable& table, PfMethod method);

}  // namespace bw
