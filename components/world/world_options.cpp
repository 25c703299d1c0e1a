#include "components/world/world_options.hpp"

#include <array>

namespace bw {

std::vector<Segment> wall_segments(const WorldOptions& options) {
  std::vector<Segment> segments;
  for (const WallOptions& wall : options.walls) segments.push_back({{wall.x1, wall.y1}, {wall.x2, wall.y2}});
  for (const BoxOptions& box : options.boxes) {
    const std::array<Vector2, 4> corners = box.corners();
    for (std::size_t i = 0; i < corners.size(); ++i)
      segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  return segments;
}

}  // namespace bw
