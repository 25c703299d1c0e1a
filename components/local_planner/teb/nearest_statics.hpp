// The static obstacles that a pose of the band keeps clear of: of any number of them, those nearest to it.
#pragma once

#include <cstdint>
#include <vector>

#include "components/local_planner/teb/obstacle_field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::teb {

/// A static obstacle near a pose.
struct NearStatic {
  double distance = 0.0;    ///< [m] from the footprint
  Vector2 spot{0.0, 0.0};   ///< the point of its axis that is nearest to the pose
  std::uint32_t index = 0;  ///< into field.statics.capsules()
};

/// Searches near one position after the other. Keeps a reference to the field; one for each thread.
class NearestStatics {
 public:
  /// Obstacles up to `reach` [m] from the footprint are found; those nearer than `costly` [m] cost something.
  NearestStatics(const ObstacleField& field, double reach, double costly);

  /// The searches that follow are for poses at most `aside` [m] from `path`.
  void look_along(const Segment& path, double aside);

  /// The `most` nearest to the footprint at `pose`, the nearest first; of equally near ones in an order that
  /// neither hangs on that of the input nor on the frame. Obstacles that touch the same spot of a surface
  /// (the corner of two walls, neighbouring points) count once: together they would outweigh what stands on
  /// the other side of a gap.
  /// Neither side of the robot takes more than half of the slots while the other has something costly: one
  /// wall of a narrow passage must not crowd out the other. Where there are many, what costs nothing yet is
  /// thinned out besides, the more the further it is from costing.
  /// Returns in how many more spots something costly was left out (within 3.5 cm it may count as one).
  std::size_t find(const Pose2& pose, std::size_t most, std::vector<NearStatic>& found);

 private:
  static constexpr std::uint32_t kGroup = UINT32_MAX;  ///< the index of a group
  /// An obstacle, or a group of them none of which is nearer than `distance`.
  struct Candidate {
    double distance = 0.0;
    std::uint32_t group = 0;
    std::uint32_t index = kGroup;
    Vector2 spot{0.0, 0.0};
  };
  /// Whoever touches it is not looked at again.
  struct Spot {
    Vector2 position;
    double squared_radius;
  };

  bool is_before(const Candidate& l, const Candidate& r) const;
  bool is_known(const Vector2& position) const;
  /// 1 left, 2 right of the robot, 0 ahead, behind or on both sides.
  std::size_t side_of(const Pose2& pose, const Candidate& candidate) const;
  void collect(const Pose2& pose);
  /// The nearest of the group whose spot is not known in its place; false if there is none.
  bool resolve(const Pose2& pose, Candidate& candidate) const;
  /// All of it lies in spots that are known.
  bool is_used_up(const Candidate& candidate) const;

  const ObstacleField& field_;
  double reach_;
  double costly_;
  std::vector<CapsuleIndex::Group> around_;
  std::vector<Candidate> candidates_;  ///< a heap, the nearest first
  std::vector<NearStatic> spare_;      ///< for which their side has no slot
  std::vector<Spot> spots_;            ///< of those found and spare
};

}  // namespace bw::teb
