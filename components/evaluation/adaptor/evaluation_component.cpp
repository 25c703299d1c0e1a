// Adaptor of evaluation: keeps score of the drive that the navigator reports, from the world's truth, and
// draws it when it is over.
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/score_card.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/evaluation/evaluation_parameters.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/evaluation/svg_picture.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"
#include "components/model/robot.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::NavigationStatus;
namespace status_value = bandwagon_msgs::msg::NavigationStatus_Constants;

constexpr double kClockStep = 0.1;  // [s] by which a run may end before its limit

class EvaluationComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<EvaluationParameters>();
    svg_path_ = setup.file_parameter("svg");
    const auto robot = setup.shared<Robot>("robot");
    keeper_.emplace(parameters_, robot.radius);
    recorder_.emplace(robot.radius, robot.limits.v_max);
    log_ = setup.log();
    map_frame_ = setup.frame("map");
    card_ = setup.output<bandwagon_msgs::msg::ScoreCard>("score_card");
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(), [this](const auto& message, const Tick&) { on_truth(message); });
    setup.input<nav_msgs::msg::Odometry>(
        "odometry/filtered", Qos::standard(50),
        [this](const auto& message, const Tick&) { on_pose(message); }, Need::optional);
    setup.input<NavigationStatus>(
        "navigation_status", Qos::standard(),
        [this](const auto& message, const Tick& tick) { on_status(message, tick); });
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(),
        [this](const auto& message, const Tick&) {
          if (const auto map = grid_of(message)) recorder_->set_map(*map);
        },
        Need::optional);
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "sim/map", Qos::latched(),
        [this](const auto& message, const Tick&) {
          if (const auto map = grid_of(message)) recorder_->set_true_map(*map);
        },
        Need::optional);
    setup.input<bandwagon_msgs::msg::Obstacles>(
        "sim/obstacles", Qos::latched(),
        [this](const auto& message, const Tick&) { recorder_->set_shapes(to_obstacles(message, Pose2{})); },
        Need::optional);
    setup.every(Duration::seconds(1.0 / parameters_.rate), "score_card", [this](const Tick& tick) {
      if (keeper_->running()) publish(tick);
    });
  }

  void activate(const Tick& tick) override { activated_ = tick.now; }

  void deactivate(const Tick& tick) override {
    if (!keeper_->running()) return;
    publish(tick);
    const bool is_late = parameters_.time_limit > 0.0 &&
                         (tick.now - activated_).to_seconds() >= parameters_.time_limit - kClockStep;
    draw(is_late ? "timeout" : "ended early");
  }

 private:
  void on_truth(const bandwagon_msgs::msg::GroundTruth& message) {
    if (!keeper_->running()) return;
    const TruthSample sample = to_truth(message);
    keeper_->add(sample);
    errors_.set_truth(sample);
    recorder_->add(sample);
  }

  void on_pose(const nav_msgs::msg::Odometry& message) {
    if (keeper_->running())
      errors_.add(from_stamp(message.header().stamp()), from_pose(message.pose().pose()));
  }

  void on_status(const NavigationStatus& message, const Tick& tick) {
    const bool is_final = message.status() >= status_value::SUCCEEDED;
    const bool is_new = message.goal_id() > goal_id_ && (!is_final || !keeper_->running());
    if (is_new) {
      goal_id_ = message.goal_id();
      const Vector2 goal = from_pose(message.goal().pose()).position();
      keeper_->start(tick.now, goal, tolerance_of(message));
      errors_ = {};
      recorder_->start(tick.now, goal);
    }
    if (!is_final || message.goal_id() != goal_id_ || !keeper_->running()) return;
    keeper_->finish(tick.now, message.status() == status_value::SUCCEEDED, message.reason());
    publish(tick);
    draw();
  }

  std::optional<OccupancyGrid> grid_of(const nav_msgs::msg::OccupancyGrid& message) const {
    std::optional<OccupancyGrid> map = to_grid(message);
    if (!map) log_.warn("the map's sizes disagree: the picture goes without");
    return map;
  }

  void publish(const Tick& tick) {
    card_.publish(to_message(keeper_->card(), errors_, make_header(map_frame_, tick.now)));
  }

  void draw(const std::string& unfinished = "") {
    if (svg_path_.empty()) return;
    try {
      write_file_atomically(svg_path_, svg_picture(recorder_->recording(), keeper_->card(),
                                                   {.title = parameters_.title, .unfinished = unfinished}));
    } catch (const std::exception& error) {
      log_.error("no picture of the run: {}", error.what());
    }
  }

  EvaluationParameters parameters_;
  std::filesystem::path svg_path_;
  std::optional<ScoreKeeper> keeper_;
  PoseErrors errors_;
  std::optional<RunRecorder> recorder_;
  std::uint64_t goal_id_ = 0;
  Time activated_;
  Logger log_;
  std::string map_frame_;
  Output<bandwagon_msgs::msg::ScoreCard> card_;
};

}  // namespace

BW_COMPONENT(EvaluationComponent, "evaluation")

}  // namespace bw
