// Where on the whole map can a sweep have been taken? The best distinct poses, found in slices.
//
// Correlative matching with bounds (Olson 2009; Hess et al. 2016): every heading and every coarse cell of
// free space gets an upper bound of its score from a table that holds the maximum of the likelihood field
// over the cell's size; then the cell with the highest bound is split in four, until what comes up is a
// finest cell: nothing left can beat it. What lies close to a pose already found is dropped.
#pragma once

#include <cstdint>
#include <vector>

#include "components/localization/laser/beam_ends.hpp"
#include "components/localization/laser/likelihood_field.hpp"
#include "components/localization/laser/pose_search_options.hpp"
#include "components/localization/laser/pose_search_tables.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::localization {

/// Pose X_MB with the mean over beams of log p, scaled: 0 when all end far from everything in the known part
/// of the map, 1 when all end at obstacles. So fit times a constant is the log-likelihood of the sweep.
struct PoseHypothesis {
  Pose2 X_MB;
  double fit = 0.0;
};

class PoseSearch {
 public:
  PoseSearch(const LikelihoodField& field, const PoseSearchOptions& options);

  /// Forgets a search under way. Of more than 120 ends, 120 spread over all are used.
  void begin(const BeamEnds& ends);
  /// Goes on for about as long as `nodes` poses take to compare one by one (60 beams: 50 to 100 ns each).
  /// True when the search is finished; true at once, with no results, without beams or free space.
  bool advance(int nodes);
  bool finished() const { return phase_ == Phase::finished; }

  /// Poses at the time of the sweep, best first. Empty until finished.
  const std::vector<PoseHypothesis>& results() const { return results_; }
  /// Poses that were bounded or compared so far.
  std::int64_t visited() const { return visited_; }

 private:
  enum class Phase { bounding, splitting, finished };

  /// Cells [x, x + 2^level) x [y, y + 2^level) of the table at one heading.
  struct Node {
    std::int32_t score = 0;
    std::uint16_t heading = 0;
    std::uint16_t level = 0;
    std::int32_t x = 0;
    std::int32_t y = 0;
  };
  struct Scored {
    Pose2 X_MB;
    std::int32_t score = 0;
  };

  static bool worse(const Node& a, const Node& b);
  void bound_heading();
  void note_candidate(std::int32_t bound);
  void split_best();
  Scored refined(Scored from) const;
  void finish();
  bool near_result(const Pose2& X_MB, double margin) const;
  double heading_of(std::size_t index) const;
  std::int32_t score(const Pose2& X_MB) const;
  Pose2 pose_of(const Node& node) const;
  double fit_of(std::int32_t score) const;

  PoseSearchOptions options_;
  PoseSearchTables tables_;
  std::size_t headings_;
  Phase phase_ = Phase::finished;
  BeamEnds ends_;
  std::vector<CellOffsets> offsets_;  ///< by heading
  std::size_t next_heading_ = 0;
  std::vector<std::int16_t> bounds_;
  std::vector<int> by_bound_;  ///< candidates by class of bounds
  int candidates_ = 0;
  std::int32_t least_candidate_ = 0;
  std::vector<Node> open_;        ///< a heap, once splitting
  std::int32_t least_score_ = 0;  ///< worse is not looked at
  std::vector<PoseHypothesis> results_;
  std::int64_t visited_ = 0;
};

}  // namespace bw::localization
