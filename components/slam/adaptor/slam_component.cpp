#include "components/slam/adaptor/slam_component.hpp"

#include <utility>

#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "components/messages/laser.hpp"
#include "components/messages/obstacles.hpp"
#include "components/messages/placed.hpp"
#include "components/model/sweep_motion.hpp"
#include "components/slam/adaptor/graph_markers.hpp"
#include "components/slam/adaptor/health_text.hpp"
#include "components/slam/leave_out.hpp"

namespace bw::slam {
namespace {

constexpr std::size_t kMostWaiting = 20;    // scans, for odometry of their time
constexpr std::size_t kTilesPerScan = 500;  // of the map to be published: half a millisecond
constexpr double kOldestTracks = 0.5;       // [s] older ones do not say where people are

std::string seconds(Time time) { return fmt::format("{:.3f}", time.to_seconds()); }

}  // namespace

void SlamComponent::configure(Setup& setup) {
  parameters_ = setup.parameters<SlamParameters>();
  is_lockstep_ = setup.is_lockstep();
  setup.longest_callback(Duration::milliseconds(10'000));  // a graph that is read, a place that is searched
  const std::filesystem::path folder = setup.file_parameter("folder");
  folder_ = std::filesystem::absolute(folder.empty() ? std::filesystem::path(parameters_.folder) : folder);
  map_frame_ = setup.frame("map");
  odom_frame_ = setup.frame("odom");
  base_frame_ = setup.frame("base_link");
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  transforms_ = setup.transforms();
  mounts_ = SensorMounts(setup, transforms_);
  filtered_ = setup.output<nav_msgs::msg::Odometry>("odometry/filtered");
  tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
  pose_ = setup.output<geometry_msgs::msg::PoseWithCovarianceStamped>("pose");
  map_.configure(setup);
  graph_ =
      setup.output<visualization_msgs::msg::MarkerArray>("slam_toolbox/graph_visualization", Qos::latched());
  setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                       [this](const auto& m, const Tick& tick) { on_odometry(m, tick); });
  setup.input<sensor_msgs::msg::LaserScan>("scan", Qos::sensor(),
                                           [this](const auto& m, const Tick&) { on_scan(m); });
  tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(), Need::optional);
  setup.input<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "initialpose", Qos::standard(), [this](const auto& m, const Tick&) { on_initial_pose(m); },
      Need::optional);
  setup.every(Duration::seconds(parameters_.map_update_interval), "map", [this](const Tick&) {
    publish_map();
    publish_graph();
  });
  setup.every(Duration::milliseconds(50), "saving", [this](const Tick&) { advance_saves(); });
  setup.every(Duration::seconds(1.0), "health", [this](const Tick& tick) { report(tick.now); });
  offer_services(setup);
  offer_graph_services(setup);
  begin_map();
}

void SlamComponent::activate(const Tick&) {
  waiting_.clear();
  map_.activate();
}

void SlamComponent::deactivate(const Tick&) {
  finish_saves();
  map_.deactivate();
}

void SlamComponent::begin_map() {
  finish_saves();
  const MapStartPose& start = parameters_.map_start_pose;
  X_MW_ = {start.x, start.y, start.yaw};
  options_ = parameters_.algorithm;
  options_.holds_back = true;
  search_.reset();
  set_slam(std::make_unique<Slam>(options_));
  painter_ = std::make_unique<MapPainter>(options_.resolution, X_MW_);
  covariance_.setZero();
  map_.begin(options_.resolution);
  tiles_.clear();
  is_gathering_ = false;
  is_told_ = false;
  jumps_ = true;
  newest_.reset();
  looks_for_place_ = false;
  is_kidnapped_ = false;
  carried_.reset();
  watch_ = {};
  given_.reset();
  given_X_MO_.reset();
}

void SlamComponent::set_slam(std::unique_ptr<Slam> slam) {
  slam_ = std::move(slam);
  if (is_lockstep_) return;
  slam_->work_beside([this](std::function<void()> work) {
    const auto done = std::make_shared<std::atomic<bool>>(false);
    map_.add([work = std::move(work), done] {
      work();
      *done = true;
      done->notify_all();
    });
    return LoopClosing::Pending{.is_done = [done] { return done->load(); },
                                .wait = [done] { done->wait(false); }};
  });
}

