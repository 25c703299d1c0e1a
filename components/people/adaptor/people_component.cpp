#include "components/people/adaptor/people_component.hpp"

#include <cmath>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/laser.hpp"
#include "components/messages/obstacles.hpp"

namespace bw::people {
namespace {

constexpr std::size_t kMostWaiting = 4;  // scans whose odometry has not come
constexpr Duration kSilence = Duration::milliseconds(500);
const Duration kMarkerLifetime = Duration::milliseconds(250);

PersonState state_of(const TrackedPerson& person) {
  return {person.id, person.position, person.velocity, person.covariance, person.radius};
}

}  // namespace

void PeopleComponent::configure(Setup& setup) {
  const auto parameters = setup.parameters<PeopleParameters>();
  detector_ = std::make_unique<Detector>(parameters.detector);
  tracker_ = std::make_unique<Tracker>(parameters.tracker);
  predictor_ = std::make_unique<Predictor>(parameters.prediction);
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
  setup.input<sensor_msgs::msg::LaserScan>("scan", Qos::sensor(),
                                           [this](const auto& message, const Tick& tick) {
                                             now_ = tick.now;
                                             on_scan(message);
                                           });
  setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                       [this](const auto& message, const Tick& tick) {
                                         now_ = tick.now;
                                         on_odometry(message);
                                       });
  if (parameters.detector.background.use_map) {
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [this](const auto& message, const Tick&) { on_map(message); }, Need::optional);
  }
  if (parameters.prediction.model == "social_force") {
    obstacles_ = setup.latest<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::standard(), Need::optional);
  }
  setup.every(Duration::milliseconds(500), "health", [this](const Tick& tick) { report_health(tick); });
}

void PeopleComponent::on_odometry(const nav_msgs::msg::Odometry& message) {
  const Pose2 X_OB = from_pose(message.pose().pose());
  if (!is_finite(X_OB)) return;
  odometry_.set(odom_frame_, base_frame_, from_stamp(message.header().stamp()), spatial(X_OB), false);
  look();
}

void PeopleComponent::on_map(const nav_msgs::msg::OccupancyGrid& message) {
  OccupancyGrid grid;
  if (const std::string fault = read_grid(message, grid); !fault.empty()) {
    log_.error("the map is of no use: {}", fault);
    return;
  }
  detector_->set_map(grid);
  map_of_detector_ = message.header().frame_id();
}

void PeopleComponent::on_scan(const sensor_msgs::msg::LaserScan& message) {
  if (from_stamp(message.header().stamp()) == Time{}) return refuse("it has no stamp");
  if (waiting_.size() >= kMostWaiting) {
    waiting_.pop_front();
    refuse("no odometry at its stamp");
  }
  waiting_.push_back(message);
  look();
}

void PeopleComponent::look() {
  while (!waiting_.empty()) {
    const Time stamp = from_stamp(waiting_.front().header().stamp());
    const auto X_OB = odometry_.lookup_planar(odom_frame_, base_frame_, stamp);
    if (!X_OB) return;  // odometry of that moment may still come
    const sensor_msgs::msg::LaserScan scan = std::move(waiting_.front());
    waiting_.pop_front();
    look_at(scan, *X_OB);
  }
}

void PeopleComponent::look_at(const sensor_msgs::msg::LaserScan& scan, const Pose2& X_OB) {
  const LaserSweep sweep = to_sweep(scan, X_OB * mounts_.of(scan.header().frame_id()));
  if (const SweepFault fault = fault_for_people(sweep); fault != SweepFault::none)
    return refuse(to_text(fault));
  if (!refused_.empty()) log_.info("scans are sound again");
  refused_.clear();
  last_look_ = now_;
  Surroundings surroundings;
  if (!map_of_detector_.empty())
    surroundings.X_MO = transforms_->lookup_planar(map_of_detector_, odom_frame_);
  const std::vector<Vector2> keep_out = tracker_->keep_out();
  surroundings.people = keep_out;
  const DetectionSet& detections = detector_->detect(sweep, surroundings);
  publish(detections, tracker_->update(detections));
}

void PeopleComponent::publish(const DetectionSet& detections, const std::vector<TrackedPerson>& tracked) {
  const std_msgs::msg::Header header = make_header(odom_frame_, detections.time);
  const std::vector<ReportedPerson> reported = report_of(tracked, detections.time);
  tracks_.publish(to_tracks(reported, header));
  people_.publish(to_people(reported, header));
  if (people_markers_.has_readers()) people_markers_.publish(to_markers(reported, kMarkerLifetime, header));
  if (leg_markers_.has_readers()) leg_markers_.publish(to_markers(detections, kMarkerLifetime, header));
}

std::vector<ReportedPerson> PeopleComponent::report_of(const std::vector<TrackedPerson>& tracked, Time time) {
  std::vector<PersonState> states;
  states.reserve(tracked.size());
  for (const TrackedPerson& person : tracked) states.push_back(state_of(person));
  const auto predictions = predictor_->predict(states, walls_at(time), time);
  std::vector<ReportedPerson> reported;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const TrackedPerson& person = tracked[i];
    reported.push_back({{.id = person.id,
                         .position = person.position,
                         .velocity = person.velocity,
                         .radius = person.radius,
                         .predictions = predictions[i]},
                        person.covariance,
                        person.confidence});
  }
  return reported;
}

StaticObstacles PeopleComponent::walls_at(Time time) const {
  if (!obstacles_) return {};
  const double age = (time - from_stamp(obstacles_->header().stamp())).to_seconds();
  const auto X_OF = transforms_->lookup_planar(odom_frame_, obstacles_->header().frame_id());
  if (!X_OF || std::abs(age) > obstacles_timeout_) return {};
  return to_obstacles(*obstacles_, *X_OF);
}

void PeopleComponent::refuse(const std::string& why) {
  ++refusals_;
  if (refused_ != why) log_.warn("a scan is not looked at: {}", why);
  refused_ = why;
}

void PeopleComponent::report_health(const Tick& tick) {
  using Level = DiagnosticReporter::Level;
  diagnostics_->set_value("refused_scans", std::to_string(refusals_));
  diagnostics_->set_value("people", std::to_string(tracker_->people().size()));
  diagnostics_->set_value("other_clusters", std::to_string(tracker_->cluster_count()));
  const bool blind = !last_look_ || tick.now - *last_look_ > kSilence;
  if (!refused_.empty()) {
    diagnostics_->report(Level::error, "scans are refused: " + refused_);
  } else if (blind) {
    diagnostics_->report(Level::error, "no scan to look at");
  } else {
    diagnostics_->report(Level::ok, "looking");
  }
}

BW_COMPONENT(PeopleComponent, "people")

}  // namespace bw::people
