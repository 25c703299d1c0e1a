// Made-up sweeps for tests of the tracker.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Core>

#include "components/model/random.hpp"
#include "components/people/detection.hpp"
#include "components/people/tracker/tracker.hpp"

namespace bw::people {

/// Sweeps of a sensor at the origin that sees all round; things hide nothing unless told.
class Stage {
 public:
  Stage() {
    set_.angle_min = -std::numbers::pi;
    set_.angle_increment = 2.0 * std::numbers::pi / 720.0;
  }
  void begin(double t) {
    set_.time = Time::seconds(t);
    set_.detections.clear();
    set_.free_ranges.assign(720, 10.0F);
  }
  void add(const Vector2& position, double leg_score, double body_score = 0.0) {
    Detection d;
    d.position = position + Vector2(random_.normal(0.0, 0.01), random_.normal(0.0, 0.01));
    d.covariance = 1e-4 * Eigen::Matrix2d::Identity();
    d.width = 0.12;
    d.points = 8;
    d.leg_score = leg_score;
    d.body_score = body_score;
    set_.detections.push_back(d);
    hide(position, 0.1, position.norm());
  }
  /// Beams within `half_width` [m] of the direction of `position` end at `range`.
  void hide(const Vector2& position, double half_width, double range) {
    for (int i = 0; i < 720; ++i) {
      const double angle = set_.angle_min + i * set_.angle_increment;
      const double off = wrap_angle(angle - std::atan2(position.y(), position.x()));
      if (std::abs(off) * position.norm() > half_width) continue;
      float& beam = set_.free_ranges[static_cast<std::size_t>(i)];
      beam = std::min(beam, static_cast<float>(range));
    }
  }
  void walker(double t, double speed, double y, double score = 0.9) {
    const double swing =
        0.18 * std::min(1.0, speed / 1.3) * std::sin(2.0 * std::numbers::pi * speed * t / 1.4);
    add({3.0, y + speed * t}, score);  // replaced below by the two legs
    set_.detections.pop_back();
    add({3.12, y + speed * t + swing}, score);
    add({2.88, y + speed * t - swing}, score);
  }
  DetectionSet& set() { return set_; }

 private:
  DetectionSet set_;
  Random random_{7};
};

/// Sweeps `from` to `to` - 1, ten a second, of somebody who goes along y at 1 m/s from y = -2 m.
inline void walk(Stage& stage, Tracker& tracker, int from, int to) {
  for (int k = from; k < to; ++k) {
    stage.begin(0.1 * k);
    stage.walker(0.1 * k, 1.0, -2.0);
    tracker.update(stage.set());
  }
}

}  // namespace bw::people
