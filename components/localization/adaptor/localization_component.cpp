#include "components/localization/adaptor/localization_component.hpp"

#include "components/localization/wheel_step.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/laser.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kMostParticlesShown = 1000;

}  // namespace

void LocalizationComponent::configure(Setup& setup) {
  parameters_ = setup.parameters<LocalizationParameters>();
  robot_ = setup.shared<Robot>("robot");
  filter_ = make_localizer(parameters_.algorithm, parameters_.filters, setup.seed());
  const DatumParameters& datum = parameters_.datum;
  if (datum.enabled) plane_ = LocalPlane::around({datum.latitude, datum.longitude, datum.altitude});
  map_frame_ = setup.frame("map");
  odom_frame_ = setup.frame("odom");
  base_frame_ = setup.frame("base_link");
  mounts_ = {setup, setup.transforms()};
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  diagnostics_->set_value("filter", parameters_.algorithm);
  filtered_ = setup.output<nav_msgs::msg::Odometry>("odometry/filtered");
  tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
  pose_ = setup.output<geometry_msgs::msg::PoseWithCovarianceStamped>("amcl_pose", Qos::latched());
  cloud_ = setup.output<nav2_msgs::msg::ParticleCloud>("particle_cloud");
  particle_poses_ = setup.output<geometry_msgs::msg::PoseArray>("particle_poses");
  listen(setup);
  setup.every(Duration::seconds(1.0 / parameters_.pose_rate), "health",
              [this](const Tick& tick) { report_health(tick); });
}

void LocalizationComponent::listen(Setup& setup) {
  using geometry_msgs::msg::PoseWithCovarianceStamped;
  const SensorParameters& sensors = parameters_.sensors;
  setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                       [this](const auto& m, const Tick& tick) { on_odometry(m, tick); });
  if (sensors.gyro || sensors.compass) {
    setup.input<sensor_msgs::msg::Imu>(
        "imu", Qos::sensor(), [this](const auto& m, const Tick& tick) { on_imu(m, tick); }, Need::optional);
  }
  if (sensors.gps) {
    setup.input<sensor_msgs::msg::NavSatFix>(
        "gps/fix", Qos::sensor(), [this](const auto& m, const Tick& tick) { on_fix(m, tick); },
        Need::optional);
  }
  if (sensors.poses) {
    setup.input<PoseWithCovarianceStamped>(
        "pose", Qos::standard(), [this](const auto& m, const Tick& tick) { on_pose(m, tick); },
        Need::optional);
  }
  if (sensors.ranges) {
    setup.input<bandwagon_msgs::msg::AnchorRange>(
        "ranges", Qos::sensor(),
        [this](const auto& m, const Tick& tick) {
          if (m.header().frame_id() == map_frame_) filter_->add(to_range(m), tick.now);
        },
        Need::optional);
  }
  if (sensors.laser && parameters_.algorithm == "particle_filter") {
    setup.input<sensor_msgs::msg::LaserScan>(
        "scan", Qos::sensor(), [this](const auto& m, const Tick& tick) { on_scan(m, tick); }, Need::optional);
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [this](const auto& m, const Tick& tick) { on_map(m, tick); }, Need::optional);
  }
  setup.input<PoseWithCovarianceStamped>(
      "initialpose", Qos::standard(), [this](const auto& m, const Tick& tick) { on_initial_pose(m, tick); },
      Need::optional);
  setup.input<std_msgs::msg::Empty>(
      "reinitialize_global_localization", Qos::standard(),
      [this](const auto&, const Tick& tick) { search(tick.now); }, Need::optional);
}

void LocalizationComponent::activate(const Tick& tick) {
  const InitialPoseParameters& pose = parameters_.initial_pose;
  const Eigen::Vector3d sigma(pose.position_sigma, pose.position_sigma, pose.yaw_sigma);
  if (parameters_.set_initial_pose)
    start_at({pose.x, pose.y, pose.yaw}, sigma.cwiseAbs2().asDiagonal(), tick.now);
}

void LocalizationComponent::on_odometry(const nav_msgs::msg::Odometry& message, const Tick& tick) {
  const Time time = from_stamp(message.header().stamp());
  const Pose2 X_OB = from_pose(message.pose().pose());
  if (!is_finite(X_OB)) return;
  const std::optional<Pose2> before = X_OB_;
  const Duration over = time - odometry_time_;
  X_OB_ = X_OB;
  odometry_time_ = time;
  if (!before || over.nanoseconds <= 0) return;  // the first one, or a clock that went back
  WheelStep step =
      step_from_poses(time, over, *before, X_OB, robot_.wheel_separation, parameters_.sensors.wheel_noise);
  step.source = kWheels;
  filter_->add(step, tick.now);
  publish_pose(X_OB, time);
}

