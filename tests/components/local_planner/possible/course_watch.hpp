// Stands beside a drive: says when the robot was where, and, where people are to be made up, that there are
// some.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/people.hpp"
#include "runtime/component.hpp"

namespace bw {

/// What the next drive is about; one at a time.
struct CourseTask {
  double from = 0.0;              ///< x [m] in map at which the time begins
  double to = 0.0;                ///< at which it ends
  bool makes_tracks = false;      ///< a track on every one of `phantoms`, in place of a detector
  std::vector<Vector2> phantoms;  ///< in map
  double confidence = 1.0;        ///< of them
};
struct CourseSeen {
  double entered = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  double left = std::numeric_limits<double>::quiet_NaN();
  double most_confident = 0.0;  ///< of all tracks of the drive
  int confirmed = 0;            ///< tracks with at least kConfirmed, summed over messages
  int messages = 0;
};

class CourseWatch final : public Component {
 public:
  static inline CourseTask task;
  static inline CourseSeen seen;

  void configure(Setup& setup) override {
    seen = {};
    setup.input<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth", Qos::command(),
                                                  [](const auto& truth, const Tick& tick) {
                                                    const double x = truth.pose().position().x();
                                                    const double now = tick.now.to_seconds();
                                                    if (!(seen.entered >= 0.0) && x >= task.from)
                                                      seen.entered = now;
                                                    if (!(seen.left >= 0.0) && x >= task.to) seen.left = now;
                                                  });
    if (!task.makes_tracks) {
      setup.input<bandwagon_msgs::msg::Tracks>("tracks", Qos::command(),
                                               [](const auto& tracks, const Tick&) { note(tracks); });
      return;
    }
    tracks_ = setup.output<bandwagon_msgs::msg::Tracks>("tracks");
    setup.every(Duration::milliseconds(50), "phantoms", [this](const Tick& tick) { publish(tick.now); });
  }

 private:
  static void note(const bandwagon_msgs::msg::Tracks& tracks) {
    ++seen.messages;
    for (const auto& track : tracks.tracks()) {
      seen.most_confident = std::max(seen.most_confident, track.confidence());
      seen.confirmed += track.confidence() >= kConfirmed ? 1 : 0;
    }
  }

  /// As a tracker tells of a thing that trembles in its sweeps: a little velocity, a spread that grows.
  void publish(Time now) {
    std::vector<TrackedPerson> people;
    for (const Vector2& position : task.phantoms) {
      TrackedPerson person;
      person.id = static_cast<std::uint32_t>(people.size()) + 1;
      person.position = position;
      person.velocity = {0.05, person.id % 2 == 0 ? 0.05 : -0.05};
      person.radius = 0.3;
      person.confidence = task.confidence;
      for (int k = 1; k <= 6; ++k) {
        const double t = 0.5 * k;
        person.predictions.push_back(
            {t, person.position + t * person.velocity, 0.04 * t * t * Eigen::Matrix2d::Identity()});
      }
      people.push_back(person);
    }
    tracks_.publish(people::to_tracks(people, make_header("map", now)));
  }

  Output<bandwagon_msgs::msg::Tracks> tracks_;
};

}  // namespace bw
