// The planner together with what was told of the world: the map, where frames and people are. Requests are
// messages.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/global_planner_parameters.hpp"
#include "components/global_planner/planner.hpp"
#include "components/mapping/adaptor/keepout_mask.hpp"
#include "components/messages/current_footprint.hpp"
#include "components/messages/map_input.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

/// A path to be planned. The last stop is the goal.
struct RouteRequest {
  std::optional<geometry_msgs::msg::PoseStamped> start;  ///< nothing: where the robot is
  std::vector<geometry_msgs::msg::PoseStamped> stops;
  /// A pose in another frame than the map's is where that frame was at the stamp of the pose; a stamp of 0,
  /// and false, mean where it is now.
  bool at_their_stamps = false;
};

class MapPlanner {
 public:
  /// Declares the inputs map, keepout_filter_mask, obstacles (if they are planned around), tracks and /tf, and
  /// reads the parameters.
  void configure(Setup& setup);

  PathResult plan(const RouteRequest& request, Time now);
  /// Says nothing in the log: in lock-step a line is a sample of the run, and a question must not make one.
  PathCheck check(const nav_msgs::msg::Path& path, Time now);

  /// Empty until a usable map came.
  const std::string& map_frame() const { return map_frame_; }
  const GlobalPlannerParameters& parameters() const { return parameters_; }

 private:
  void keep_map();
  /// On failure `reason` says why, in words behind "the start", "pose 2".
  std::optional<Pose2> in_map(const geometry_msgs::msg::PoseStamped& pose, bool at_its_stamp,
                              std::string& reason) const;
  std::vector<Disc> standing_people(const Pose2& start, Time now) const;
  /// Gives the planner a map with what is in the way beside it: keep-out zones, and where they are planned
  /// around the obstacles seen last, where their frames are in the map now. Returns why it is none.
  std::string prepare(OccupancyGrid map, const std::string& frame);
  void prepare_again();
  /// Which of these poses lie in keep-out zones, for a reason; empty: none.
  std::string kept_out(const std::vector<Pose2>& poses) const;

  GlobalPlannerParameters parameters_;
  CurrentFootprint footprint_;
  std::shared_ptr<const KnownMap> map_;
  KeepoutMask keepout_;
  Planner planner_;
  Logger log_;
  std::string map_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Latest<bandwagon_msgs::msg::Obstacles> obstacles_;
};

}  // namespace bw
