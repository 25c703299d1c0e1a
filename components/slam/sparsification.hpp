// A map as large as the place, however long the drive: a submap whose places were seen again leaves the map and the
// graph, and what the graph knew by it stays in edges between those that remain.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "components/slam/pose_graph.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

/// Later visits until a submap may leave: what left the place with its furniture is on the map for so many more.
inline constexpr std::size_t kLaterVisits = 2;

/// [m] between the frames of submaps that may share a place.
inline constexpr double kPlaceReach = 12.0;

/// Submaps of one visit follow each other with less than this between their numbers; as near, they share scans.
inline constexpr std::size_t kVisitApart = 3;

/// Whether later submaps saw the place of each of a submap's own scans again, kLaterVisits times: from within 1 m with
/// no wall between, and, by a scanner that does not see all round, turned by less than a quarter of its view (theory.md
/// 10.14). `around`: numbers, counting up, of those that are looked at; X_MS: of all submaps.
bool is_seen_again(std::size_t submap, std::span<const std::size_t> around, std::span<const Submap> submaps,
                   std::span<const Pose2> X_MS, const Nodes& nodes);

struct Marginalised {
  std::vector<Edge> edges;  ///< without the submap
  std::size_t anchor = 0;   ///< that takes its edges over
};

/// The graph without `submap`: its Chow-Liu tree about the surest of the submaps that saw the same place. Loops that the
/// poses contradict are left out. Nothing where no loop of it agrees with the poses.
std::optional<Marginalised> marginalise(std::size_t submap, const std::vector<Edge>& edges,
                                        const std::vector<Pose2>& poses);

}  // namespace bw::slam
