// What a sweep tells of who is a person, beside what each sighting does (cluster_track): who walks, and what
// stands about as furniture does.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/people/tracker/birth.hpp"
#include "components/people/tracker/evidence/past_sweeps.hpp"
#include "components/people/tracker/evidence/row_of_posts.hpp"
#include "components/people/tracker/person_track.hpp"

namespace bw::people {

/// The evidence for somebody just born of these clusters; `second` may be null.
Existence existence_of(const Birth& birth, const ClusterTrack& first, const ClusterTrack* second);

/// Whether something that stands may be the leg of somebody, or both in one, and should be told of.
bool may_be_somebody(const ClusterTrack& cluster);

/// For how long two legs are in view that have gone nowhere [s]; nothing of others, or where one is missing
/// (null).
std::optional<double> stood(const ClusterTrack* one, const ClusterTrack* other, const BirthOptions& options);

class Weighing {
 public:
  /// Sweep number `sweep` at `time` [s], `dt` [s] after the same sensor's before. `sensor`: where it is, or
  /// the first of several.
  void weigh(std::vector<PersonTrack>& people, std::vector<ClusterTrack>& clusters, std::int64_t sweep,
             double time, double dt, const Vector2& sensor, const BirthOptions& options);

  /// A sweep in S, to be remembered.
  void remember(const DetectionSet& sweep, double now) { past_.add(sweep, now); }
  void reset();

  /// What is about says of somebody: other things that look like legs, and how few people are known. `stood`:
  /// of stood().
  void weigh_surroundings(std::optional<double> stood, Existence& existence) const;

 private:
  void find_posts(const std::vector<PersonTrack>& people, const std::vector<ClusterTrack>& clusters,
                  std::int64_t sweep);
  double row_at(const ClusterTrack& thing, const ClusterTrack* other);
  void weigh_cluster(ClusterTrack& cluster, double gain);
  void look_up(ClusterTrack& thing, double now) const;
  /// How sure it is that more than so many things like legs stand about, 0 to 1.
  double furnished_beyond(double things) const;
  double alone_of(double stood) const;
  void count_company(const std::vector<PersonTrack>& people, double dt);
  void weigh_coming(PersonTrack& person, std::int64_t sweep, double now) const;
  static void weigh_rigidity(PersonTrack& person, std::int64_t sweep, double dt);
  double shifts_of_legs(PersonTrack& person, std::int64_t sweep) const;
  void weigh_position(PersonTrack& person, std::int64_t sweep, double gain);
  void weigh_person(PersonTrack& person, std::int64_t sweep, double dt, double gain,
                    const BirthOptions& options);

  PastSweeps past_;
  std::vector<Post> posts_;
  std::vector<Post> near_;
  double clutter_ = 0.0;         ///< things that stand about and look like legs, lately
  double furniture_ = 0.0;       ///< the same, in the last minute
  double company_ = 0.0;         ///< people known to walk about, lately
  Vector2 stood_{0.0, 0.0};      ///< where the laser stands
  double standing_since_ = 0.0;  ///< [s]
  bool still_ = false;
};

}  // namespace bw::people
