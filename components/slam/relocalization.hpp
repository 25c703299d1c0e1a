// Where the robot is in a map that is there: about a pose that somebody gave, or anywhere (theory.md 10.13).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "components/slam/correlative_search.hpp"
#include "components/slam/loop_search.hpp"
#include "components/slam/max_grids.hpp"
#include "components/slam/slam.hpp"

namespace bw::slam {

struct Place {
  std::size_t submap = 0;
  UncertainPose X_SB;
  Pose2 X_MB;
  double inliers = 0.0;  ///< share of the scan's points that lie on the submap's walls, 0 to 1
};

/// The best place of a window about X_MB, by the submaps around it; the window's axes are those of each
/// submap. Nothing where less than 0.6 of the points lie on walls.
std::optional<Place> place_near(const Slam& map, std::span<const SurfacePoint> points, const Pose2& X_MB,
                                const SearchWindow& window);

/// Searches the whole map while the robot stands or drives: its scans make a map of their own, which is
/// looked for in each submap, within 4 m of where the robot of the map drove. Again after each metre, until
/// one place alone fits; and from the beginning when the robot is carried away meanwhile.
class PlaceSearch {
 public:
  /// `map` outlives this, has nothing under way and stays as it is.
  explicit PlaceSearch(const Slam& map);

  void add(const Scan& scan, const Pose2& X_OB);
  /// A piece of the work, of some milliseconds. False: it waits for a scan, or has found the place.
  bool advance();

  /// Of the newest scan; its submap has been compared with that scan.
  const std::optional<Place>& place() const { return place_; }
  enum class Doubt { none, nothing_fits, several_fit, one_direction_unseen };
  /// Why the last search over all of the map found no place.
  Doubt doubt() const { return doubt_; }
  std::int64_t searches() const { return searches_; }

 private:
  struct Candidate {
    Pose2 X_MS;
    double value = 0.0;
    bool unseen = false;
  };
  struct Block {
    Pose2 start;
    SearchWindow window;
  };
  void begin_search();
  void open_submap();
  void look(const Block& block);
  void judge();

  const Slam& map_;
  std::unique_ptr<Slam> local_;
  std::vector<SurfacePoint> newest_;  ///< the points of the newest scan
  Placement placement_;
  bool is_open_ = false;   ///< a search goes on
  std::size_t asked_ = 0;  ///< nodes of the local map when it began
  std::vector<Vector2> points_;
  std::vector<SurfacePoint> walls_;
  Pose2 X_WS_;  ///< of the local submap that is looked for
  Sights sights_;
  std::size_t submap_ = 0;  ///< that is searched
  std::vector<Block> blocks_;
  std::optional<MaxGrids> grids_;
  std::optional<SurfaceMap> surface_map_;
  std::vector<Candidate> candidates_;
  double best_ = 0.0;
  std::int64_t searches_ = 0;
  Doubt doubt_ = Doubt::none;
  std::optional<Place> place_;
};

}  // namespace bw::slam
