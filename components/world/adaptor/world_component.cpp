// Adaptor of the simulated world: wheel commands in, sensors and truth out.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tf2_msgs/msg/tf_message.hpp>

#include "components/files/map_file.hpp"
#include "components/files/shape_file.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/obstacles.hpp"
#include "components/world/adaptor/no_hardware.hpp"
#include "components/world/adaptor/people_services.hpp"
#include "components/world/adaptor/robot_ends.hpp"
#include "components/world/files/track_file.hpp"
#include "components/world/world.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

WorldFiles read_files(const Setup& setup) {
  WorldFiles files;
  if (const auto file = setup.file_parameter("map"); !file.empty()) files.map = load_map(file);
  if (const auto file = setup.file_parameter("tracks"); !file.empty())
    files.tracks = read_tracks(file.string());
  if (const auto file = setup.file_parameter("track_walls"); !file.empty()) {
    files.shapes.segments = read_walls(file.string());
  }
  if (const auto file = setup.file_parameter("track_circles"); !file.empty()) {
    files.shapes.discs = read_circles(file.string());
  }
  return files;
}

class WorldComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<WorldOptions>();
    const auto robot = setup.shared<Robot>("robot");
    refuse_hardware(setup, robot);
    const std::uint64_t seed = setup.seed() + static_cast<std::uint64_t>(options_.seed_offset);
    WorldFiles files = read_files(setup);
    world_ = std::make_unique<World>(options_, robot, files, seed);
    map_ = std::move(files.map);
    map_frame_ = setup.frame("map");
    std::vector<std::string> names = {""};
    if (!options_.robots.empty()) names.clear();
    for (const WorldRobotOptions& one : options_.robots) names.push_back(one.name);
    for (std::size_t i = 0; i < names.size(); ++i)
      robots_.push_back(std::make_unique<RobotEnds>(setup, *world_, i, names[i], robot, options_));
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("sim/obstacles", Qos::latched());
    if (map_) true_map_ = setup.output<nav_msgs::msg::OccupancyGrid>("sim/map", Qos::latched());
    for (const std::string& name : names) place_unlisted_sensors(setup, robot, name);
    if (!unlisted_.empty()) mounts_ = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched());
    offer_people_services(setup, *world_, options_.people.social.radius);
    setup.every(world_->physics_step(), "physics", [this](const Tick& tick) { catch_up(tick.now); });
  }

  void activate(const Tick& tick) override {
    start_ = tick.now - world_->time();
    const StaticScene& scene = world_->scene();
    const StaticObstacles shapes{.discs = scene.discs(), .segments = scene.segments()};
    obstacles_.publish(to_message(shapes, Pose2{}, map_frame_, tick.now));
    if (map_) true_map_.publish(to_message(*map_, map_frame_, tick.now));
    if (!unlisted_.empty()) publish_mounts(tick.now);
  }
  void deactivate(const Tick&) override {
    for (std::size_t i = 0; i < robots_.size(); ++i) world_->command({}, i);
  }

 private:
  /// The base tells where the robot's sensors sit; those that the robot does not list sit at base_link.
  void place_unlisted_sensors(const Setup& setup, const Robot& robot, const std::string& name) {
    const std::string below = name.empty() ? "" : name + "/";
    std::vector<std::string> frames = {options_.laser.frame, ImuOptions::kFrame, GpsOptions::kFrame};
    for (const MoreLaserOptions& one : options_.more_lasers) frames.push_back(one.frame);
    for (const std::string& frame : frames)
      if (!robot.has_mount_of(frame))
        unlisted_.emplace_back(setup.frame(below + frame), setup.frame(below + "base_link"));
  }

  void publish_mounts(Time now) {
    tf2_msgs::msg::TFMessage mounts;
    for (const auto& [frame, base_frame] : unlisted_)
      mounts.transforms().push_back(to_transform(base_frame, frame, now, Pose2{}));
    mounts_.publish(mounts);
  }

  /// Steps up to `now`. A host that was held up for long, or a clock that jumped ahead, slows the world down
  /// instead of making it race; after a clock that went back the world goes on from there.
  void catch_up(Time now) {
    constexpr Duration kMaxApart = Duration::milliseconds(500);
    if (now - start_ > world_->time() + kMaxApart) start_ = now - world_->time() - kMaxApart;
    if (world_->time() - (now - start_) > kMaxApart) start_ = now - world_->time();
    while (start_ + world_->time() + world_->physics_step() <= now) {
      world_->step();
      for (const auto& robot : robots_) robot->publish(options_, start_);
    }
  }

  WorldOptions options_;
  std::unique_ptr<World> world_;
  std::vector<std::unique_ptr<RobotEnds>> robots_;
  std::optional<OccupancyGrid> map_;  ///< of the world, where it has one
  Time start_;                        ///< component time of world time zero
  std::string map_frame_;
  std::vector<std::pair<std::string, std::string>>
      unlisted_;  ///< sensors the robot says nothing of, and their bases
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
  Output<nav_msgs::msg::OccupancyGrid> true_map_;
  Output<tf2_msgs::msg::TFMessage> mounts_;
};

}  // namespace

BW_COMPONENT(WorldComponent, "world")

}  // namespace bw
