#include "components/global_planner/adaptor/map_planner.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"
#include "components/model/mover_weight.hpp"
#include "components/model/robot.hpp"

namespace bw {
namespace {

/// A pose that was stamped a moment ago may be ahead of the transforms, as Nav2's costmaps allow it.
constexpr Duration kTransformTolerance = Duration::milliseconds(300);

std::string name_of(std::size_t i, std::size_t count) {
  return count == 1 ? std::string("the goal") : fmt::format("pose {} of {}", i + 1, count);
}

}  // namespace

void MapPlanner::configure(Setup& setup) {
  parameters_ = setup.parameters<GlobalPlannerParameters>(
      [this](const GlobalPlannerParameters& changed, const Tick&) {
        parameters_ = changed;
        planner_.set_options(changed.planner);
      },
      {"clearance_range", "clearance_weight", "unknown_is_obstacle", "plan_around_obstacles"});
  footprint_.listen(setup, setup.shared<Robot>("robot"), [this](const Footprint&) { prepare_again(); });
  planner_ = Planner(parameters_.planner);
  log_ = setup.log();
  base_frame_ = setup.frame("base_link");
  transforms_ = setup.transforms();
  tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(), Need::optional);
  if (parameters_.plan_around_obstacles)
    obstacles_ = setup.latest<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::standard(), Need::optional);
  map_ = listen_to_map(setup, [this](const KnownMap&, const Tick&) { keep_map(); });
  keepout_.listen(setup, transforms_, [this](const Tick&) { prepare_again(); });
}

void MapPlanner::keep_map() {
  const std::string fault = prepare(map_->grid, map_->frame);
  if (fault.empty())
    map_frame_ = map_->frame;
  else
    log_.warn("the map is not used: {}", fault);
}

std::string MapPlanner::prepare(OccupancyGrid map, const std::string& frame) {
  keepout_.mark(map, frame);
  StaticObstacles seen;
  if (obstacles_) {
    const auto X_MO = transforms_->lookup_planar(frame, obstacles_->header().frame_id());
    if (X_MO) seen = to_obstacles(*obstacles_, *X_MO);
  }
  return planner_.set_map(map, footprint_.now(), seen);
}

void MapPlanner::prepare_again() {
  if (!map_frame_.empty()) prepare(map_->grid, map_frame_);
}

std::string MapPlanner::kept_out(const std::vector<Pose2>& poses) const {
  std::string places;
  for (const Pose2& pose : poses) {
    if (keepout_.hold(pose.position(), map_frame_))
      places += fmt::format("; ({:.2f}, {:.2f}) lies in a keep-out zone", pose.x, pose.y);
  }
  return places;
}

PathResult MapPlanner::plan(const RouteRequest& request, Time now) {
  if (map_frame_.empty()) return {.status = PathStatus::no_map, .reason = "there is no map yet"};
  if (std::string fault = keepout_.fault(map_frame_); !fault.empty())
    return {.status = PathStatus::unplaced, .reason = std::move(fault)};
  const auto unplaced = [](const std::string& who, const std::string& reason) {
    return PathResult{.status = PathStatus::unplaced, .reason = who + " " + reason};
  };
  std::string reason = fmt::format("is not known: no transform from {} to {}", base_frame_, map_frame_);
  const std::optional<Pose2> start = request.start ? in_map(*request.start, request.at_their_stamps, reason)
                                                   : transforms_->lookup_planar(map_frame_, base_frame_);
  if (!start) return unplaced(request.start ? "the start" : "the robot's place", reason);
  std::vector<Pose2> stops;
  for (const auto& pose : request.stops) {
    const std::optional<Pose2> stop = in_map(pose, request.at_their_stamps, reason);
    if (!stop) return unplaced(name_of(stops.size(), request.stops.size()), reason);
    stops.push_back(*stop);
  }
  if (parameters_.plan_around_obstacles || keepout_.is_elsewhere(map_frame_)) prepare_again();
  const std::vector<Disc> standing = standing_people(*start, now);
  PathResult result = planner_.plan_through(*start, stops, standing);
  // People move: a path that has to wait for them is better than none.
  if (result.status != PathStatus::ok && !standing.empty()) result = planner_.plan_through(*start, stops);
  if (result.status == PathStatus::start_blocked) result.reason += kept_out({*start});
  if (result.status == PathStatus::goal_blocked) result.reason += kept_out(stops);
  return result;
}

PathCheck MapPlanner::check(const nav_msgs::msg::Path& message, Time now) {
  const std::string& frame = message.header().frame_id();
  const bool is_in_map = frame.empty() || frame == map_frame_;
  const auto X_MF = is_in_map ? std::optional(Pose2{}) : transforms_->lookup_planar(map_frame_, frame);
  if (map_frame_.empty() || !X_MF) return {};
  std::vector<Pose2> path = from_path(message);
  for (Pose2& pose : path) pose = *X_MF * pose;
  const auto X_MB = transforms_->lookup_planar(map_frame_, base_frame_);
  if (!X_MB) return planner_.check(path, std::nullopt);
  return planner_.check(path, X_MB->position(), standing_people(*X_MB, now));
}

std::optional<Pose2> MapPlanner::in_map(const geometry_msgs::msg::PoseStamped& pose, bool at_its_stamp,
                                        std::string& reason) const {
  const std::string& frame = pose.header().frame_id();
  if (frame.empty() || frame == map_frame_) return from_pose(pose.pose());
  const Time stamp = at_its_stamp ? from_stamp(pose.header().stamp()) : Time{};
  if (const auto X_MF = transforms_->lookup_planar(map_frame_, frame, stamp))
    return *X_MF * from_pose(pose.pose());
  const std::optional<Pose2> X_MF = transforms_->lookup_planar(map_frame_, frame);
  if (X_MF && transforms_->lookup_planar(map_frame_, frame, stamp - kTransformTolerance))
    return *X_MF * from_pose(pose.pose());
  reason = X_MF ? fmt::format("is stamped {:.3f} s, and where '{}' was then is not known", stamp.to_seconds(),
                              frame)
                : fmt::format("is in frame '{}', which no transform joins to '{}'", frame, map_frame_);
  return std::nullopt;
}

std::vector<Disc> MapPlanner::standing_people(const Pose2& start, Time now) const {
  constexpr Duration kOldest = Duration::milliseconds(1000);
  std::vector<Disc> discs;
  if (!tracks_ || now - tracks_.received() > kOldest) return discs;
  const std::optional<Pose2> X_MF = transforms_->lookup_planar(map_frame_, tracks_->header().frame_id());
  if (!X_MF) return discs;
  for (const auto& track : tracks_->tracks()) {
    if (!is_confirmed(track.confidence())) continue;
    if (!(std::hypot(track.velocity().x(), track.velocity().y()) < parameters_.kStandingSpeed)) continue;
    const Disc disc{*X_MF * Vector2{track.position().x(), track.position().y()}, track.radius()};
    const bool near = (disc.center - start.position()).norm() < parameters_.kStandingWithin;  // false for NaN
    if (near && std::isfinite(disc.radius)) discs.push_back(disc);
  }
  return discs;
}

}  // namespace bw
