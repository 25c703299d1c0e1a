// How a run of the tracker agrees with one stretch of labels: CLEAR MOT at the labelled instants, every error
// by its time and position, what was only thought possible, and how far and how surely predictions came true.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "components/people/score/clear_mot.hpp"
#include "components/people/score/labelled_paths.hpp"

namespace bw::people {

/// What the tracker said after one sweep, in O.
struct TrackedSweep {
  double time = 0.0;  ///< [s], on the clock of the labels
  std::vector<TrackedPerson> people;
};

struct StretchOptions {
  double longest_step = 1.0;  ///< between labels of somebody who walks straight on [s]
  double sweep_distance =
      0.25;  ///< of the sweep nearest to a labelled instant at most [s]; else there were no tracks
  double label_deviation = 0.0;  ///< of positions of labels, added to predicted ellipses [m]
  double horizon_step = 0.8;     ///< predictions are looked at so far ahead, twice as far, ... [s]
};

enum class TrackError {
  miss,           ///< somebody who counts without a confirmed track
  false_track,    ///< a confirmed track where nobody is
  other_identity  ///< somebody's track is not the one that followed them before
};

struct TrackErrorAt {
  double time = 0.0;  ///< of the label [s]
  TrackError kind = TrackError::miss;
  std::uint32_t id = 0;  ///< of the person, or of the false track
  Vector2 position{0.0, 0.0};
  bool is_possible = false;  ///< of a miss: a track says that a person may be there
};

/// Predictions of confirmed tracks that follow somebody, `ahead` [s] of the sweep.
struct HorizonScore {
  double ahead = 0.0;
  long count = 0;
  double distance = 0.0;  ///< sum over all [m]
  long inside = 0;        ///< truths within the 95 % ellipse

  double mean_error() const { return distance / static_cast<double>(count); }
  double share_inside() const { return static_cast<double>(inside) / static_cast<double>(count); }
  void add(const HorizonScore& other);
};

struct StretchScore {
  /// At the labelled instants; times to confirm at every sweep between the first and the last, with people
  /// between their labels where the path from one to the next leads.
  Score clear_mot;
  long instants = 0;
  long possible_at_misses = 0;       ///< misses where a track says that a person may be there
  long possible_elsewhere = 0;       ///< tracks of possible people where nobody is
  std::vector<TrackErrorAt> errors;  ///< by time
  std::map<std::uint32_t, std::set<std::uint32_t>>
      tracks;                          ///< by person who counts, those that followed them
  std::vector<HorizonScore> horizons;  ///< rising

  double tracks_per_person() const;
  /// Of other people: ids are not the same ones.
  void add(const StretchScore& other);
};

/// Both rise in time.
StretchScore score_stretch(const std::vector<LabelledInstant>& labels,
                           const std::vector<TrackedSweep>& sweeps, const StretchOptions& options);

}  // namespace bw::people
