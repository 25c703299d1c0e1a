#include "components/people/adaptor/people_component.hpp"

#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/laser.hpp"
#include "components/messages/obstacles.hpp"
#include "components/messages/placed.hpp"
#include "components/model/sweep_motion.hpp"
#include "components/people/adaptor/prediction_weights.hpp"
#include "components/people/sweep_timing.hpp"

namespace bw::people {
namespace {

constexpr Duration kLate = Duration::milliseconds(1000);  // more is a clock that went back
const Duration kMarkerLifetime = Duration::milliseconds(250);

}  // namespace

void PeopleComponent::configure(Setup& setup) {
  const auto parameters = setup.parameters<PeopleParameters>(
      [this](const PeopleParameters& changed, const Tick&) {
        lasers_.set_options(changed.detector);
        others_.set_options(changed.others);
        tracker_->set_options(changed.tracker);
        predictor_->set_options(changed.prediction);
        obstacles_timeout_ = changed.obstacles_timeout;
      },
      {"scan_topics", "people_topics", "prediction.model", "prediction.weights"});
  tracker_ = std::make_unique<Tracker>(parameters.tracker);
  predictor_ = std::make_unique<Predictor>(parameters.prediction, head_of(setup, parameters.prediction));
  obstacles_timeout_ = parameters.obstacles_timeout;
  odom_frame_ = setup.frame("odom");
  base_frame_ = setup.frame("base_link");
  transforms_ = setup.transforms();
  mounts_ = {setup, transforms_};
  log_ = setup.log();
  diagnostics_ = &setup.diagnostics();
  tracks_ = setup.output<bandwagon_msgs::msg::Tracks>("tracks");
  people_ = setup.output<people_msgs::msg::People>("people");
  people_markers_ = setup.output<visualization_msgs::msg::MarkerArray>("people_markers");
  leg_markers_ = setup.output<visualization_msgs::msg::MarkerArray>("leg_detections");
  const auto look_now = [this](const Tick& tick) {
    now_ = tick.now;
    look();
  };
  lasers_.listen(setup, parameters.scan_topics, parameters.detector, look_now);
  setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                       [this](const auto& message, const Tick& tick) {
                                         now_ = tick.now;
                                         on_odometry(message);
                                       });
  map_ = listen_to_map(setup, {}, Need::optional);
  if (parameters.prediction.model == PredictionModel::social_force) {
    obstacles_ = setup.latest<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::standard(), Need::optional);
  }
  others_.listen(setup, parameters.others, look_now);
  setup.every(Duration::milliseconds(500), "health", [this](const Tick& tick) { report_health(tick); });
}

void PeopleComponent::on_odometry(const nav_msgs::msg::Odometry& message) {
  const Pose2 X_OB = from_pose(message.pose().pose());
  if (!is_finite(X_OB)) return;
  odometry_.set(odom_frame_, base_frame_, from_stamp(message.header().stamp()), spatial(X_OB), false);
  look();
}

void PeopleComponent::look() {
  lasers_.order().hand_over(now_, [this](std::size_t laser, const sensor_msgs::msg::LaserScan& scan) {
    const auto X_OB = odometry_.lookup_planar(odom_frame_, base_frame_, time_of(scan));
    if (X_OB) look_at(laser, scan, *X_OB);
    return X_OB.has_value();
  });
  hear();
}

void PeopleComponent::look_at(std::size_t laser, const sensor_msgs::msg::LaserScan& scan, const Pose2& X_OB) {
  const Pose2 X_BL = mounts_.of(scan.header().frame_id());
  LaserSweep sweep = to_sweep(scan, X_OB * X_BL);
  const std::vector<Pose2> poses = beam_poses(
      sweep, X_BL, [this](Time time) { return odometry_.lookup_planar(odom_frame_, base_frame_, time); });
  sweep.beam_poses = poses;
  if (const SweepFault fault = fault_for_people(sweep); fault != SweepFault::none)
    return lasers_.refuse(laser, to_text(fault));
  if (lasers_.count() > 1 && sweep.time < tracked_at_ && tracked_at_ - sweep.time < kLate)
    return lasers_.refuse(laser, "it came after a later one of another laser");
  Surroundings surroundings{.map = &map_->grid};
  if (!map_->frame.empty()) surroundings.X_MO = transforms_->lookup_planar(map_->frame, odom_frame_);
  const std::vector<Vector2> keep_out = tracker_->keep_out();
  surroundings.people = keep_out;
  DetectionSet detections = lasers_.detect(laser, sweep, surroundings, now_);
  detections.source = static_cast<int>(laser);
  move_to_one_time(detections, tracker_->people(), tracked_at_);
  tracked_at_ = detections.time;
  const std::vector<TrackedPerson>& people = tracker_->update(detections);
  if (!lasers_.order().has_another_of(detections.time)) publish(people, detections.time);
  if (leg_markers_.has_readers())
    leg_markers_.publish(to_markers(detections, kMarkerLifetime, make_header(odom_frame_, detections.time)));
}

/// What others tell waits for the lasers' sweep of its time or after, if any laser sweeps; else it goes out
/// by itself.
void PeopleComponent::hear() {
  const bool is_alone = lasers_.all_silent(now_);
  const Time latest = now_ + Duration::seconds(1.0);
  for (const HeardSet& heard : others_.take(is_alone ? latest : tracked_at_, now_)) {
    const std::vector<TrackedPerson>& people = tracker_->hear(heard);
    if (!is_alone || heard.time < tracked_at_) continue;
    tracked_at_ = heard.time;
    publish(people, heard.time);
  }
}

void PeopleComponent::publish(std::vector<TrackedPerson> people, Time stamp) {
  const std_msgs::msg::Header header = make_header(odom_frame_, stamp);
  predictor_->predict(people, walls_at(stamp), stamp);
  tracks_.publish(to_tracks(people, header));
  people_.publish(to_people(people, header));
  if (people_markers_.has_readers()) people_markers_.publish(to_markers(people, kMarkerLifetime, header));
}

StaticObstacles PeopleComponent::walls_at(Time time) const {
  const auto from = placed(obstacles_, *transforms_, odom_frame_, time, obstacles_timeout_);
  return from ? to_obstacles(*obstacles_, from->X_TF) : StaticObstacles{};
}

void PeopleComponent::report_health(const Tick& tick) {
  using Level = DiagnosticReporter::Level;
  diagnostics_->set_value("refused_scans", std::to_string(lasers_.refusals()));
  diagnostics_->set_value("people", std::to_string(tracker_->people().size()));
  diagnostics_->set_value("refused_predictions", std::to_string(predictor_->refused()));
  diagnostics_->set_value("other_clusters", std::to_string(tracker_->cluster_count()));
  const std::string lasers = lasers_.complaint(tick.now);
  const std::string others = others_.complaint(tick.now);
  if (!lasers.empty()) return diagnostics_->report(Level::error, lasers);
  if (!others.empty()) return diagnostics_->report(Level::warn, others);
  if (std::exchange(refused_, predictor_->refused()) < predictor_->refused())
    return diagnostics_->report(Level::warn,
                                "learned predictions are not finite: straight on in their place");
  diagnostics_->report(Level::ok, "looking");
}

BW_COMPONENT(PeopleComponent, "people")

}  // namespace bw::people
