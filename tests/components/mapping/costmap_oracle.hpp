// The local grid by brute force: every beam against every cell, cells kept in an unbounded map.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "components/mapping/costmap/local_grid.hpp"

namespace bw::test {

class CostmapOracle {
 public:
  explicit CostmapOracle(const costmap::GridOptions& options) : options_(options) {}

  void add(const LaserSweep& scan, const Pose2& X_OB, double robot_radius, const std::vector<Disc>& people,
           const OccupancyGrid& window) {
    const double dt = time_ ? (scan.time - *time_).to_seconds() : 0.0;
    time_ = scan.time;
    const std::vector<Beam> beams = beams_of(scan);
    std::map<Key, State> kept;
    for (int row = 0; row < window.height; ++row) {
      for (int column = 0; column < window.width; ++column) {
        const Key key = key_of(window, column, row);
        if (const auto found = states_.find(key); found != states_.end()) kept.insert(*found);
        State& state = kept[key];
        state.age += dt;
        judge(state, look(scan.X_FL.position(), beams, window.center(column, row)),
              window.center(column, row), X_OB, robot_radius, people);
      }
    }
    states_ = std::move(kept);
  }

  std::int8_t value(const OccupancyGrid& window, int column, int row) const {
    return states_.at(key_of(window, column, row)).value;
  }

 private:
  using Key = std::pair<long, long>;
  struct State {
    int evidence = 0;
    int hits = 0;
    double age = 0.0;
    std::int8_t value = OccupancyGrid::kUnknown;
  };
  struct View {
    bool seen = false, crossed = false, kept = false;
    int points = 0;
  };

  Key key_of(const OccupancyGrid& window, int column, int row) const {
    const Vector2 c = window.center(column, row) / options_.resolution;
    return {std::lround(c.x() - 0.5), std::lround(c.y() - 0.5)};
  }

  // Shares of the line at which it enters and leaves the cell.
  std::optional<std::pair<double, double>> chord(const Vector2& a, const Vector2& b,
                                                 const Vector2& center) const {
    double enter = 0.0;
    double leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double low = center[axis] - options_.resolution / 2.0 - a[axis];
      const double high = low + options_.resolution;
      const double offset = b[axis] - a[axis];
      if (offset == 0.0) {
        if (low > 0.0 || high < 0.0) return std::nullopt;
        continue;
      }
      enter = std::max(enter, std::min(low / offset, high / offset));
      leave = std::min(leave, std::max(low / offset, high / offset));
    }
    if (leave <= enter) return std::nullopt;
    return std::pair{enter, leave};
  }

  struct Beam {
    double range = 0.0;  // up to which it looks
    bool free = false;   // of a hit
    Vector2 end{0.0, 0.0};
    int reach = 0;  // 0: no hit, 1: too far to be marked, 2: marked
  };

  std::vector<Beam> beams_of(const LaserSweep& scan) const {
    std::vector<Beam> beams;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double range = static_cast<double>(scan.ranges[i]);
      Beam& beam = beams.emplace_back();
      beam.free = std::isinf(range) && range > 0.0;
      if (!beam.free && !(range >= std::max(scan.range_min, options_.obstacle_min_range) && range > 0.0 &&
                          range <= scan.range_max))
        continue;
      beam.range = std::min({range, options_.raytrace_max_range, scan.range_max});
      beam.end = scan.X_FL.position() + beam.range * direction(scan.X_FL.theta + scan.angle_min +
                                                               static_cast<double>(i) * scan.angle_increment);
      beam.free = beam.free || range > options_.raytrace_max_range;
      if (!beam.free) beam.reach = range <= options_.obstacle_max_range ? 2 : 1;
    }
    return beams;
  }

  View look(const Vector2& from, const std::vector<Beam>& beams, const Vector2& center) const {
    View view;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const Beam& beam = beams[i];
      if (beam.range <= 0.0) continue;
      if (const auto c = chord(from, beam.end, center)) {
        const double sure = beam.range - (beam.free ? 0.0 : options_.hit_margin);
        if (c->second < 1.0) (c->second * beam.range <= sure ? view.crossed : view.seen) = true;
        if (c->second >= 1.0) note(view, beam.reach);
      }
      if (i == 0) continue;
      const int reach = std::min(beam.reach, beams[i - 1].reach);
      if (reach == 0 || (beam.end - beams[i - 1].end).norm() > options_.link_gap) continue;
      if (chord(beams[i - 1].end, beam.end, center)) note(view, reach);
    }
    return view;
  }

  static void note(View& view, int reach) {
    view.points += reach == 2 ? 1 : 0;
    view.kept = view.kept || reach == 1;
  }

  void judge(State& s, const View& view, const Vector2& center, const Pose2& X_OB, double robot_radius,
             const std::vector<Disc>& people) {
    for (const Disc& p : people) {
      if ((center - p.center).norm() > p.radius + options_.kPeopleMargin) continue;
      s = {.value = s.value > 0 ? OccupancyGrid::kFree : s.value};
      return;
    }
    if ((center - X_OB.position()).norm() <= robot_radius - options_.resolution) {
      s = {.value = OccupancyGrid::kFree};
    } else if (view.points > 0) {
      s.evidence = std::min(4, s.evidence + (view.points > 1 ? 3 : 2));
      s.hits = std::min(255, s.hits + 1);
      s.age = 0.0;
      if (s.evidence >= 3) s.value = OccupancyGrid::kOccupied;
    } else if (view.kept) {
      s.age = 0.0;
    } else if (view.crossed) {
      if (s.evidence > 1) {
        --s.evidence;
      } else {
        s = {.value = OccupancyGrid::kFree};
      }
    } else {
      if (view.seen && s.value < 0 && s.evidence == 0) s.value = OccupancyGrid::kFree;
      const double keep = s.hits >= options_.settled_hits ? options_.decay_time : options_.young_time;
      if (s.evidence > 0 && s.age > keep) s = {.value = s.value > 0 ? OccupancyGrid::kUnknown : s.value};
    }
  }

  costmap::GridOptions options_;
  std::map<Key, State> states_;
  std::optional<Time> time_;
};

}  // namespace bw::test
