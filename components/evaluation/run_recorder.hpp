// What a picture of the run needs, thinned to about ten looks a second and to a bounded size.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/evaluation/contact_diary.hpp"
#include "components/evaluation/score_keeper.hpp"
#include "components/evaluation/thinning.hpp"
#include "components/evaluation/truth_sample.hpp"
#include "components/model/footprint.hpp"
#include "components/model/limits.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

struct RecordedMoment {
  double time = 0.0;  ///< since the start of the drive [s]
  Pose2 X_MB;
  double speed = 0.0;  ///< [m/s]
  std::vector<TruePerson> people;
  Twist2 twist{};  ///< 0 where the truth has no speed and the moment before tells none
};

/// All in map.
struct RunRecording {
  Footprint robot;         ///< its outline; where that changes, the last
  double top_speed = 1.0;  ///< of the robot, end of the colour scale [m/s]
  std::optional<OccupancyGrid> map;
  StaticObstacles shapes;  ///< the world's walls and pillars
  std::vector<Vector2> goals;
  std::vector<RecordedMoment> moments;
  std::vector<ContactRecord> contacts;  ///< with people and other robots, of every sample
  std::optional<Limits> limits;         ///< of the robot, where they are known
};

class RunRecorder {
 public:
  RunRecorder(const Footprint& robot, double top_speed);

  /// Forgets moments, contacts and goals, keeps map and shapes.
  void start(Time now);
  void start(Time now, const Vector2& goal) {
    start(now);
    add_goal(goal);
  }
  /// One more goal of the same drive.
  void add_goal(const Vector2& goal) { recording_.goals.push_back(goal); }
  void add(const TruthSample& sample);
  /// The robot's map; drawn where the world has none of its own.
  void set_map(const OccupancyGrid& map) {
    if (!has_true_map_) recording_.map = map;
  }
  void set_true_map(const OccupancyGrid& map) {
    recording_.map = map;
    has_true_map_ = true;
  }
  void set_shapes(StaticObstacles shapes) { recording_.shapes = std::move(shapes); }
  void set_footprint(const Footprint& footprint) { recording_.robot = footprint; }
  void set_limits(const Limits& limits) { recording_.limits = limits; }
  /// A copy, as it is now.
  RunRecording recording() const;

 private:
  /// From the last moment, for a truth without speed.
  [[nodiscard]] double speed_to(const RecordedMoment& moment) const;

  RunRecording recording_;  ///< its contacts are in the diary
  bool has_true_map_ = false;
  ContactDiary diary_;
  Time started_;
  Thinning thinning_;  ///< ten minutes at full detail
};

}  // namespace bw
