// Is a submap another one seen again? The relative pose, and what speaks for it and against it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "components/slam/max_grids.hpp"
#include "components/slam/pose_graph.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

/// A loop that was found: `edge.from` is the earlier submap.
struct Loop {
  Edge edge;
  double score = 0.0;    ///< of branch and bound, 0 to 1
  double inliers = 0.0;  ///< share of the earlier submap's surfaces that lie on the later one's
  /// Of what the scans of either have in view of the other's surfaces, the share that beams went through: t and t',
  /// 1 - (1 - t) (1 - t'), 0 to 1.
  double through = 0.0;
  double window = 0.0;  ///< how far it was searched [m]
};

/// Some of the scans that saw a submap's walls, and their base_link in it.
struct Sights {
  std::vector<const RangeImage*> images;
  std::vector<Pose2> X_SB;
};

/// The same in frame A.
Sights moved(Sights sights, const Pose2& X_AS);

/// One point of these for each square of 0.2 m: what is searched with.
std::vector<Vector2> thinned(std::span<const Surface> surfaces);

/// Submap::all_round of these.
double all_round(std::span<const Surface> surfaces);

/// Submap::centre of these.
Vector2 centre(std::span<const Surface> surfaces);

/// Share of `surfaces` (in S) that beams of the scans went through, of those in their view (theory.md 10.8). 0 where
/// too few are in view.
double seen_through(std::span<const Surface> surfaces, const Sights& sights);

/// Those that no more of the scans went through than met them: somebody who walked by is no wall (theory.md 10.5).
std::vector<Surface> standing(std::span<const Surface> surfaces, const Sights& sights);

/// Looks for earlier submaps in walls seen later: what it needs of these is made once.
class LoopSearch {
 public:
  /// `walls`: in the later submap, with the scans that saw them. Both must outlive this.
  LoopSearch(std::span<const Surface> walls, const Sights& sights, const SlamOptions& options);

  /// `expected`: pose of `earlier` in the later submap. Nothing where nothing fits that it allows.
  std::optional<Loop> find(const Submap& earlier, const Sights& of_earlier, const UncertainPose& expected);

  std::int64_t visited() const { return visited_; }  ///< squares and poses of branch and bound

 private:
  std::span<const Surface> walls_;
  Vector2 centre_;
  const Sights& sights_;
  SlamOptions options_;
  MaxGrids grids_;
  std::optional<SurfaceMap> map_;  ///< made when something is found
  std::int64_t visited_ = 0;
};

}  // namespace bw::slam