void LocalizationComponent::on_imu(const sensor_msgs::msg::Imu& message, const Tick& tick) {
  const SensorParameters& sensors = parameters_.sensors;
  if (sensors.gyro) {
    if (const auto gyro = to_gyro(message, sensors.gyro_noise)) filter_->add(*gyro, tick.now);
  }
  if (!sensors.compass) return;
  const Pose2 X_BS = mounts_.of(message.header().frame_id());
  if (const auto heading = to_heading(message, X_BS, sensors.compass_noise)) filter_->add(*heading, tick.now);
}

void LocalizationComponent::on_fix(const sensor_msgs::msg::NavSatFix& message, const Tick& tick) {
  const std::optional<Geodetic> place = to_geodetic(message, plane_ ? plane_->datum().altitude : 0.0);
  if (!place) return;
  if (!plane_) {
    plane_ = LocalPlane::around(*place);
    log_.info("the origin of map is the first fix: {:.7f} N, {:.7f} E", place->latitude, place->longitude);
  }
  const Pose2 X_BS = mounts_.of(message.header().frame_id());
  const PositionFix fix = to_fix(message, *place, *plane_, X_BS, parameters_.sensors.gps_noise);
  filter_->add(fix, tick.now);
  if (!parameters_.sensors.course) return;
  if (const auto course = course_.add(fix)) filter_->add(*course, tick.now);
}

void LocalizationComponent::on_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message,
                                    const Tick& tick) {
  if (message.header().frame_id() == map_frame_) filter_->add(to_measurement(message), tick.now);
}

void LocalizationComponent::on_scan(const sensor_msgs::msg::LaserScan& message, const Tick& tick) {
  filter_->add(LaserReading{to_sweep(message, mounts_.of(message.header().frame_id())), kLaser}, tick.now);
}

void LocalizationComponent::on_map(const nav_msgs::msg::OccupancyGrid& message, const Tick& tick) {
  OccupancyGrid grid;
  if (const std::string fault = read_grid(message, grid); !fault.empty()) {
    log_.error("the map is of no use: {}", fault);
    return;
  }
  filter_->set_map(grid);
  if (parameters_.start_anywhere && !filter_->initialised()) search(tick.now);
}

void LocalizationComponent::on_initial_pose(const geometry_msgs::msg::PoseWithCovarianceStamped& message,
                                            const Tick& tick) {
  const std::string& frame = message.header().frame_id();
  if (frame != map_frame_) {
    log_.error("initialpose is in frame '{}', not in '{}': ignored", frame, map_frame_);
    return;
  }
  Eigen::Matrix3d covariance = planar_covariance(message.pose().covariance());
  const InitialPoseParameters& pose = parameters_.initial_pose;
  const Eigen::Vector3d sigma(pose.position_sigma, pose.position_sigma, pose.yaw_sigma);
  if (covariance.isZero()) covariance = sigma.cwiseAbs2().asDiagonal();
  start_at(from_pose(message.pose().pose()), covariance, X_OB_ ? odometry_time_ : tick.now);
}

void LocalizationComponent::start_at(const Pose2& X_MB, const Eigen::Matrix3d& covariance, Time time) {
  if (filter_->start_at(X_MB, covariance, time)) {
    log_.info("pose set to ({:.2f}, {:.2f}, {:.2f})", X_MB.x, X_MB.y, X_MB.theta);
  } else {
    log_.error("a pose to start at must be finite, its covariance positive definite: ignored");
  }
}

void LocalizationComponent::search(Time time) {
  if (filter_->start_anywhere(time)) {
    log_.info("searching the whole map");
  } else {
    log_.error("{} cannot search the map: give it a pose", parameters_.algorithm);
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
  const Estimate estimate = filter_->estimate_at(odometry_time_);
  report(health, estimate, *diagnostics_);
  if (health.state != state_) {
    if (health.state > HealthState::ok) {
      log_.warn("{}", to_text(health));
    } else {
      log_.info("{}", to_text(health));
    }
  }
  state_ = health.state;
  if (!filter_->initialised()) return;
  pose_.publish(to_pose_message(estimate, map_frame_));
  const ParticleSet* particles = filter_->particles();
  if (particles == nullptr) return;
  const auto header = make_header(map_frame_, estimate.time);
  if (cloud_.has_readers()) cloud_.publish(to_cloud(*particles, header, kMostParticlesShown));
  if (particle_poses_.has_readers())
    particle_poses_.publish(to_poses(*particles, header, kMostParticlesShown));
}

BW_COMPONENT(LocalizationComponent, "localization")

}  // namespace bw::localization
