// One run of detector and tracker in a simulated room, with the truth beside it.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "components/people/detector/detector.hpp"
#include "components/people/score/clear_mot.hpp"
#include "components/people/tracker/tracker.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "components/world/random_streams.hpp"
#include "tests/components/people/perception_scene.hpp"
#include "tests/components/people/scene_camera.hpp"

namespace bw::people::test {

inline double thread_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

struct TrialRecord {
  Score score;
  std::vector<double> milliseconds;  ///< thread CPU time of detector and tracker per sweep
  double clusters = 0.0;             ///< mean detections per sweep
  // Tracks with nobody within ScoreKeeper::kRadius.
  int false_people = 0;    ///< ids that were confirmed in some such sweep
  int false_possible = 0;  ///< ids that never were
  double possible = 0.0;   ///< mean of those not confirmed at once
  int most_possible = 0;   ///< most of them at once
  double driven = 0.0;     ///< by the robot [m]
};

/// Whoever is within this distance counts [m].
inline constexpr double kCountedRange = 6.0;

class Trial {
 public:
  Trial(const SceneOptions& scene_options, const DetectorOptions& detector, const TrackerOptions& tracker,
        std::uint64_t seed)
      : scene_options_(scene_options),
        scene_(SceneMaker(scene_options, seed).make()),
        world_(scene_.options, scene_.robot, scene_.files, seed),
        legs_(scene_.options.people.legs),
        odometry_(scene_.robot, {}),
        chauffeur_(scene_, seed),
        camera_(seed),
        tracker_(tracker) {
    legs_.step(0.0, world_.people());
    eyes_.push_back(
        {scene_.options.laser, scene_.robot.mount_of(scene_.options.laser.frame), Detector(detector)});
    for (const MoreLaserOptions& one : scene_.options.more_lasers)
      eyes_.push_back({one, scene_.robot.mount_of(one.frame), Detector(detector)});
  }

  std::function<void(const DetectionSet&, const std::vector<TruePerson>&, const std::vector<TrackedPerson>&)>
      watch;

  ScoreKeeper& keeper() { return keeper_; }
  double now() const { return world_.time().to_seconds(); }                       ///< [s], since the start
  Pose2 X_MO() const { return world_.pose() * inverse(odometry_.state().X_OB); }  ///< odom, as it has drifted

  TrialRecord run(double seconds) {
    while (world_.time().to_seconds() < seconds - 1e-9) {
      if (scene_options_.driving) drive();
      const Vector2 before = world_.pose().position();
      const WorldSample sample = world_.step();
      record_.driven += (world_.pose().position() - before).norm();
      legs_.step(world_.physics_step().to_seconds(), world_.people());
      const Time time = stamp(sample.time);
      if (sample.ticks) odometry_.add(time, {time, sample.ticks->left, sample.ticks->right});
      if (scene_options_.camera) camera_.look(world_, inverse(X_MO()), stamp(sample.time));
      if (sample.scan) sweep(sample);
    }
    keeper_.close();
    record_.score = keeper_.score();
    for (const auto& [id, confirmed] : accused_)
      ++(confirmed ? record_.false_people : record_.false_possible);
    record_.clusters /= static_cast<double>(record_.milliseconds.size());
    record_.possible /= static_cast<double>(record_.milliseconds.size());
    return record_;
  }

 private:
  static Time stamp(Duration since_start) { return Time{} + Duration::seconds(100.0) + since_start; }

  void drive() {
    const Twist2 twist = chauffeur_.command(world_);
    const WheelSpeeds speeds = to_wheel_speeds(twist, scene_.robot.wheel_separation);
    world_.command({speeds.left / scene_.robot.wheel_radius, speeds.right / scene_.robot.wheel_radius});
  }

  /// All lasers sweep at once, one update each.
  void sweep(const WorldSample& sample) {
    const Pose2 X_MB = world_.pose();
    const Pose2 X_OB = odometry_.state().X_OB;
    std::vector<const LaserScan*> scans = {&*sample.scan};
    for (const auto& more : sample.more_scans) scans.push_back(&*more);
    const DetectionSet* detections = nullptr;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const LaserOptions& laser = eyes_[i].options;
      const LaserSweep seen{stamp(sample.time),        X_OB * eyes_[i].X_BL, scans[i]->angle_min,
                            scans[i]->angle_increment, laser.range_min,      laser.range_max,
                            scans[i]->ranges};
      const double before = thread_milliseconds();
      const std::vector<Vector2> keep = tracker_.keep_out();
      seen_ = eyes_[i].detector.detect(seen, {nullptr, std::nullopt, keep});
      seen_.source = static_cast<int>(i);
      tracker_.update(seen_);
      record_.milliseconds.push_back(thread_milliseconds() - before);
      record_.clusters += static_cast<double>(seen_.detections.size());
      detections = &seen_;
    }
    for (const HeardSet& heard : camera_.due(stamp(sample.time))) tracker_.hear(heard);
    const std::vector<TrackedPerson>& tracks = tracker_.people();

