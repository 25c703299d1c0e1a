#include "components/slam/map_painter.hpp"

#include <cmath>

namespace bw::slam {
namespace {

constexpr double kArm = 5.0;               // [m] of the beams by which a turn moves the map
constexpr std::size_t kLooksAtOnce = 200;  // poses that are compared for each scan that may be drawn

}  // namespace

std::vector<PlacedScan> placed_scans(const Slam& slam, const Pose2& X_MW) {
  std::vector<PlacedScan> scans;
  scans.reserve(slam.nodes().size());
  for (const auto& [number, node] : slam.nodes())
    scans.push_back({X_MW * slam.pose(node.placement), node.ranges});
  return scans;
}

void MapPainter::draw(Drawn& node) {
  node.is_there = rendering_.draw(*node.scan.ranges, node.scan.X_MB);
  if (!node.is_there) ++left_out_;
}

void MapPainter::erase(const Drawn& node) {
  if (node.is_there)
    rendering_.erase(*node.scan.ranges, node.scan.X_MB);
  else
    --left_out_;
}

bool MapPainter::moved(const Pose2& from, const Pose2& to) const {
  const Eigen::Vector3d d = difference(to, from);
  return d.head<2>().norm() + kArm * std::abs(d.z()) > 0.5 * resolution_;
}

bool MapPainter::update(const Slam& slam, int most) {
  const Nodes& nodes = slam.nodes();
  auto next = nodes.lower_bound(next_new_);
  for (; most > 0 && next != nodes.end(); ++next, --most) {
    const auto& [number, node] = *next;
    const Drawn drawn{.scan = {X_MW_ * slam.pose(node.placement), node.ranges}};
    draw(drawn_nodes_.emplace_hint(drawn_nodes_.end(), number, drawn)->second);
    next_new_ = number + 1;
  }
  if (slam.revision() != revision_) {
    revision_ = slam.revision();
    next_again_ = 0;
  }
  auto again = drawn_nodes_.lower_bound(next_again_);
  for (std::size_t looks = kLooksAtOnce * static_cast<std::size_t>(most);
       most > 0 && looks > 0 && again != drawn_nodes_.end(); --looks) {
    auto& [number, drawn] = *again;
    const auto node = nodes.find(number);
    const bool has_left = node == nodes.end();
    const Pose2 X_MB = has_left ? drawn.scan.X_MB : X_MW_ * slam.pose(node->second.placement);
    if (!has_left && !moved(drawn.scan.X_MB, X_MB)) {
      ++again;
      continue;
    }
    erase(drawn);
    if (has_left) {
      again = drawn_nodes_.erase(again);
    } else {
      drawn.scan.X_MB = X_MB;
      draw(drawn);
      ++again;
    }
    --most;
  }
  next_again_ = again == drawn_nodes_.end() ? next_new_ : again->first;
  return next != nodes.end() || again != drawn_nodes_.end();
}

}  // namespace bw::slam
