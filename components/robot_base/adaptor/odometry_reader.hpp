// From counts to odometry, joint states and odom->base_link, and what is said of counts that were no motion
// or did not come. For the adaptor only.
#pragma once

#include <optional>

#include "components/messages/odometry_outputs.hpp"
#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "runtime/component.hpp"

namespace bw {

class OdometryReader {
 public:
  OdometryReader() = default;
  /// `silence`: so long without counts is worth telling.
  OdometryReader(Setup& setup, const Robot& robot, const OdometryOptions& options, Duration silence);

  void publish_mounts(Time now) { outputs_.publish_mounts(now); }
  /// The travel, when it is a sound one.
  std::optional<WheelTravel> read(Time now, const EncoderCounts& counts);
  WheelSpeeds measured() const { return to_wheel_speeds(odometry_->state().twist, robot_.wheel_separation); }

 private:
  void tell_fault(CountsStatus status, Time stamp);
  void tell_gap(CountsStatus status, double seconds);
  void publish();

  Robot robot_;
  std::optional<EncoderOdometry> odometry_;
  Duration silence_;
  std::optional<Time> fault_told_;
  int gaps_ = 0, unknown_gaps_ = 0;
  double gap_seconds_ = 0.0, gap_distance_ = 0.0;
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  OdometryOutputs outputs_;
  Output<sensor_msgs::msg::JointState> joints_;
};

}  // namespace bw