void SlamComponent::on_odometry(const nav_msgs::msg::Odometry& message, const Tick&) {
  const Time time = from_stamp(message.header().stamp());
  const Pose2 X_OB = from_pose(message.pose().pose());
  if (!is_finite(X_OB)) return;
  if (!odometry_.add(time, X_OB))
    log_.warn("odometry went back in time to {}: the clock was set, or two programs publish odom",
              seconds(time));
  use_waiting_scans();
  if (!is_told_) return;
  const Pose2 X_MO = map_to_odom_.next(X_OB);
  tf2_msgs::msg::TFMessage tf;
  tf.transforms().push_back(to_transform(map_frame_, odom_frame_, time, X_MO));
  tf_.publish(tf);
  nav_msgs::msg::Odometry filtered;
  filtered.header(make_header(map_frame_, time));
  filtered.child_frame_id(base_frame_);
  filtered.pose().pose(to_pose(X_MO * X_OB));
  set_planar_covariance(filtered.pose().covariance(), covariance_);
  filtered.twist(message.twist());
  if (!is_kidnapped_) filtered_.publish(filtered);
}

void SlamComponent::on_scan(const sensor_msgs::msg::LaserScan& message) {
  if (paused_) return;
  if (waiting_.size() == kMostWaiting) {
    ++too_early_;
    waiting_.pop_front();
  }
  waiting_.push_back(message);
  use_waiting_scans();
}

void SlamComponent::use_waiting_scans() {
  while (!waiting_.empty()) {
    const sensor_msgs::msg::LaserScan& scan = waiting_.front();
    const LaserSweep sweep = to_sweep(scan, {});
    const Time last = sweep.time + Duration::seconds(std::abs(taken_after(sweep, 0.0)));
    if (!odometry_.covers(last) && !odometry_.began_after(sweep.time)) return;
    use(scan);
    waiting_.pop_front();
  }
}

void SlamComponent::use(const sensor_msgs::msg::LaserScan& message) {
  const Pose2 X_BL = mounts_.of(message.header().frame_id());
  LaserSweep sweep = to_sweep(message, X_BL);
  const std::string where =
      fmt::format("scan in frame '{}' of {}", message.header().frame_id(), seconds(sweep.time));
  if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) {
    log_.warn("{} is left out: {}", where, to_text(fault));
    return;
  }
  const std::optional<Pose2> X_OB = odometry_.at(sweep.time);
  if (!X_OB) {
    log_.warn(
        "{} is left out: odom has nothing at that time, the newest is of {}. Do both programs use one clock?",
        where, odometry_.newest() ? seconds(*odometry_.newest()) : "never");
    return;
  }
  const Pose2 X_BO = inverse(*X_OB);
  const std::vector<Pose2> poses = beam_poses(sweep, X_BL, [&](Time time) -> std::optional<Pose2> {
    const std::optional<Pose2> X = odometry_.at(time);
    return X ? std::optional<Pose2>(X_BO * *X) : std::nullopt;
  });
  sweep.beam_poses = poses;
  std::vector<Disc> people = people_at(sweep.time);
  for (Disc& person : people) person.center = X_BO * person.center;
  const std::vector<float> ranges = without_people(sweep, people);
  sweep.ranges = ranges;
  newest_ = scan_of(sweep, options_);
  newest_X_OB_ = *X_OB;
  gather_map();
  if (looks_for_place_ && !find_place(*newest_, *X_OB)) return;
  take_in(*newest_, *X_OB);
}

void SlamComponent::take_in(const Scan& scan, const Pose2& X_OB) {
  const bool is_first = jumps_;
  const Tracked tracked = slam_->add(scan, X_OB);
  for (int i = 0; i < kPiecesPerScan && slam_->advance(); ++i) {
  }
  painter_->update(*slam_, kDrawnPerScan);
  map_time_ = scan.time;
  inliers_ = tracked.match.inliers;
  const Pose2 X_MB = X_MW_ * slam_->pose(tracked.placement);
  watch_.add(tracked, scan.points.size(), X_MB, scan.time);
  if (watch_.is_kidnapped()) {
    log_.warn("the robot is not where it was: looks for its place in the map, and draws nothing");
    is_kidnapped_ = true;
    carried_ = scan.time;
    looks_for_place_ = true;
    slam_->finish();
    return;
  }
  if (is_first) {
    map_to_odom_.jump(X_MB * inverse(X_OB));
    is_told_ = true;
    jumps_ = false;
  } else {
    map_to_odom_.set(X_MB * inverse(X_OB));
  }
  covariance_ = slam_->covariance(tracked);
  geometry_msgs::msg::PoseWithCovarianceStamped pose;
  pose.header(make_header(map_frame_, scan.time));
  pose.pose().pose(to_pose(X_MB));
  set_planar_covariance(pose.pose().covariance(), covariance_);
  pose_.publish(pose);
  if (is_first) publish_map();  // whoever plans need not wait for the next interval
}

