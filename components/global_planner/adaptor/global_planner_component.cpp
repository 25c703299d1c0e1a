// Adaptor of the global planner: plan requests in, plan results and the path out.
#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/adaptor/plan_messages.hpp"
#include "components/global_planner/adaptor/planner_services.hpp"
#include "components/global_planner/costs.hpp"
#include "components/global_planner/global_planner_parameters.hpp"
#include "components/global_planner/planner.hpp"
#include "components/messages/costmap.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

class GlobalPlannerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<GlobalPlannerParameters>(
        [this](const GlobalPlannerParameters& changed, const Tick&) {
          options_ = changed;
          planner_.set_options(changed.planner);
        },
        {"clearance_range", "clearance_weight", "unknown_is_obstacle", "occupied_at"});
    robot_radius_ = setup.shared<Robot>("robot").radius;
    planner_ = Planner(options_.planner);
    log_ = setup.log();
    base_frame_ = setup.frame("base_link");
    transforms_ = setup.transforms();
    tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(), Need::optional);
    result_ = setup.output<bandwagon_msgs::msg::PlanResult>("plan_result");
    plan_ = setup.output<nav_msgs::msg::Path>("plan");
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [this](const auto& message, const Tick&) { keep_map(message); });
    setup.input<bandwagon_msgs::msg::PlanRequest>(
        "plan_request", Qos::standard(),
        [this](const auto& request, const Tick& tick) { answer(request, tick.now); });
    offer_planner_services(
        setup, {.check = [this](const nav_msgs::msg::Path& path, Time now) { return check(path, now); },
                .costs = [this](Time now) { return costs(now); }});
  }

 private:
  void keep_map(const nav_msgs::msg::OccupancyGrid& message) {
    OccupancyGrid grid;
    std::string fault = read_grid(message, grid);
    if (fault.empty()) fault = planner_.set_map(grid, robot_radius_);
    if (!fault.empty()) {
      log_.warn("the map is not used: {}", fault);
      return;
    }
    map_ = std::move(grid);
    map_frame_ = message.header().frame_id();
  }

  /// Says nothing in the log: in lock-step a line is a sample of the run, and a question must not make one.
  PathCheck check(const nav_msgs::msg::Path& message, Time now) {
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

  nav2_msgs::msg::Costmap costs(Time now) const {
    if (map_frame_.empty()) return {};
    return to_costmap(map_, costs_of(planner_.grid(), map_, options_.planner.clearance_weight), map_frame_,
                      now);
  }

  void answer(const bandwagon_msgs::msg::PlanRequest& request, Time now) {
    const PathResult result = plan(request, now);
    const auto message = to_plan_result(result, request.id(), make_header(map_frame_, now));
    result_.publish(message);
    if (result.status == PathStatus::ok) plan_.publish(message.path());
  }

  PathResult plan(const bandwagon_msgs::msg::PlanRequest& request, Time now) {
    if (map_frame_.empty()) return {.status = PathStatus::no_map, .reason = "there is no map yet"};
    const std::optional<Pose2> start =
        request.use_start() ? in_map(request.start()) : transforms_->lookup_planar(map_frame_, base_frame_);
    const std::optional<Pose2> goal = in_map(request.goal());
    if (!start)
      return {.status = PathStatus::bad_request, .reason = "the start's place in the map is not known"};
    if (!goal)
      return {.status = PathStatus::bad_request, .reason = "the goal's place in the map is not known"};
    const std::vector<Disc> standing = standing_people(*start, now);
    PathResult result = planner_.plan(*start, *goal, standing);
    // People move: a path that has to wait for them is better than none.
    if (result.status != PathStatus::ok && !standing.empty()) result = planner_.plan(*start, *goal);
    return result;
  }

  std::optional<Pose2> in_map(const geometry_msgs::msg::PoseStamped& pose) const {
    const std::string& frame = pose.header().frame_id();
    if (frame.empty() || frame == map_frame_) return from_pose(pose.pose());
    const std::optional<Pose2> X_MF = transforms_->lookup_planar(map_frame_, frame);
    if (!X_MF) return std::nullopt;
    return *X_MF * from_pose(pose.pose());
  }

  std::vector<Disc> standing_people(const Pose2& start, Time now) const {
    constexpr Duration kOldest = Duration::milliseconds(1000);
    std::vector<Disc> discs;
    if (!tracks_ || now - tracks_.received() > kOldest) return discs;
    const std::optional<Pose2> X_MF = transforms_->lookup_planar(map_frame_, tracks_->header().frame_id());
    if (!X_MF) return discs;
    for (const auto& track : tracks_->tracks()) {
      if (!(std::hypot(track.velocity().x(), track.velocity().y()) < options_.standing_speed)) continue;
      const Disc disc{*X_MF * Vector2{track.position().x(), track.position().y()}, track.radius()};
      const bool near = (disc.center - start.position()).norm() < options_.standing_within;  // false for NaN
      if (near && std::isfinite(disc.radius)) discs.push_back(disc);
    }
    return discs;
  }

  GlobalPlannerParameters options_;
  double robot_radius_ = 0.0;
  Planner planner_;
  Logger log_;
  OccupancyGrid map_;      ///< that the planner was given
  std::string map_frame_;  ///< empty until a usable map came
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Output<bandwagon_msgs::msg::PlanResult> result_;
  Output<nav_msgs::msg::Path> plan_;
};

BW_COMPONENT(GlobalPlannerComponent, "global_planner")

}  // namespace bw
