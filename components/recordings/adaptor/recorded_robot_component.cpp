// Plays a bag on the component clock, so that the graph that drives a robot runs on it: odometry, inertial
// unit, fixes, ranges, scans and reference as the robot and the simulated world publish them.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/messages/odometry_outputs.hpp"
#include "components/recordings/adaptor/recording_messages.hpp"
#include "components/recordings/files/drive_of_bag.hpp"
#include "components/recordings/played_odometry.hpp"
#include "components/recordings/recorded_robot_options.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

constexpr Duration kStep = Duration::milliseconds(5);
constexpr Duration kAfterTheEnd = Duration::milliseconds(1000);

class RecordedRobotComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<RecordedRobotOptions>();
    const auto robot = setup.shared<Robot>("robot");
    read_bag(setup, robot);
    if (options_.make_sensors) {
      add_synthetic_sensors(drive_, options_.synthetic,
                            {options_.kDatumLatitude, options_.kDatumLongitude, 0.0}, setup.seed());
    }
    held_out_.fixes = hold_out(drive_, options_.hold_out);
    events_ = events_between(drive_, options_.start, options_.end);
    held_out_events_ = events_between(held_out_, options_.start, options_.end);
    odometry_.emplace(drive_, options_.variance_per_metre, options_.rate);
    declare_outputs(setup, robot);
    if (options_.end_run) finish_run_ = setup.finish_run();
    setup.every(kStep, "play", [this](const Tick& tick) { play(tick.now); });
  }

  void activate(const Tick& tick) override {
    start_ = tick.now;
    outputs_.publish_mounts(tick.now, to_message(drive_.mounts, frame_, tick.now));
  }

  void operator()(const OdometrySample* sample) {
    const OdometryState state = odometry_->next(*sample, when(sample->time));
    outputs_.publish_odometry(state);
    outputs_.publish_transform(state);
  }
  void operator()(const ImuSample* sample) {
    imu_.publish(to_message(*sample, imu_frame_, when(sample->time), options_.rate));
  }
  void operator()(const FixSample* sample) {
    fix_.publish(to_message(*sample, gps_frame_, when(sample->time)));
  }
  void operator()(const RangeSample* sample) {
    ranges_.publish(to_message(*sample, map_frame_, when(sample->time)));
  }
  void operator()(const ScanSample* sample) {
    scan_.publish(to_message(*sample, frame_(sample->frame), when(sample->time)));
  }
  void operator()(const ReferencePose* sample) {
    // On the way to the next one, so that who carries the truth forward meets it; the last keeps that before.
    if (sample != &drive_.truth.back()) to_next_reference_ = twist_between(*sample, *(sample + 1));
    const Twist2 twist{to_next_reference_.v * options_.rate, to_next_reference_.omega * options_.rate};
    truth_.publish(to_message(*sample, twist, map_frame_, when(sample->time)));
  }

 private:
  void read_bag(Setup& setup, const Robot& robot) {
    const std::filesystem::path path = setup.file_parameter("bag");
    BagDrive read = drive_of_bag(*bag::open_bag(path), options_.topics, path.string(),
                                 {.separation = robot.wheel_separation, .radius = robot.wheel_radius});
    drive_ = std::move(read.drive);
    setup.log().info("plays {} ({})", read.log.name, path.string());
    for (const std::string& left_out : read.left_out) setup.log().warn("{}", left_out);
    drop_what_others_tell(robot, drive_.mounts);
  }

  void declare_outputs(Setup& setup, const Robot& robot) {
    frame_ = [prefixed = setup.frame("")](const std::string& frame) { return prefixed + frame; };
    map_frame_ = setup.frame("map");
    imu_frame_ = setup.frame(drive_.imu_frame);
    gps_frame_ = setup.frame(drive_.gps_frame);
    outputs_ = {setup, robot};
    if (!drive_.imu.empty()) imu_ = setup.output<sensor_msgs::msg::Imu>("imu");
    if (!drive_.fixes.empty()) fix_ = setup.output<sensor_msgs::msg::NavSatFix>("gps/fix");
    if (!held_out_.fixes.empty())
      held_out_fix_ = setup.output<sensor_msgs::msg::NavSatFix>("gps/fix_held_out");
    if (!drive_.ranges.empty()) ranges_ = setup.output<bandwagon_msgs::msg::AnchorRange>("ranges");
    if (!drive_.scans.empty()) scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan");
    if (!drive_.truth.empty()) truth_ = setup.output<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth");
  }

  /// Moment of the component clock at which the bag's `time` is played.
  Time when(Time time) const {
    return start_ + Duration::seconds((time.to_seconds() - options_.start) / options_.rate);
  }

  void play(Time now) {
    for (; next_ < events_.size() && when(stamp(events_[next_])) <= now; ++next_)
      std::visit(*this, events_[next_]);
    for (; next_held_out_ < held_out_events_.size(); ++next_held_out_) {
      const FixSample& fix = *std::get<const FixSample*>(held_out_events_[next_held_out_]);
      if (when(fix.time) > now) return;
      held_out_fix_.publish(to_message(fix, gps_frame_, when(fix.time)));
    }
    if (next_ == events_.size()) end_run(now);
  }

  /// When the others have had time for the last entry.
  void end_run(Time now) {
    if (!last_played_) last_played_ = now;
    if (finish_run_ && now - *last_played_ >= kAfterTheEnd)
      std::exchange(finish_run_, nullptr)(true, "the bag is over");
  }

  RecordedRobotOptions options_;
  RecordedDrive drive_;
  RecordedDrive held_out_;  ///< only fixes
  std::optional<PlayedOdometry> odometry_;
  std::vector<RecordedEvent> events_;
  std::vector<RecordedEvent> held_out_events_;
  std::size_t next_ = 0;
  std::size_t next_held_out_ = 0;
  std::optional<Time> last_played_;
  std::function<void(bool, const std::string&)> finish_run_;
  Time start_;  ///< component time at which the bag's start second is played
  Twist2 to_next_reference_;
  std::string map_frame_, imu_frame_, gps_frame_;
  Renamed frame_;
  OdometryOutputs outputs_;
  Output<sensor_msgs::msg::Imu> imu_;
  Output<sensor_msgs::msg::NavSatFix> fix_;
  Output<sensor_msgs::msg::NavSatFix> held_out_fix_;
  Output<bandwagon_msgs::msg::AnchorRange> ranges_;
  Output<sensor_msgs::msg::LaserScan> scan_;
  Output<bandwagon_msgs::msg::GroundTruth> truth_;
};

}  // namespace

BW_COMPONENT(RecordedRobotComponent, "recorded_robot")

}  // namespace bw