std::vector<Disc> SlamComponent::people_at(Time time) const {
  const auto from = placed(tracks_, *transforms_, odom_frame_, time, kOldestTracks);
  return from ? to_discs(*tracks_, from->age, from->X_TF) : std::vector<Disc>{};
}

void SlamComponent::publish_map() {
  if (slam_->nodes().empty()) return;
  if (!is_gathering_) to_gather_ = painter_->changed_tiles();
  is_gathering_ = true;
  gather_map();
}

/// Tiles of the map in pieces between scans: all of a large one change at once when a loop is closed.
void SlamComponent::gather_map() {
  if (!is_gathering_) return;
  const std::size_t now = std::min(to_gather_, kTilesPerScan);
  painter_->gather(now, tiles_);
  to_gather_ -= now;
  if (to_gather_ == 0) is_gathering_ = !map_.send(tiles_, map_time_);
}

void SlamComponent::publish_graph() {
  const std::array<std::int64_t, 3> now{static_cast<std::int64_t>(slam_->submaps()),
                                        slam_->loop_counts().accepted, slam_->revision()};
  if (std::exchange(told_graph_, now) != now)
    graph_.publish(to_markers(*slam_, X_MW_, map_frame_, map_time_));
}

void SlamComponent::report(Time now) {
  using Level = DiagnosticReporter::Level;
  if (too_early_ > told_too_early_) {
    log_.warn(
        "{} scans were dropped since odom does not reach their time: its newest is of {}, the scan waiting of {}",
        too_early_ - told_too_early_, odometry_.newest() ? seconds(*odometry_.newest()) : "never",
        waiting_.empty() ? "-" : seconds(to_sweep(waiting_.front(), {}).time));
    told_too_early_ = too_early_;
  }
  const LoopCounts& loops = slam_->loop_counts();
  diagnostics_->set_value("scans", std::to_string(slam_->counts().scans));
  diagnostics_->set_value("scans in the map", std::to_string(slam_->nodes().size()));
  diagnostics_->set_value("submaps", std::to_string(slam_->submaps()));
  diagnostics_->set_value("loop closures", std::to_string(loops.accepted));
  diagnostics_->set_value("scans beyond the largest map", std::to_string(painter_->left_out()));
  diagnostics_->set_value("beams that meet the map", fmt::format("{:.2f}", inliers_));
  diagnostics_->set_value("initialpose", initial_pose_remark_);
  const SlamHealth health = watch_.health(now);
  HealthState state = health.state;
  std::string why = to_text(health);
  if (paused_) {
    state = HealthState::ok;
    why = "paused: scans are not used";
  } else if (looks_for_place_) {
    state = is_kidnapped_ ? HealthState::lost : HealthState::init;
    why = std::string(is_kidnapped_ ? "kidnapped, nothing is drawn; " : "") +
          "looks for its place in the map: " + doubt();
  } else if (state == HealthState::ok && carried_ && (now - *carried_).to_seconds() < kToldFor) {
    state = HealthState::degraded;
    why = "was carried away, and found its place in the map again";
  } else if (state == HealthState::ok && painter_->left_out() > 0) {
    state = HealthState::degraded;
    why = fmt::format("{} scans are not on the map, which may have {:.0f} cells", painter_->left_out(),
                      kMostCells);
  }
  const Level level = state == HealthState::lost ? Level::error
                      : state == HealthState::ok ? Level::ok
                                                 : Level::warn;
  diagnostics_->report(level, fmt::format("{}: {}", to_string(state), why));
}

BW_COMPONENT(SlamComponent, "slam")

}  // namespace bw::slam
