// Adaptor of evaluation: keeps score of the drive that the navigator reports, from the world's truth, and
// draws it when it is over. What it tells of comfort meanwhile: comfort_output.hpp.
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

#include "components/evaluation/adaptor/comfort_output.hpp"
#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/evaluation/drive_judge.hpp"
#include "components/evaluation/evaluation_parameters.hpp"
#include "components/evaluation/svg_picture.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/obstacles.hpp"
#include "components/model/robot.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

constexpr double kClockStep = 0.1;  // [s] by which a run may end before its limit

class EvaluationComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<EvaluationParameters>();
    is_run_ = parameters_.scored == Scored::run;
    svg_path_ = setup.file_parameter("svg");
    const auto robot = setup.shared<Robot>("robot");
    judge_.emplace(parameters_, robot.outline(), robot.limits.v_max,
                   parameters_.scored == Scored::drives ? DriveJudge::Lasts::until_end_of_run
                                                        : DriveJudge::Lasts::until_goal);
    footprint_.listen(setup, robot, [this](const Footprint& now) { judge_->on_footprint(now); });
    comfort_.offer(setup, footprint_);
    log_ = setup.log();
    map_frame_ = setup.frame("map");
    card_ = setup.output<bandwagon_msgs::msg::ScoreCard>("score_card");
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(),
        [this](const auto& message, const Tick& tick) {
          if (is_run_ && !judge_->running()) judge_->begin_run(tick.now);
          const TruthSample sample = to_truth(message);
          judge_->on_truth(sample);
          comfort_.on_truth(sample);
        },
        is_run_ ? Need::optional : Need::required);  // a recording may have none
    setup.input<nav_msgs::msg::Odometry>(
        "odometry/filtered", Qos::standard(50),
        [this](const auto& message, const Tick&) {
          judge_->on_pose(from_stamp(message.header().stamp()), from_pose(message.pose().pose()));
          comfort_.on_pose(message);
        },
        Need::optional);
    if (!is_run_) {
      setup.input<bandwagon_msgs::msg::NavigationStatus>(
          "navigation_status", Qos::standard(),
          [this](const auto& message, const Tick& tick) { on_status(message, tick); });
    }
    listen_to_map(
        setup, [this](const KnownMap& map, const Tick&) { judge_->recorder().set_map(map.grid); },
        Need::optional);
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "sim/map", Qos::latched(),
        [this](const auto& message, const Tick&) {
          OccupancyGrid map;
          if (read_grid(message, map).empty()) judge_->recorder().set_true_map(map);
        },
        Need::optional);
    setup.input<bandwagon_msgs::msg::Obstacles>(
        "sim/obstacles", Qos::latched(),
        [this](const auto& message, const Tick&) {
          judge_->recorder().set_shapes(to_obstacles(message, Pose2{}));
        },
        Need::optional);
    setup.every(Duration::seconds(1.0 / parameters_.kRate), "score_card", [this](const Tick& tick) {
      if (judge_->running()) publish(tick);
    });
    setup.every(Duration::milliseconds(100), "comfort",
                [this](const Tick&) { comfort_.tell(judge_->card().collisions); });
  }

  void activate(const Tick& tick) override { activated_ = tick.now; }

  void deactivate(const Tick& tick) override {
    if (!judge_->running()) return;
    if (parameters_.scored != Scored::drive) judge_->end_run(tick.now);
    publish(tick);
    if (is_run_ || (parameters_.scored == Scored::drives && !judge_->has_goal())) return draw();
    const bool is_late = parameters_.time_limit > 0.0 &&
                         (tick.now - activated_).to_seconds() >= parameters_.time_limit - kClockStep;
    draw(is_late ? "timeout" : "ended early");
  }

 private:
  void on_status(const bandwagon_msgs::msg::NavigationStatus& message, const Tick& tick) {
    if (!judge_->on_goal(to_goal_news(message), tick.now)) return;
    publish(tick);
    draw();
  }

  void publish(const Tick& tick) {
    card_.publish(to_message(judge_->card(), judge_->pose_errors(), make_header(map_frame_, tick.now)));
  }

  void draw(const std::string& unfinished = "") {
    if (svg_path_.empty()) return;
    try {
      write_file_atomically(svg_path_, svg_picture(judge_->recorder().recording(), judge_->card(),
                                                   {.title = parameters_.title, .unfinished = unfinished}));
    } catch (const std::exception& error) {
      log_.error("no picture of the run: {}", error.what());
    }
  }

  EvaluationParameters parameters_;
  std::filesystem::path svg_path_;
  std::optional<DriveJudge> judge_;
  CurrentFootprint footprint_;
  ComfortOutput comfort_;
  bool is_run_ = false;
  Time activated_;
  Logger log_;
  std::string map_frame_;
  Output<bandwagon_msgs::msg::ScoreCard> card_;
};

}  // namespace

BW_COMPONENT(EvaluationComponent, "evaluation")

}  // namespace bw
