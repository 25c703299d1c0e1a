// The map of a SLAM under way, drawn a few scans at a time: new ones, and again those whose pose moved; without those that left it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "components/slam/map_rendering.hpp"
#include "components/slam/slam.hpp"

namespace bw::slam {

/// Scans that are drawn for each that comes, where none may be delayed.
inline constexpr int kDrawnPerScan = 4;

/// All scans of the map at their poses. X_MW: what Slam calls its map, in the frame that they are placed in.
std::vector<PlacedScan> placed_scans(const Slam& slam, const Pose2& X_MW);

class MapPainter {
 public:
  /// X_MW: as of placed_scans().
  MapPainter(double resolution, const Pose2& X_MW)
      : resolution_(resolution), X_MW_(X_MW), rendering_(resolution) {}

  /// Draws at most `most` scans. False: all is as it should be.
  bool update(const Slam& slam, int most);

  /// Scans that are not on the map, since it would be larger than a map may be (kMostCells).
  std::size_t left_out() const { return left_out_; }
  OccupancyGrid grid() const { return rendering_.grid(); }
  /// As MapRendering's.
  std::size_t changed_tiles() const { return rendering_.changed_tiles(); }
  void gather(std::size_t most, std::vector<MapTile>& tiles) { rendering_.gather(most, tiles); }

 private:
  bool moved(const Pose2& from, const Pose2& to) const;

  double resolution_;
  Pose2 X_MW_;
  MapRendering rendering_;
  struct Drawn {
    PlacedScan scan;
    bool is_there = false;  ///< else there was no room
  };
  void draw(Drawn& node);
  void erase(const Drawn& node);
  std::map<std::size_t, Drawn> drawn_nodes_;  ///< by number, as they were drawn
  std::size_t next_new_ = 0;                  ///< number of the node that is drawn next
  std::int64_t revision_ = 0;                 ///< of the poses that are looked at
  std::size_t next_again_ = 0;  ///< number of the node that is looked at next: did it move or leave?
  std::size_t left_out_ = 0;
};

}  // namespace bw::slam
