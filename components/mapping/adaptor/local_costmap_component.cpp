// Adaptor of the local costmap: sweeps of the laser in; costs, and obstacles for the local planner out.
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/mapping/adaptor/costmap_services.hpp"
#include "components/mapping/adaptor/costmap_topics.hpp"
#include "components/mapping/adaptor/keepout_mask.hpp"
#include "components/mapping/adaptor/map_below.hpp"
#include "components/mapping/costmap/inflation.hpp"
#include "components/mapping/costmap/local_grid.hpp"
#include "components/mapping/local_costmap_parameters.hpp"
#include "components/messages/footprint_source.hpp"
#include "components/messages/laser.hpp"
#include "components/messages/obstacles.hpp"
#include "components/messages/placed.hpp"
#include "components/messages/waiting_scans.hpp"
#include "components/model/robot.hpp"
#include "components/model/sweep_motion.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw::costmap {

class LocalCostmapComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<LocalCostmapParameters>(
        [this](const LocalCostmapParameters& changed, const Tick& tick) {
          footprint_.set_options(changed.footprint, tick);
          parameters_ = changed;
          grid_->set_options(changed.grid);
          inflate_around(footprint_.now());
        },
        {"use_map", "nav2_names", "width", "height", "resolution"});
    footprint_.offer(setup, setup.shared<Robot>("robot"), parameters_.footprint,
                     [this](const Footprint& footprint) { inflate_around(footprint); });
    grid_.emplace(parameters_.grid);
    inflate_around(footprint_.now());
    log_ = setup.log();
    diagnostics_ = &setup.diagnostics();
    odom_frame_ = setup.frame("odom");
    base_frame_ = setup.frame("base_link");
    transforms_ = setup.transforms();
    topics_.offer(setup, parameters_.nav2_names);
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles");
    setup.input<sensor_msgs::msg::LaserScan>("scan", Qos::sensor(),
                                             [this](const auto& message, const Tick& tick) {
                                               waiting_.add(message, tick.now);
                                               take_in(tick.now);
                                             });
    tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::standard(), Need::optional);
    if (parameters_.use_map) map_.listen(setup, transforms_);
    keepout_.listen(setup, transforms_);
    setup.every(Duration::milliseconds(10), "sweeps", [this](const Tick& tick) { take_in(tick.now); });
    offer_services(setup, parameters_.nav2_names ? "" : "local_costmap/",
                   {.grid = grid_, .X_OB = X_OB_, .costs = [this](Time now) { return costs(now); }});
  }

  void activate(const Tick& tick) override { footprint_.activate(tick); }

 private:
  void inflate_around(const Footprint& footprint) {
    inflation_.emplace(parameters_.inflation, inscribed_radius(footprint), parameters_.grid.resolution);
  }

  void take_in(Time now) {
    waiting_.hand_over([&](const sensor_msgs::msg::LaserScan& scan, Time received) {
      const Time stamp = time_of(scan);
      const auto X_OL = transforms_->lookup_planar(odom_frame_, scan.header().frame_id(), stamp);
      const auto X_OB = transforms_->lookup_planar(odom_frame_, base_frame_, stamp);
      if (stamp <= Time{}) {
        note("it has no stamp");
      } else if (X_OL && X_OB) {
        add(scan, stamp, *X_OL, *X_OB);
      } else if (now - received <= Duration::seconds(parameters_.transform_timeout)) {
        return false;
      } else {
        note("no transform to odom at the time of the sweep");
      }
      return true;
    });
  }

  void add(const sensor_msgs::msg::LaserScan& message, Time stamp, const Pose2& X_OL, const Pose2& X_OB) {
    LaserSweep sweep = to_sweep(message, X_OL);
    const std::vector<Pose2> poses = beam_poses(sweep, inverse(X_OB) * X_OL, [this](Time time) {
      return transforms_->lookup_planar(odom_frame_, base_frame_, time);
    });
    sweep.beam_poses = poses;
    const SweepFault fault = grid_->add(sweep, X_OB, footprint_.now(), people_at(stamp));
    const std::string why = fault == SweepFault::none ? keepout_.fault(odom_frame_) : to_text(fault);
    note(why);
    if (!why.empty()) return;
    swept_ = stamp;
    X_OB_ = X_OB;
    // A tenth of a period for stamps that tremble.
    if (published_ && stamp - *published_ < Duration::seconds(0.9 / parameters_.rate) && stamp > *published_)
      return;
    published_ = stamp;
    publish(stamp);
  }

  /// Silent while no sweep is usable, or nobody knows where the keep-out zones are: whoever reads obstacles
  /// watches their age.
  void publish(Time stamp) {
    cells_ = grid_->cells();
    map_.fill(cells_);
    StaticObstacles near =
        extract_obstacles(cells_, X_OB_.position(), parameters_.obstacles, grid_->surface()).obstacles;
    keepout_.add_to(near, X_OB_.position(), odom_frame_, parameters_.obstacles);
    obstacles_.publish(to_message(near, {}, odom_frame_, stamp));
    diagnostics_->set_value("shapes", std::to_string(near.size()));
    if (!topics_.has_readers()) return;
    keepout_.mark(cells_, odom_frame_);
    topics_.publish(cells_, inflation_->costs(cells_), X_OB_, footprint_.now(),
                    make_header(odom_frame_, stamp));
  }

  nav2_msgs::msg::Costmap costs(Time now) {
    OccupancyGrid cells = grid_->cells();
    map_.fill(cells);
    keepout_.mark(cells, odom_frame_);
    return to_costmap(cells, inflation_->costs(cells), odom_frame_, swept_.value_or(now));
  }

  std::vector<Disc> people_at(Time time) const {
    const auto from = placed(tracks_, *transforms_, odom_frame_, time, parameters_.tracks_timeout);
    return from ? to_discs(*tracks_, from->age, from->X_TF) : std::vector<Disc>{};
  }

  /// Says once why sweeps are not used, and once that they are again.
  void note(const std::string& fault) {
    if (!fault_.is_news(fault)) return;
    using Level = DiagnosticReporter::Level;
    if (fault.empty()) {
      diagnostics_->report(Level::ok, "sweeps are used");
    } else {
      log_.warn("a sweep is not used: {}", fault);
      diagnostics_->report(Level::error, "sweeps are not used: " + fault);
    }
  }

  LocalCostmapParameters parameters_;
  FootprintSource footprint_;
  std::optional<LocalGrid> grid_;
  std::optional<Inflation> inflation_;
  OccupancyGrid cells_;
  MapBelow map_;
  KeepoutMask keepout_;
  WaitingScans waiting_;
  std::optional<Time> swept_;  ///< stamp of the last sweep that was used
  Pose2 X_OB_;                 ///< at that time
  std::optional<Time> published_;
  Complaint fault_{"none came yet"};
  Logger log_;
  DiagnosticReporter* diagnostics_ = nullptr;
  std::string odom_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  CostmapTopics topics_;
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
};

BW_COMPONENT(LocalCostmapComponent, "local_costmap")

}  // namespace bw::costmap
