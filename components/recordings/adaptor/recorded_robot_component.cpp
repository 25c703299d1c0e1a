// Plays a log on the component clock, so that the graph that drives a robot runs on it: odometry, inertial
// unit, fixes, ranges, scans and reference as the robot and the simulated world publish them.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tf2_msgs/msg/tf_message.hpp>

#include "components/localization/ekf/arc.hpp"
#include "components/localization/wheel_step.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/odometry.hpp"
#include "components/model/robot.hpp"
#include "components/recordings/adaptor/recording_messages.hpp"
#include "components/recordings/files/log_files.hpp"
#include "components/recordings/recorded_robot_options.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

constexpr Duration kStep = Duration::milliseconds(5);

RecordedDrive read_log(const std::string& format, const std::filesystem::path& folder) {
  if (format == "husky") return read_husky_log(folder);
  if (format == "mrclam") return read_mrclam_log(folder);
  if (format == "labyrinth") return read_labyrinth_log(folder);
  return read_laser_log(folder);
}

class RecordedRobotComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<RecordedRobotOptions>();
    robot_ = setup.shared<Robot>("robot");
    drive_ = read_log(options_.format, setup.file_parameter("folder"));
    if (options_.format == "mrclam") {
      add_synthetic_sensors(drive_, options_.synthetic,
                            {options_.datum_latitude, options_.datum_longitude, 0.0}, setup.seed());
    }
    held_out_.fixes = hold_out(drive_, options_.hold_out);
    if (drive_.wheel_separation == 0.0) drive_.wheel_separation = robot_.wheel_separation;
    take_events(in_time_order(drive_), events_);
    take_events(in_time_order(held_out_), held_out_events_);
    declare_outputs(setup);
    setup.every(kStep, "play", [this](const Tick& tick) { play(tick.now); });
    setup.log().info("{} entries of a {} log", events_.size(), options_.format);
  }

  void activate(const Tick& tick) override {
    start_ = tick.now;
    tf2_msgs::msg::TFMessage mounts;
    for (const auto& [frame, X_BS] : mounts_)
      mounts.transforms().push_back(to_transform(base_frame_, frame, tick.now, X_BS));
    tf_static_.publish(mounts);
  }

  void operator()(const OdometrySample* sample) {
    OdometryState state;
    state.time = when(sample->time);
    state.X_OB = sample->X_OB;
    state.twist = {sample->twist.v * options_.rate, sample->twist.omega * options_.rate};
    if (before_ != nullptr) grow_covariance(*sample, state);
    state.pose_covariance = pose_covariance_;
    before_ = sample;
    odom_.publish(to_odometry(state, odom_frame_, base_frame_));
    tf2_msgs::msg::TFMessage tf;
    tf.transforms().push_back(to_transform(odom_frame_, base_frame_, state.time, state.X_OB));
    tf_.publish(tf);
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
    sensor_msgs::msg::LaserScan message =
        to_message(*sample, drive_.scan_geometry, laser_frame_, when(sample->time));
    scan_.publish(message);
  }
  void operator()(const ReferencePose* sample) {
    Twist2 twist = reference_before_ != nullptr ? twist_between(*reference_before_, *sample) : Twist2{};
    reference_before_ = sample;
    twist = {twist.v * options_.rate, twist.omega * options_.rate};
    truth_.publish(to_message(*sample, twist, map_frame_, when(sample->time)));
  }

 private:
  void declare_outputs(Setup& setup) {
    map_frame_ = setup.frame("map");
    odom_frame_ = setup.frame("odom");
    base_frame_ = setup.frame("base_link");
    imu_frame_ = setup.frame(options_.imu_frame);
    gps_frame_ = setup.frame(options_.gps_frame);
    laser_frame_ = setup.frame(options_.laser_frame);
    for (const SensorMount& mount : robot_.sensors)
      mounts_.emplace_back(setup.frame(mount.frame), robot_.mount_of(mount.frame));
    odom_ = setup.output<nav_msgs::msg::Odometry>("odom");
    tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
    tf_static_ = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched());
    if (!drive_.imu.empty()) imu_ = setup.output<sensor_msgs::msg::Imu>("imu");
    if (!drive_.fixes.empty()) fix_ = setup.output<sensor_msgs::msg::NavSatFix>("gps/fix");
    if (!held_out_.fixes.empty())
      held_out_fix_ = setup.output<sensor_msgs::msg::NavSatFix>("gps/fix_held_out");
    if (!drive_.ranges.empty()) ranges_ = setup.output<bandwagon_msgs::msg::AnchorRange>("ranges");
    if (!drive_.scans.empty()) scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan");
    if (!drive_.truth.empty()) truth_ = setup.output<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth");
  }

  /// Those between start and end.
  void take_events(const std::vector<RecordedEvent>& all, std::vector<RecordedEvent>& taken) const {
    for (const RecordedEvent& event : all) {
      const double t = stamp(event).to_seconds();
      if (t >= options_.start && (options_.end == 0.0 || t <= options_.end)) taken.push_back(event);
    }
  }

  /// Moment of the component clock at which the log's `time` is played.
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
  }

  void grow_covariance(const OdometrySample& sample, OdometryState& state) {
    const localization::WheelStep step =
        localization::step_from_poses(state.time, sample.time - before_->time, before_->X_OB, sample.X_OB,
                                      drive_.wheel_separation, options_.variance_per_metre);
    const localization::ArcStep arc = localization::advance_arc(before_->X_OB, step.distance, step.turn);
    pose_covariance_ = arc.by_pose * pose_covariance_ * arc.by_pose.transpose() +
                       arc.by_step * step.covariance * arc.by_step.transpose();
    const double seconds = step.over.to_seconds() / options_.rate;
    state.twist_covariance = step.covariance / (seconds * seconds);
  }

  RecordedRobotOptions options_;
  Robot robot_;
  RecordedDrive drive_;
  RecordedDrive held_out_;  ///< only fixes
  std::vector<RecordedEvent> events_;
  std::vector<RecordedEvent> held_out_events_;
  std::size_t next_ = 0;
  std::size_t next_held_out_ = 0;
  Time start_;  ///< component time at which the log's start second is played
  const OdometrySample* before_ = nullptr;
  const ReferencePose* reference_before_ = nullptr;
  Eigen::Matrix3d pose_covariance_ = Eigen::Matrix3d::Zero();
  std::string map_frame_, odom_frame_, base_frame_, imu_frame_, gps_frame_, laser_frame_;
  std::vector<std::pair<std::string, Pose2>> mounts_;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<tf2_msgs::msg::TFMessage> tf_;
  Output<tf2_msgs::msg::TFMessage> tf_static_;
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
