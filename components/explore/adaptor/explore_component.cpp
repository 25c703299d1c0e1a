// Adaptor of exploring: follows the map, drives to its frontiers by navigate_to_pose. Topics: README.md.
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/set_bool.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/explore/explorer.hpp"
#include "components/messages/current_footprint.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/markers.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using explore::ExploreState;
using explore::ExploreStep;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;

constexpr Duration kEvery = Duration::milliseconds(1000);
constexpr Duration kPatience = Duration::milliseconds(1000);  // for a goal to be accepted
constexpr Duration kOldestPose = Duration::milliseconds(1000);
constexpr double kSize = 0.25;  // [m] of a marker
constexpr Color kFrontierColor{0.0F, 0.45F, 0.70F, 0.9F};
constexpr Color kTooFar{0.84F, 0.37F, 0.0F, 0.9F};

/// How a goal ended, for the explorer.
enum class GoalEnd { reached, failed, taken_over };

}  // namespace

class ExploreComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    footprint_.listen(setup, setup.shared<Robot>("robot"));
    odometry_ = setup.latest<nav_msgs::msg::Odometry>("odometry/filtered", Qos::command());
    status_ = setup.output<std_msgs::msg::String>("explore/status", Qos::latched());
    frontiers_ = setup.output<MarkerArray>("explore/frontiers", Qos::latched());
    listen_to_map(setup, [this](const nav_msgs::msg::OccupancyGrid& message, const Tick&) {
      map_ = message;
      is_new_map_ = true;
    });
    setup.input<std_msgs::msg::Bool>(
        "explore/resume", Qos::standard(),
        [this](const std_msgs::msg::Bool& message, const Tick& tick) {
          const std::string fault = on_resume(message.data(), tick);
          if (!fault.empty()) log_.warn("does not explore: {}", fault);
        },
        Need::optional);
    const auto answer = [](const std::string& fault) {
      std_srvs::srv::SetBool::Response response;
      response.success(fault.empty());
      response.message(fault);
      return response;
    };
    setup.service<std_srvs::srv::SetBool>(
        "explore/enable",
        [this, answer](const std_srvs::srv::SetBool::Request& request, const Tick& tick) {
          return answer(on_resume(request.data(), tick));
        },
        answer);
    with_nav2_layout(setup.ros_distro(),
                     [&](auto layout) { declare_client<typename decltype(layout)::NavigateToPose>(setup); });
    setup.every(kEvery, "explore", [this](const Tick& tick) { look(tick); });
  }

  void activate(const Tick&) override { tell(); }
  void deactivate(const Tick& tick) override { carry_out(explorer_.pause(), tick); }

 private:
  template <class Action>
  void declare_client(Setup& setup) {
    const auto client = setup.action_client<Action>("navigate_to_pose");
    is_ready_ = [client] { return client.is_ready(); };
    cancel_ = [client](const GoalId& id) { client.cancel(id); };
    forget_ = [client](const GoalId& id) { client.forget(id); };
    send_ = [this, client](const geometry_msgs::msg::PoseStamped& pose) {
      typename Action::Goal goal;
      goal.pose(pose);
      return client.send(
          goal, kPatience,
          {.on_acknowledged =
               [this](bool accepted, const Tick&) {
                 if (!accepted) end_goal(GoalEnd::failed, "it was not accepted");
               },
           .on_result =
               [this](GoalStatus status, const typename Action::Result* result, const Tick&) {
                 const std::string text = result == nullptr ? std::string() : error_text_of(*result);
                 if (status == GoalStatus::succeeded) return end_goal(GoalEnd::reached, text);
                 // By somebody's hand: whoever cancels the goal, or sets another, wants the robot for himself.
                 const bool is_taken = status == GoalStatus::canceled || text.starts_with("preempted");
                 end_goal(is_taken ? GoalEnd::taken_over : GoalEnd::failed, text);
               }});
    };
  }

  std::optional<Pose2> pose(Time now) const {
    if (!odometry_ || now - odometry_.received() > kOldestPose) return std::nullopt;
    const Pose2 X_MB = from_pose(odometry_->pose().pose());
    return is_finite(X_MB) ? std::optional(X_MB) : std::nullopt;
  }

  /// Why it does not explore; empty: it is as was asked.
  std::string on_resume(bool resume, const Tick& tick) {
    const std::optional<Pose2> X_MB = pose(tick.now);
    if (!resume)
      carry_out(explorer_.pause(), tick);
    else if (!X_MB)
      return "odometry/filtered does not say where the robot is";
    else
      explorer_.resume(*X_MB);
    is_new_map_ = true;
    tell();
    return {};
  }

  void look(const Tick& tick) {
    report();
    if (explorer_.state() != ExploreState::exploring) return;
    if (goal_ && !is_new_map_) return;
    const std::optional<Pose2> X_MB = pose(tick.now);
    OccupancyGrid map;
    if (!X_MB || !is_ready_() || !read_grid(map_, map).empty()) return;
    is_new_map_ = false;
    const explore::FrontierSearch search =
        explore::find_frontiers(map, X_MB->position(), {.radius = footprint_.now().radius});
    show(search, tick.now);
    carry_out(explorer_.look(search), tick);
    tell();
  }

  void carry_out(const ExploreStep& step, const Tick& tick) {
    if (step.cancels && goal_) cancel_(*goal_);
    if (goal_ && (step.cancels || step.goal)) {
      forget_(*goal_);
      goal_.reset();
    }
    if (!step.goal) return;
    geometry_msgs::msg::PoseStamped pose;
    pose.header(make_header(map_.header().frame_id(), tick.now));
    pose.pose(to_pose(*step.goal));
    goal_ = send_(pose);
  }

  void end_goal(GoalEnd end, const std::string& why) {
    goal_.reset();
    if (end == GoalEnd::taken_over) {
      explorer_.pause();
      log_.warn("paused: somebody took the goal over; `explore/resume` goes on");
    } else {
      if (end == GoalEnd::failed) log_.warn("a frontier was not reached: {}", why);
      explorer_.goal_ended(end == GoalEnd::reached);
    }
    tell();
  }

  void tell() {
    if (std::exchange(told_, explorer_.state()) == explorer_.state()) return;
    std_msgs::msg::String message;
    message.data(std::string(to_string(explorer_.state())));
    status_.publish(message);
    log_.info("{}; {}", message.data(), summary());
  }

  std::string summary() const {
    return fmt::format("{} goals, {} of them not reached; {} frontiers given up", explorer_.goals(),
                       explorer_.failed(), explorer_.given_up());
  }

  void report() {
    using Level = DiagnosticReporter::Level;
    const bool is_incomplete = explorer_.state() == ExploreState::complete && explorer_.given_up() > 0;
    diagnostics_->report(is_incomplete ? Level::warn : Level::ok,
                         fmt::format("{}: {}", to_string(explorer_.state()), summary()));
  }

  void show(const explore::FrontierSearch& search, Time now) {
    const std_msgs::msg::Header header = make_header(map_.header().frame_id(), now);
    namespace constants = visualization_msgs::msg::Marker_Constants;
    Marker points = make_marker("frontiers", 0, constants::SPHERE_LIST, {}, header);
    points.scale().x(kSize);
    points.scale().y(kSize);
    points.scale().z(kSize);
    const auto add = [&](const Vector2& centre, const Color& color) {
      points.points().push_back(to_point(centre));
      points.colors().push_back(to_color(color));
    };
    for (const explore::Frontier& frontier : search.frontiers) add(frontier.centre, kFrontierColor);
    for (const Vector2& centre : search.out_of_reach) add(centre, kTooFar);
    if (points.points().empty()) points.action(constants::DELETEALL);
    MarkerArray array;
    array.markers().push_back(std::move(points));
    frontiers_.publish(array);
  }

  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  CurrentFootprint footprint_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Output<std_msgs::msg::String> status_;
  Output<MarkerArray> frontiers_;
  std::function<bool()> is_ready_;
  std::function<GoalId(const geometry_msgs::msg::PoseStamped&)> send_;
  std::function<void(const GoalId&)> cancel_;
  std::function<void(const GoalId&)> forget_;
  nav_msgs::msg::OccupancyGrid map_;
  bool is_new_map_ = false;
  std::optional<GoalId> goal_;
  explore::Explorer explorer_{explore::ExplorerOptions{}};
  std::optional<ExploreState> told_;
};

BW_COMPONENT(ExploreComponent, "explore")

}  // namespace bw