    const std::vector<TruePerson> truth = truth_in(X_OB * inverse(X_MB), X_MB, scans);
    const auto counts = [&](const Vector2& p_O) { return (p_O - X_OB.position()).norm() <= kCountedRange; };
    keeper_.add(sample.time.to_seconds(), truth, tracks, counts);
    accuse(truth, tracks);
    if (watch) watch(*detections, truth, tracks);
  }

  void accuse(const std::vector<TruePerson>& truth, const std::vector<TrackedPerson>& tracks) {
    int possible = 0;
    for (const TrackedPerson& track : tracks) {
      const bool near = std::ranges::any_of(truth, [&](const TruePerson& person) {
        return (person.position - track.position).norm() <= ScoreKeeper::kRadius;
      });
      if (near || track.confidence <= 0.0) continue;
      const bool confirmed = track.confidence >= kConfirmed;
      accused_[track.id] = accused_[track.id] || confirmed;
      if (!confirmed) ++possible;
    }
    record_.possible += possible;
    record_.most_possible = std::max(record_.most_possible, possible);
  }

  /// Counted: within range and view of a laser, the line from it to the middle not barred by walls or
  /// furniture. Unoccluded: at least three beams ended on one of the legs.
  std::vector<TruePerson> truth_in(const Pose2& X_OM, const Pose2& X_MB,
                                   const std::vector<const LaserScan*>& scans) const {
    const std::vector<Person>& people = world_.people();
    const std::vector<Disc> legs = legs_.discs(people);
    std::vector<char> counted(people.size(), 0);
    std::vector<char> plain(people.size(), 0);
    for (std::size_t eye = 0; eye < scans.size(); ++eye) {
      const Pose2 X_ML = X_MB * eyes_[eye].X_BL;
      const std::vector<int> hits = hits_on(legs, X_ML, *scans[eye]);
      for (std::size_t i = 0; i < people.size(); ++i) {
        const Vector2 offset = people[i].position - X_ML.position();
        const double bearing = wrap_angle(std::atan2(offset.y(), offset.x()) - X_ML.theta);
        const bool in_view = std::abs(bearing) < eyes_[eye].options.field_of_view / 2.0;
        const bool is_near = (people[i].position - X_MB.position()).norm() <= kCountedRange;
        if (is_near && in_view && !barred(X_ML.position(), people[i].position)) counted[i] = 1;
        if (std::max(hits[2 * i], hits[2 * i + 1]) >= 3) plain[i] = 1;
      }
    }
    std::vector<TruePerson> truth;
    for (std::size_t i = 0; i < people.size(); ++i)
      truth.push_back({people[i].id, X_OM * people[i].position, rotate(X_OM, people[i].velocity),
                       counted[i] != 0, plain[i] != 0});
    return truth;
  }

  static std::vector<int> hits_on(const std::vector<Disc>& legs, const Pose2& X_ML, const LaserScan& scan) {
    std::vector<int> hits(legs.size(), 0);
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = X_ML.theta + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      for (std::size_t k = 0; k < legs.size(); ++k) {
        const double range = ray_hit(X_ML.position(), direction(angle), legs[k]);
        if (std::abs(range - static_cast<double>(scan.ranges[i])) < 0.08) ++hits[k];
      }
    }
    return hits;
  }

  bool barred(const Vector2& from, const Vector2& to) const {
    const double distance = (to - from).norm();
    const Vector2 ahead = (to - from) / distance;
    const auto bars = [&](const auto& shape) { return ray_hit(from, ahead, shape) < distance; };
    return std::ranges::any_of(world_.scene().segments(), bars) ||
           std::ranges::any_of(world_.scene().discs(), bars);
  }

  struct Eye {
    LaserOptions options;
    Pose2 X_BL;
    Detector detector;
  };

  SceneOptions scene_options_;
  Scene scene_;
  World world_;
  Legs legs_;
  EncoderOdometry odometry_;
  Chauffeur chauffeur_;
  SceneCamera camera_;
  std::vector<Eye> eyes_;
  DetectionSet seen_;
  Tracker tracker_;
  ScoreKeeper keeper_;
  TrialRecord record_;
  std::map<std::uint32_t, bool>
      accused_;  ///< by id of a track with nobody near: whether it was confirmed then
};

}  // namespace bw::people::test
