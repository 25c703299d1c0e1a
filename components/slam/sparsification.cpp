#include "components/slam/sparsification.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::slam {
namespace {

constexpr double kSamePlace = 1.0;  // [m] from scan to scan
constexpr double kBetween = 0.1;    // [m] in front of a wall counts as behind it
constexpr double kAllAround = 0.9;  // of a full turn

struct Seen {
  Pose2 X_MB;
  const RangeImage* image = nullptr;
};

// Scans that lie in a submap: each lies in one. That with which a submap ended comes after its last node.
std::vector<Seen> own_scans(std::size_t submap, const Submap& of, const Pose2& X_MS, const Nodes& nodes) {
  std::vector<Seen> scans;
  for (auto at = nodes.lower_bound(of.first_node); at != nodes.end(); ++at) {
    const auto& [number, node] = *at;
    if (node.placement.submap == submap)
      scans.push_back({X_MS * node.placement.X_SB, node.ranges.get()});
    else if (number >= of.last_node)
      break;
  }
  return scans;
}

bool has_clear_view(const Seen& from, const Vector2& to) {
  const Vector2 p = inverse(from.X_MB * from.image->X_BL) * to;
  const std::optional<std::size_t> beam = beam_towards(*from.image, p);
  if (!beam) return false;
  const std::uint16_t mm = from.image->millimetres[*beam];
  if (mm == RangeImage::kUnknown) return false;
  return mm == RangeImage::kNoReturn || 0.001 * mm > p.norm() + kBetween;
}

bool is_same_place(const Seen& a, const Seen& b) {
  if ((a.X_MB.position() - b.X_MB.position()).norm() > kSamePlace) return false;
  const double view = std::abs(a.image->angle_increment) * static_cast<double>(a.image->millimetres.size());
  if (view < kAllAround * 2.0 * std::numbers::pi &&
      std::abs(wrap_angle(a.X_MB.theta - b.X_MB.theta)) > 0.25 * view)
    return false;
  return has_clear_view(a, b.X_MB.position()) || has_clear_view(b, a.X_MB.position());
}

}  // namespace

bool is_seen_again(std::size_t submap, std::span<const std::size_t> around, std::span<const Submap> submaps,
                   std::span<const Pose2> X_MS, const Nodes& nodes) {
  const std::vector<Seen> scans = own_scans(submap, submaps[submap], X_MS[submap], nodes);
  std::vector<std::size_t> last(scans.size(), submap);
  std::vector<std::size_t> visits(scans.size(), 0);
  for (const std::size_t k : around) {
    if (k <= submap || submaps[k].marginalised ||
        (X_MS[k].position() - X_MS[submap].position()).norm() > kPlaceReach)
      continue;
    const std::vector<Seen> later = own_scans(k, submaps[k], X_MS[k], nodes);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      if (std::none_of(later.begin(), later.end(), [&](const Seen& b) { return is_same_place(scans[i], b); }))
        continue;
      if (k - last[i] >= kVisitApart) ++visits[i];
      last[i] = k;
    }
  }
  return std::all_of(visits.begin(), visits.end(), [](std::size_t n) { return n >= kLaterVisits; });
}

std::optional<Marginalised> marginalise(std::size_t submap, const std::vector<Edge>& edges,
                                        const std::vector<Pose2>& poses) {
  struct Neighbour {
    std::size_t submap = 0;
    UncertainPose X;  // in the one that leaves
    bool loop = false;
  };
  std::vector<Neighbour> neighbours;
  Marginalised result;
  for (const Edge& edge : edges) {
    if (edge.from != submap && edge.to != submap) {
      result.edges.push_back(edge);
      continue;
    }
    if (edge.loop && weight_left(edge, poses) < 1.0) continue;
    if (edge.from == submap)
      neighbours.push_back({edge.to, edge.X, edge.loop});
    else
      neighbours.push_back({edge.from, inverse(edge.X), edge.loop});
  }
  const auto surer = [](const Neighbour& a, const Neighbour& b) {
    if (a.loop != b.loop) return a.loop;
    return spread(a.X.covariance) < spread(b.X.covariance);
  };
  const auto hub = std::min_element(neighbours.begin(), neighbours.end(), surer);
  if (hub == neighbours.end() || !hub->loop) return std::nullopt;
  result.anchor = hub->submap;
  for (const Neighbour& neighbour : neighbours) {
    if (neighbour.submap == hub->submap) continue;
    UncertainPose X = inverse(hub->X) * neighbour.X;
    std::size_t from = hub->submap;
    std::size_t to = neighbour.submap;
    if (from > to) {
      std::swap(from, to);
      X = inverse(X);
    }
    // One edge of the drive and one loop for a pair, the surer one: both were made of measurements that others share.
    const auto same = std::find_if(result.edges.begin(), result.edges.end(), [&](const Edge& edge) {
      return edge.from == from && edge.to == to && edge.loop == neighbour.loop;
    });
    if (same == result.edges.end())
      result.edges.push_back({from, to, X, neighbour.loop});
    else if (spread(X.covariance) < spread(same->X.covariance))
      same->X = X;
  }
  return result;
}

}  // namespace bw::slam
