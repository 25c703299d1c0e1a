// A camera that tells of whole people, as their detectors do: ten messages a second that are 0.1 s late,
// positions that err by 0.1 m and 2 % of the distance, one person in ten missed, somebody who is not there
// once a minute.
#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "components/model/random.hpp"
#include "components/people/heard_person.hpp"
#include "components/world/ray.hpp"
#include "components/world/world.hpp"

namespace bw::people::test {

class SceneCamera {
 public:
  static constexpr double kHalfView = 0.6;  ///< [rad]
  static constexpr double kRange = 8.0;     ///< [m]

  explicit SceneCamera(std::uint64_t seed) : random_(seed + 77) {}

  /// The robot's camera sits on base_link. Takes a picture when one is due.
  void look(const World& world, const Pose2& X_OM, Time now) {
    if (!sets_.empty() && now - sets_.back().time < kPeriod) return;
    const Pose2 X_MB = world.pose();
    HeardSet set{now, {}};
    for (const Person& person : world.people()) {
      const Vector2 offset = person.position - X_MB.position();
      const double bearing = wrap_angle(std::atan2(offset.y(), offset.x()) - X_MB.theta);
      const bool missed = random_.uniform() < 0.1;
      if (missed || std::abs(bearing) > kHalfView || offset.norm() > kRange ||
          is_walled(world, person.position))
        continue;
      set.people.push_back(told(X_OM, person.position, offset.norm()));
    }
    if (random_.uniform() < kPeriod.to_seconds() / 60.0) {
      const double distance = random_.uniform(1.0, kRange);
      const double bearing = random_.uniform(-kHalfView, kHalfView);
      set.people.push_back(told(X_OM, X_MB * Vector2(distance * direction(bearing)), distance));
    }
    sets_.push_back(set);
    waiting_.push_back(set);
    while (sets_.size() > 1) sets_.pop_front();
  }

  /// What has come by now.
  std::vector<HeardSet> due(Time now) {
    std::vector<HeardSet> come;
    while (!waiting_.empty() && now - waiting_.front().time >= kPeriod) {
      come.push_back(waiting_.front());
      waiting_.pop_front();
    }
    return come;
  }

 private:
  static constexpr Duration kPeriod = Duration::milliseconds(100);

  HeardPerson told(const Pose2& X_OM, const Vector2& position, double distance) {
    const double deviation = 0.1 + 0.02 * distance;
    const Vector2 error(random_.normal(0.0, deviation), random_.normal(0.0, deviation));
    return {.position = X_OM * Vector2(position + error), .reliability = 0.8};
  }

  static bool is_walled(const World& world, const Vector2& position) {
    const Vector2 from = world.pose().position();
    const double distance = (position - from).norm();
    for (const Segment& wall : world.scene().segments())
      if (ray_hit(from, (position - from) / distance, wall) < distance) return true;
    return false;
  }

  Random random_;
  std::deque<HeardSet> sets_;
  std::deque<HeardSet> waiting_;
};

}  // namespace bw::people::test
