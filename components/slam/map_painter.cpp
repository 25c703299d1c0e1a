#include "components/slam/map_painter.hpp"

#include <cmath>

namespace bw::slam {
namespace {

constexpr double kArm = 5.0;               // [m] of the beams by which a turn moves the map
constexpr std::size_t kLooksAtOnce = 200;  // poses that are compared for each scan that may be drawn

}  // namespace

bool MapPainter::moved(const Pose2& from, const Pose2& to) const {
  const Eigen::Vector3d d = difference(to, from);
  return d.head<2>().norm() + kArm * std::abs(d.z()) > 0.5 * resolution_;
}

bool MapPainter::update(const Slam& slam, int most) {
  const std::deque<Node>& nodes = slam.nodes();
  for (; most > 0 && drawn_nodes_.size() < nodes.size(); --most) {
    const Node& node = nodes[drawn_nodes_.size()];
    drawn_nodes_.push_back({X_MW_ * slam.pose(node.placement), node.ranges});
    if (!node.ranges) continue;
    rendering_.draw(*node.ranges, drawn_nodes_.back().X_MB);
    ++drawn_;
  }
  if (slam.revision() != revision_) {
    revision_ = slam.revision();
    next_again_ = 0;
  }
  std::size_t looks = kLooksAtOnce * static_cast<std::size_t>(most);
  for (; most > 0 && looks > 0 && next_again_ < drawn_nodes_.size(); ++next_again_, --looks) {
    Drawn& drawn = drawn_nodes_[next_again_];
    if (!drawn.ranges) continue;
    const Node& node = nodes[next_again_];
    const Pose2 X_MB = X_MW_ * slam.pose(node.placement);
    if (node.ranges && !moved(drawn.X_MB, X_MB)) continue;
    rendering_.erase(*drawn.ranges, drawn.X_MB);
    if (node.ranges) rendering_.draw(*node.ranges, X_MB);
    drawn = {X_MB, node.ranges};
    ++drawn_;
    --most;
  }
  return drawn_nodes_.size() < nodes.size() || next_again_ < drawn_nodes_.size();
}

}  // namespace bw::slam
