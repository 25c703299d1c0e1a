#include "components/localization/adaptor/localization_component.hpp"

#include "components/messages/geometry.hpp"
#include "components/messages/map_input.hpp"
#include "components/model/robot.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kMaxParticlesShown = 1000;

/// Of a pose that comes without any.
Eigen::Matrix3d usual_covariance(const InitialPoseParameters& pose) {
  return Eigen::Vector3d(pose.kPositionSigma, pose.kPositionSigma, pose.kYawSigma).cwiseAbs2().asDiagonal();
}

}  // namespace

void LocalizationComponent::configure(Setup& setup) {
  // The filters are fixed: what they know was learnt with their parameters.
  parameters_ = setup.parameters<LocalizationParameters>(
      [this](const LocalizationParameters& changed, const Tick&) {
        parameters_ = changed;
        inputs_.set_noise(changed.sensors);
        wheels_.set_noise(changed.sensors.wheel_noise);
      },
      {"algorithm", "set_initial_pose", "start_anywhere", "sensors.gyro", "sensors.compass", "sensors.gps",
       "sensors.course", "sensors.laser", "sensors.ranges", "sensors.poses", "datum", "ekf",
       "particle_filter"});
  if (parameters_.algorithm == Algorithm::particle_filter && parameters_.sensors.laser)
    setup.longest_callback(Duration::milliseconds(5'000));  // the whole map is searched
  inputs_.configure(setup, parameters_);
  const Robot& robot = setup.shared<Robot>("robot");
  wheels_ = {inputs_.wheels(), robot.wheel_separation, parameters_.sensors.wheel_noise,
             robot.metres_per_tick(robot.wheel_radius)};
  keepsake_ = setup.keepsake("pose");
  left_ = kept_pose(keepsake_.left());
  filter_ = make_localizer(parameters_.algorithm, parameters_.filters, setup.seed(), inputs_.names().count());
  map_frame_ = setup.frame("map");
  odom_frame_ = setup.frame("odom");
  base_frame_ = setup.frame("base_link");
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  diagnostics_->set_value("filter", std::string(text_of(parameters_.algorithm)));
  filtered_ = setup.output<nav_msgs::msg::Odometry>("odometry/filtered");
  tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
  pose_ = setup.output<geometry_msgs::msg::PoseWithCovarianceStamped>("amcl_pose", Qos::latched());
  cloud_ = setup.output<nav2_msgs::msg::ParticleCloud>("particle_cloud");
  particle_poses_ = setup.output<geometry_msgs::msg::PoseArray>("particle_poses");
  listen(setup);
  setup.every(Duration::seconds(1.0 / parameters_.kPoseRate), "health",
              [this](const Tick& tick) { report_health(tick); });
}

void LocalizationComponent::listen(Setup& setup) {
  using geometry_msgs::msg::PoseWithCovarianceStamped;
  setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                       [this](const auto& m, const Tick& tick) { on_odometry(m, tick); });
  inputs_.listen(setup, *filter_);
  if (parameters_.sensors.laser && parameters_.algorithm == Algorithm::particle_filter) {
    listen_to_map(
        setup, [this](const KnownMap& map, const Tick& tick) { on_map(map.grid, tick); }, Need::optional);
  }
  setup.input<PoseWithCovarianceStamped>(
      "initialpose", Qos::standard(), [this](const auto& m, const Tick& tick) { on_initial_pose(m, tick); },
      Need::optional);
  offer_services(setup);
}

void LocalizationComponent::activate(const Tick& tick) {
  const InitialPoseParameters& pose = parameters_.initial_pose;
  // Active again after a pause it knows better where it is.
  if (parameters_.set_initial_pose && !filter_->initialised() && !left_)
    start_at({pose.x, pose.y, pose.yaw}, usual_covariance(pose), tick.now);
}

void LocalizationComponent::on_odometry(const nav_msgs::msg::Odometry& message, const Tick& tick) {
  const Time time = from_stamp(message.header().stamp());
  const Pose2 X_OB = from_pose(message.pose().pose());
  if (!is_finite(X_OB)) return;
  inputs_.set_twist(from_twist(message.twist().twist()));
  if (left_ && !filter_->initialised()) take_up(X_OB, time);
  const double heading_variance = planar_covariance(message.pose().covariance())(2, 2);
  const std::optional<WheelStep> step = wheels_.add(time, X_OB, heading_variance);
  if (!step) return;
  filter_->add(*step, tick.now);
  publish_pose(X_OB, time);
}

void LocalizationComponent::on_map(const OccupancyGrid& map, const Tick& tick) {
  filter_->set_map(map);
  if (parameters_.start_anywhere && !filter_->initialised() && !left_) search(tick.now);
}

void LocalizationComponent::on_initial_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message,
                                            const Tick& tick) {
  const std::string& frame = message.header().frame_id();
  if (frame != map_frame_) {
    log_.error("initialpose is in frame '{}', not in '{}': ignored", frame, map_frame_);
    return;
  }
  if (const std::string fault = fault_of(message.pose().pose()); !fault.empty()) {
    log_.error("initialpose is no pose: {}: ignored", fault);
    return;
  }
  Eigen::Matrix3d covariance = planar_covariance(message.pose().covariance());
  if (covariance.isZero()) covariance = usual_covariance(parameters_.initial_pose);
  start_at(from_pose(normalised(message.pose().pose())), covariance,
           wheels_.X_OB() ? wheels_.time() : tick.now);
}

