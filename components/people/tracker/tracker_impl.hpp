// What the tracker keeps from sweep to sweep, and the steps of one (tracker.cpp); what others tell of is in
// tracker_external.cpp.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "components/model/random.hpp"
#include "components/people/tracker/birth.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/matching.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/seen_walls.hpp"
#include "components/people/tracker/sensor_order.hpp"
#include "components/people/tracker/sweep_alignment.hpp"
#include "components/people/tracker/tracker.hpp"
#include "components/people/tracker/weighing.hpp"

namespace bw::people {

class Tracker::Impl {
 public:
  explicit Impl(const TrackerOptions& options) : options_(options), alignment_(options.alignment) {}
  void set_options(const TrackerOptions& options) { options_ = options; }

  const std::vector<TrackedPerson>& update(const DetectionSet& sweep);
  const std::vector<TrackedPerson>& hear(const HeardSet& heard);
  const std::vector<TrackedPerson>& people() const { return reported_; }
  void keep_out(std::vector<Vector2>& positions) const;
  std::size_t cluster_count() const { return clusters_.size(); }
  void reset();

 private:
  void begin_at(Time time);
  void predict_to(Time time);
  void transform_to_S(const DetectionSet& sweep);
  void believe(const HeardPerson& told, double late, PersonTrack& person);
  void begin_with(const HeardPerson& told, double late);
  bool follow_legs_near(PersonTrack& person);
  bool is_told_of(const PersonTrack& person) const {
    return person.heard > 0.0 &&
           person.last_heard + Duration::seconds(ExternalDetectionOptions::kTold) >= *now_;
  }
  void correct_people();
  void correct_heading(PersonTrack& person, const LegMatch& match);
  void correct_person(PersonTrack& person, const LegMatch& match);
  void correct_clusters();
  void reassociate_legs();
  void reassociate_legs_of(std::initializer_list<std::size_t> of_people);
  void forget_clusters(std::vector<int>& used);
  double seconds() const { return (*now_ - origin_).to_seconds(); }
  Sighting sighting_of(const Detection& d) const;
  std::uint32_t id_of(const ClusterTrack& first, const ClusterTrack* second);
  PastState state_of(const PersonTrack& person) const {
    return {seconds(), person.walker.position(), person.walker.velocity()};
  }
  void follow_legs(PersonTrack& person, const ClusterTrack& first, const ClusterTrack* second) const;
  bool is_out_of_sight(const PersonTrack& person) const {
    return *now_ - person.last_seen > Duration::seconds(options_.hidden.kAbsent);
  }
  void follow_hidden_people(double dt, double since_own);
  void watch_for_absence(const DetectionSet& sweep, double dt);
  void leave_furniture();
  void delete_tracks();
  void initiate_tracks();
  void report();

  TrackerOptions options_;
  SensorOrder order_;
  SweepAlignment alignment_;
  Vector2 leading_sensor_{0.0, 0.0};  ///< of several the one that tells odometry's errors, in S
  Pose2 X_SO_;                        ///< S: odom without its errors from sweep to sweep; tracks live in S
  DetectionSet sweep_in_S_;
  std::optional<Time> now_;
  Time origin_;
  std::int64_t sweep_ = 0;
  std::uint32_t last_id_ = 0;
  std::vector<PersonTrack> people_;
  std::vector<PersonTrack> lost_;  ///< let go lately
  std::vector<ClusterTrack> clusters_;
  std::vector<Detection> detections_;
  Matching matching_;
  Weighing weighing_;
  std::vector<Candidate> candidates_;
  SeenWalls walls_;
  Random random_{1};
  std::vector<TrackedPerson> reported_;
};

}  // namespace bw::people
