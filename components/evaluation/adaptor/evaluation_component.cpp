// Adaptor of evaluation: keeps score of the drive that the navigator reports, from the world's truth, and
// draws it when it is over.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/score_card.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/evaluation/run_recorder.hpp"
#include "components/evaluation/score_keeper.hpp"
#include "components/evaluation/svg_picture.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/robot.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::NavigationStatus;
namespace status_value = bandwagon_msgs::msg::NavigationStatus_Constants;

struct EvaluationParameters : EvaluationOptions {
  double rate = 2.0;
  std::string svg;
  std::string title = "Bandwagon";

  template <class Visitor>
  void fields(Visitor& v) {
    EvaluationOptions::fields(v);
    v("rate", rate, {.unit = "Hz", .min = 0.1, .max = 50, .doc = "score cards per second while driving"});
    v("svg", svg, {.doc = "file for the picture of the run; empty: none"});
    v("title", title, {.doc = "heading of the picture"});
  }
};

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
        "map", Qos::latched(), [this](const auto& message, const Tick&) { on_map(message); }, Need::optional);
    setup.every(Duration::seconds(1.0 / parameters_.rate), "score_card", [this](const Tick& tick) {
      if (keeper_->running()) publish(tick);
    });
  }

  void deactivate(const Tick& tick) override {
    if (!keeper_->running()) return;
    publish(tick);
    draw();
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
      keeper_->start(tick.now, goal);
      errors_ = {};
      recorder_->start(tick.now, goal);
    }
    if (!is_final || message.goal_id() != goal_id_ || !keeper_->running()) return;
    keeper_->finish(tick.now, message.status() == status_value::SUCCEEDED, message.reason());
    publish(tick);
    draw();
  }

  void on_map(const nav_msgs::msg::OccupancyGrid& message) {
    if (const std::optional<OccupancyGrid> map = to_grid(message)) {
      recorder_->set_map(*map);
    } else {
      log_.warn("the map's sizes disagree: the picture goes without");
    }
  }

  void publish(const Tick& tick) {
    card_.publish(to_message(keeper_->card(), errors_, make_header(map_frame_, tick.now)));
  }

  void draw() {
    if (svg_path_.empty()) return;
    try {
      write_file_atomically(
          svg_path_, svg_picture(recorder_->recording(), keeper_->card(), {.title = parameters_.title}));
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
  Logger log_;
  std::string map_frame_;
  Output<bandwagon_msgs::msg::ScoreCard> card_;
};

}  // namespace

BW_COMPONENT(EvaluationComponent, "evaluation")

}  // namespace bw