void LocalizationComponent::start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) {
  if (filter_->start_at(X_MB, covariance, time)) {
    log_.info("pose set to ({:.2f}, {:.2f}, {:.2f})", X_MB.x, X_MB.y, X_MB.theta);
  } else {
    log_.error("a pose to start at must be finite, its covariance positive definite: ignored");
  }
}

void LocalizationComponent::take_up(const Pose2& X_OB, Time time) {
  const std::optional<KeptPose> now = carried_on(*left_, X_OB, time);
  left_.reset();
  if (now) return start_at(now->X_MB, now->covariance, time);
  log_.warn(
      "the odometry is not that of the process before this one: where the robot is has to be found anew");
  if (parameters_.start_anywhere) search(time);
}

void LocalizationComponent::keep(const Estimate& estimate) const {
  if (!wheels_.X_OB()) return;
  keepsake_.keep(to_text({.time = estimate.time,
                          .X_OB = *wheels_.X_OB(),
                          .X_MB = estimate.X_MB,
                          .covariance = estimate.covariance}));
}

void LocalizationComponent::search(Time time) {
  if (filter_->start_anywhere(time)) {
    log_.info("searching the whole map");
  } else {
    log_.error("{} cannot search the map: give it a pose", text_of(parameters_.algorithm));
  }
}

void LocalizationComponent::publish_pose(const Pose2& X_OB, Time time) {
  if (!filter_->initialised()) return;
  const Estimate estimate = filter_->estimate_at(time);
  tf2_msgs::msg::TFMessage tf;
  const Time dated = time + Duration::seconds(parameters_.transform_tolerance);
  tf.transforms().push_back(to_transform(map_frame_, odom_frame_, dated, estimate.X_MB * inverse(X_OB)));
  tf_.publish(tf);
  if (state_ == HealthState::lost && !parameters_.publish_when_lost) return;
  filtered_.publish(to_odometry(estimate, map_frame_, base_frame_));
}

void LocalizationComponent::report_health(const Tick& tick) {
  const Health health = filter_->health(tick.now);
  const Estimate estimate = filter_->estimate_at(wheels_.time());
  report(health, estimate, inputs_.names(), *diagnostics_);
  if (health.state != state_) {
    if (health.state > HealthState::ok) {
      log_.warn("{}", to_text(health, inputs_.names()));
    } else {
      log_.info("{}", to_text(health, inputs_.names()));
    }
  }
  state_ = health.state;
  if (!filter_->initialised()) return;
  if (state_ != HealthState::lost) keep(estimate);
  if (state_ != HealthState::lost || parameters_.publish_when_lost)
    pose_.publish(to_pose_message(estimate, map_frame_));
  const ParticleSet* particles = filter_->particles();
  if (particles == nullptr) return;
  const auto header = make_header(map_frame_, estimate.time);
  if (cloud_.has_readers()) cloud_.publish(to_cloud(*particles, header, kMaxParticlesShown));
  if (particle_poses_.has_readers())
    particle_poses_.publish(to_poses(*particles, header, kMaxParticlesShown));
}

BW_COMPONENT(LocalizationComponent, "localization")

}  // namespace bw::localization
