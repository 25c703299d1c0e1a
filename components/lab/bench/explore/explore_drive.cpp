#include "components/lab/bench/explore/explore_drive.hpp"

#include <memory>
#include <stdexcept>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <fmt/format.h>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>

#include "components/explore/adaptor/explore_component.hpp"
#include "components/lab/bench/shapes_file.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/map_input.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/parameters/overrides.hpp"

namespace bw {
namespace {

std::string rows_of(const buildings::Building& building) {
  std::string rows = "x1_m,y1_m,x2_m,y2_m\n";
  for (const Segment& wall : building.walls)
    rows += fmt::format("{},{},{},{}\n", wall.a.x(), wall.a.y(), wall.b.x(), wall.b.y());
  return rows;
}

/// Says "go", follows what comes of it, and ends the run a while after it is complete.
class ExploreObserver final : public Component {
 public:
  explicit ExploreObserver(std::shared_ptr<ExploreDrive> seen) : seen_(std::move(seen)) {}

  void configure(Setup& setup) override {
    seen_->radius = setup.shared<Robot>("robot").outline().radius;
    finish_run_ = setup.finish_run();
    resume_ = setup.output<std_msgs::msg::Bool>("explore/resume");
    setup.input<std_msgs::msg::String>("explore/status", Qos::latched(),
                                       [this](const auto& message, const Tick&) { hear(message.data()); });
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::standard(),
        [this](const auto& truth, const Tick& tick) { follow(truth, tick.now); });
    listen_to_map(setup, [this](const KnownMap& map, const Tick&) { seen_->map = map.grid; });
    setup.every(Duration::seconds(1.0), "look", [this](const Tick& tick) { look(tick.now); });
  }

 private:
  static constexpr double kBegin = 3.0;     // [s] from the start: the map is there
  static constexpr double kLastMap = 12.0;  // [s] in which all that was seen has come into the map

  void hear(const std::string& status) {
    seen_->status = status;
    seen_->complete = status.starts_with(to_string(explore::ExploreState::complete));
  }

  void follow(const bandwagon_msgs::msg::GroundTruth& truth, Time now) {
    seen_->contacts = truth.contacts();
    if (seen_->complete) return;
    const Vector2 at = from_pose(truth.pose()).position();
    if (last_) seen_->travel += (at - *last_).norm();
    last_ = at;
    seen_->time = (now - LockstepRunner::kStart).to_seconds();
  }

  void look(Time now) {
    if ((now - LockstepRunner::kStart).to_seconds() >= kBegin && !is_told_) {
      std_msgs::msg::Bool message;
      message.data(true);
      resume_.publish(message);
      is_told_ = true;
    }
    if (!seen_->complete) return;
    if (!complete_since_) complete_since_ = now;
    if ((now - *complete_since_).to_seconds() >= kLastMap) finish_run_(true, "explored");
  }

  std::shared_ptr<ExploreDrive> seen_;
  std::function<void(bool, const std::string&)> finish_run_;
  Output<std_msgs::msg::Bool> resume_;
  std::optional<Vector2> last_;
  std::optional<Time> complete_since_;
  bool is_told_ = false;
};

}  // namespace

ExploreDrive explore_building(const buildings::Building& building, const ExploreDriveOptions& options) {
  const ShapesFile walls("building", rows_of(building));
  const Vector2 start = building.route.front();
  std::vector<std::string> set = {
      "emulate=true",
      "world.track_walls=" + walls.path().string(),
      fmt::format("world.start={{x: {}, y: {}, theta: 0.0}}", start.x(), start.y()),
      fmt::format("slam.map_start_pose={{x: {}, y: {}, yaw: 0.0}}", start.x(), start.y()),
      "slam.enabled=true",
      "ideal_localization.enabled=false",
      "map_server.enabled=false",
      "evaluation.enabled=false",
      "navigator.goal.enabled=false",
  };
  set.push_back("robot=" + options.robot);
  set.insert(set.end(), options.set.begin(), options.set.end());
  Graph graph = load_graph(options.graph, set);

  auto seen = std::make_shared<ExploreDrive>();
  std::vector<ExtraComponent> extra;
  extra.push_back({.name = "explore", .component = make_explore_component(false)});
  extra.push_back({.name = "explore_observer", .component = std::make_unique<ExploreObserver>(seen)});
  HostOptions host_options;
  host_options.clock = ClockMode::lockstep;
  host_options.alone = true;
  host_options.seed = options.seed;
  Host host(std::move(graph), host_options, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(options.longest));
  if (end.has_thrown) throw std::runtime_error(building.name + ": " + end.reason);
  seen->samples_sha256 = host.samples_sha256();
  return *seen;
}

}  // namespace bw
