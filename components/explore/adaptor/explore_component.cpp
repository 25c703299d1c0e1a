// Adaptor of exploring: follows the map, drives to its frontiers by navigate_to_pose. Topics: README.md.
#include "components/explore/adaptor/explore_component.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <fmt/format.h>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/base_stop_source.hpp"
#include "components/messages/current_footprint.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/markers.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/robot.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using explore::ExploreState;
using explore::ExploreStep;
using explore::GoalEnd;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;

constexpr Duration kEvery = Duration::milliseconds(1000);
constexpr Duration kPatience = Duration::milliseconds(1000);  // for a goal to be accepted
constexpr Duration kOldestPose = Duration::milliseconds(1000);
constexpr double kSize = 0.25;  // [m] of a marker
constexpr Color kFrontierColor{0.0F, 0.45F, 0.70F, 0.9F};
constexpr Color kLeft{0.84F, 0.37F, 0.0F, 0.9F};
constexpr std::string_view kNoPose = "odometry/filtered does not say where the robot is";
constexpr std::size_t kMostTold = 10;  // frontiers in a status

}  // namespace

class ExploreComponent final : public Component {
 public:
  explicit ExploreComponent(bool return_to_init = true) : explorer_(return_to_init) {}

  void configure(Setup& setup) override {
    setup.longest_callback(Duration::milliseconds(5'000));  // a large map
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    footprint_.listen(setup, setup.shared<Robot>("robot"));
    odometry_ = setup.latest<nav_msgs::msg::Odometry>("odometry/filtered", Qos::command());
    base_.listen(setup);
    navigation_ = setup.latest<bandwagon_msgs::msg::NavigationStatus>("navigation_status", Qos::standard(),
                                                                      Need::optional);
    status_ = setup.output<std_msgs::msg::String>("explore/status", Qos::latched());
    frontiers_ = setup.output<MarkerArray>("explore/frontiers", Qos::latched());
    map_ = listen_to_map(setup, [this](const KnownMap&, const Tick&) { is_new_map_ = true; });
    setup.input<std_msgs::msg::Bool>(
        "explore/resume", Qos::standard(),
        [this](const std_msgs::msg::Bool& message, const Tick& tick) { on_resume(message.data(), tick); },
        Need::optional);
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
      const std::uint64_t number = ++number_;
      return client.send(
          goal, kPatience,
          {.on_acknowledged =
               [this, number](bool accepted, const Tick& tick) {
                 if (!accepted) end_goal(number, GoalEnd::failed, "it was not accepted", tick.now);
               },
           .on_result =
               [this, number](GoalStatus status, const typename Action::Result* result, const Tick& tick) {
                 const std::string why = result == nullptr ? "no result came" : error_text_of(*result);
                 if (number == number_ && goal_ && is_taken_over(status, why)) return hand_over();
                 end_goal(number, status == GoalStatus::succeeded ? GoalEnd::reached : GoalEnd::failed, why,
                          tick.now);
               }});
    };
  }

  /// By somebody's hand: whoever cancels the goal, or sets another, wants the robot for himself. Humble's results have
  /// no text; there the navigator is heard to drive to something else.
  bool is_taken_over(GoalStatus status, const std::string& why) const {
    if (status == GoalStatus::succeeded) return false;
    namespace statuses = bandwagon_msgs::msg::NavigationStatus_Constants;
    const bool drives_on = navigation_ && navigation_->status() <= statuses::EXECUTING;
    return status == GoalStatus::canceled || why.starts_with("preempted") || drives_on;
  }

  std::optional<Pose2> pose(Time now) const {
    if (!odometry_ || now - odometry_.received() > kOldestPose) return std::nullopt;
    const Pose2 X_MB = from_pose(odometry_->pose().pose());
    return is_finite(X_MB) ? std::optional(X_MB) : std::nullopt;
  }

  void on_resume(bool resume, const Tick& tick) {
    if (!resume) {
      carry_out(explorer_.pause(), tick);
    } else if (const std::optional<Pose2> X_MB = pose(tick.now)) {
      explorer_.resume(*X_MB);
    } else {
      waits_for_ = kNoPose;
      return tell();
    }
    waits_for_.clear();
    tell();
  }

  void look(const Tick& tick) {
    report();
    if (canceled_) cancel_(*canceled_);  // it drives on: the navigator may not have heard
    const ExploreState state = explorer_.state();
    if (state != ExploreState::exploring && state != ExploreState::returning) return;
    const std::optional<Pose2> X_MB = pose(tick.now);
    waits_for_ = reason_to_wait(X_MB.has_value(), tick.now);
    if (!waits_for_.empty()) return tell();
    if (!is_new_map_ && !explorer_.is_idle()) return tell();
    is_new_map_ = false;
    const explore::FrontierSearch search =
        explore::find_frontiers(map_->grid, X_MB->position(), {.radius = footprint_.now().radius});
    if (!search.is_placed) waits_for_ = "the robot stands on no free ground of the map";
    const ExploreStep step = explorer_.look(search);
    show(search, tick.now);
    carry_out(step, tick);
    tell();
  }

  std::string reason_to_wait(bool has_pose, Time now) const {
    if (map_->frame.empty()) return "there is no map yet";
    if (!has_pose) return std::string(kNoPose);
    if (!is_ready_()) return "nobody offers navigate_to_pose";
    // A goal in hand waits with the base; a new one would be refused.
    if (const auto stop = base_.at(now)) return in_words(*stop);
    return {};
  }

  void carry_out(const ExploreStep& step, const Tick& tick) {
    if (step.cancels && goal_) {
      canceled_ = std::exchange(goal_, std::nullopt);
      cancel_(*canceled_);
    }
    if (!step.goal) return;
    if (goal_) forget_(*goal_);  // the newer one takes its place
    canceled_.reset();
    geometry_msgs::msg::PoseStamped pose;
    pose.header(make_header(map_->frame, tick.now));
    pose.pose(to_pose(*step.goal));
    goal_ = send_(pose);
  }

  void end_goal(std::uint64_t number, GoalEnd end, const std::string& why, Time now) {
    if (number != number_) return;
    canceled_.reset();
    if (!goal_) return;
    goal_.reset();
    const bool is_its_fault = !pose(now) || base_.at(now);
    if (end == GoalEnd::failed && is_its_fault) end = GoalEnd::dropped;
    if (end != GoalEnd::reached) log_.warn("a goal was not reached: {}", why);
    explorer_.goal_ended(end, why);
    tell();
  }

  void hand_over() {
    goal_.reset();
    explorer_.pause();
    log_.warn("paused: somebody took the robot over; `explore/resume` goes on");
    tell();
  }

  /// State, and what is left: "exploration_complete: 12 goals, 1 not reached; left: (3.2, 4.1) not reached: ...".
  std::string status_text() const {
    std::string text = fmt::format("{}: {} goals, {} not reached", to_string(explorer_.state()),
                                   explorer_.goals(), explorer_.failed());
    if (!waits_for_.empty()) text += "; waits: " + waits_for_;
    const auto& left = explorer_.left();
    for (std::size_t k = 0; k < std::min(left.size(), kMostTold); ++k)
      text += fmt::format("{} ({:.1f}, {:.1f}) {}", k == 0 ? "; left:" : ";", left[k].centre.x(),
                          left[k].centre.y(), left[k].why);
    if (left.size() > kMostTold) text += fmt::format("; and {} more", left.size() - kMostTold);
    return text;
  }

  /// On the topic when the state is another, or what it waits for.
  void tell() {
    std::pair news{explorer_.state(), waits_for_};
    if (told_ == news) return;
    told_ = std::move(news);
    std_msgs::msg::String message;
    message.data(status_text());
    status_.publish(message);
    log_.info("{}", message.data());
  }

  void report() {
    using Level = DiagnosticReporter::Level;
    const bool is_incomplete = explorer_.state() == ExploreState::complete && !explorer_.left().empty();
    diagnostics_->report(is_incomplete || !waits_for_.empty() ? Level::warn : Level::ok, status_text());
  }

  void show(const explore::FrontierSearch& search, Time now) {
    const std_msgs::msg::Header header = make_header(map_->frame, now);
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
    for (const explore::LeftFrontier& frontier : explorer_.left()) add(frontier.centre, kLeft);
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
  Latest<bandwagon_msgs::msg::NavigationStatus> navigation_;
  BaseStopSource base_;
  std::shared_ptr<const KnownMap> map_;
  bool is_new_map_ = false;
  std::string waits_for_;           ///< empty: for nothing
  std::uint64_t number_ = 0;        ///< of the newest goal
  std::optional<GoalId> goal_;      ///< in hand
  std::optional<GoalId> canceled_;  ///< and has not ended yet
  explore::Explorer explorer_;
  std::optional<std::pair<ExploreState, std::string>> told_;
};

BW_COMPONENT(ExploreComponent, "explore")

std::unique_ptr<Component> make_explore_component(bool return_to_init) {
  return std::make_unique<ExploreComponent>(return_to_init);
}

}  // namespace bw
