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
  for (; most > 0 && X_MB_.size() < nodes.size(); --most) {
    const Node& node = nodes[X_MB_.size()];
    X_MB_.push_back(X_MW_ * slam.pose(node.placement));
    rendering_.draw(node.ranges, X_MB_.back());
    ++drawn_;
  }
  if (slam.revision() != revision_) {
    revision_ = slam.revision();
    next_again_ = 0;
  }
  std::size_t looks = kLooksAtOnce * static_cast<std::size_t>(most);
  for (; most > 0 && looks > 0 && next_again_ < X_MB_.size(); ++next_again_, --looks) {
    const Node& node = nodes[next_again_];
    const Pose2 X_MB = X_MW_ * slam.pose(node.placement);
    Pose2& drawn = X_MB_[next_again_];
    if (!moved(drawn, X_MB)) continue;
    rendering_.erase(node.ranges, drawn);
    rendering_.draw(node.ranges, X_MB);
    drawn = X_MB;
    ++drawn_;
    --most;
  }
  return X_MB_.size() < nodes.size() || next_again_ < X_MB_.size();
}

}  // namespace bw::slam
