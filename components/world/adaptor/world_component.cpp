// Adaptor of the simulated world: wheel commands in, sensors and truth out.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sensor_msgs/msg/joint_state.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/files/map_file.hpp"
#include "components/files/shape_file.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/obstacles.hpp"
#include "components/world/adaptor/world_messages.hpp"
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
    const std::uint64_t seed = setup.seed() + static_cast<std::uint64_t>(options_.seed_offset);
    WorldFiles files = read_files(setup);
    world_ = std::make_unique<World>(options_, robot, files, seed);
    map_ = std::move(files.map);
    log_ = setup.log();

    setup.input<sensor_msgs::msg::JointState>("sim/wheel_commands", Qos::command(),
                                              [this](const auto& message, const Tick&) { command(message); });
    ticks_ = setup.output<bandwagon_msgs::msg::WheelTicks>("sim/wheel_ticks");
    truth_ = setup.output<bandwagon_msgs::msg::GroundTruth>("sim/ground_truth");
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("sim/obstacles", Qos::latched());
    if (map_) true_map_ = setup.output<nav_msgs::msg::OccupancyGrid>("sim/map", Qos::latched());
    scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan");
    imu_ = setup.output<sensor_msgs::msg::Imu>("imu");
    fix_ = setup.output<sensor_msgs::msg::NavSatFix>("gps/fix");
    map_frame_ = setup.frame("map");
    base_frame_ = setup.frame("base_link");
    imu_frame_ = setup.frame(options_.imu.frame);
    gps_frame_ = setup.frame(options_.gps.frame);
    scan_message_.header().frame_id(setup.frame(options_.laser.frame));
    for (const std::string& frame : {options_.laser.frame, options_.imu.frame, options_.gps.frame})
      if (!robot.has_mount_of(frame)) unlisted_.push_back(setup.frame(frame));
    if (!unlisted_.empty()) mounts_ = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched());
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
  void deactivate(const Tick&) override { world_->command({}); }

 private:
  /// The base tells where the robot's sensors sit; those that the robot does not list sit at base_link.
  void publish_mounts(Time now) {
    tf2_msgs::msg::TFMessage mounts;
    for (const std::string& frame : unlisted_)
      mounts.transforms().push_back(to_transform(base_frame_, frame, now, Pose2{}));
    mounts_.publish(mounts);
  }

  void command(const sensor_msgs::msg::JointState& message) {
    const auto& rates = message.velocity();
    const bool usable = rates.size() == 2 && world_->command({rates[0], rates[1]});
    if (!usable) world_->command({});
    if (!usable && was_usable_) {
      log_.warn("wheel commands must hold two finite rates, left and right; the base brakes");
    }
    was_usable_ = usable;
  }

  /// Steps up to `now`. A host that was held up for long, or a clock that jumped ahead, slows the world down instead of
  /// making it race; after a clock that went back the world goes on from there.
  void catch_up(Time now) {
    constexpr Duration kMostApart = Duration::milliseconds(500);
    if (now - start_ > world_->time() + kMostApart) start_ = now - world_->time() - kMostApart;
    if (world_->time() - (now - start_) > kMostApart) start_ = now - world_->time();
    while (start_ + world_->time() + world_->physics_step() <= now) publish(world_->step());
  }

  void publish(const WorldSample& sample) {
    const Time stamp = start_ + sample.time;
    if (sample.ticks) send(ticks_, to_message(*sample.ticks, stamp), base_frame_);
    if (sample.imu) send(imu_, to_message(*sample.imu, options_.imu, stamp), imu_frame_);
    for (const GpsFix& fix : sample.fixes) send(fix_, to_message(fix, options_.gps, start_), gps_frame_);
    if (sample.truth_due) send(truth_, ground_truth(*world_, stamp), map_frame_);
    if (sample.scan) {
      to_message(*sample.scan, options_.laser, stamp, scan_message_);
      scan_.publish(scan_message_);
    }
  }

  template <class Message>
  static void send(Output<Message>& output, Message message, const std::string& frame) {
    message.header().frame_id(frame);
    output.publish(message);
  }

  WorldOptions options_;
  std::unique_ptr<World> world_;
  std::optional<OccupancyGrid> map_;  ///< of the world, where it has one
  Logger log_;
  Time start_;  ///< component time of world time zero
  bool was_usable_ = true;
  std::string map_frame_;
  std::string base_frame_;
  std::string imu_frame_;
  std::string gps_frame_;
  std::vector<std::string> unlisted_;  ///< frames of sensors that the robot does not say anything of
  sensor_msgs::msg::LaserScan scan_message_;
  Output<bandwagon_msgs::msg::WheelTicks> ticks_;
  Output<bandwagon_msgs::msg::GroundTruth> truth_;
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
  Output<nav_msgs::msg::OccupancyGrid> true_map_;
  Output<sensor_msgs::msg::LaserScan> scan_;
  Output<sensor_msgs::msg::Imu> imu_;
  Output<sensor_msgs::msg::NavSatFix> fix_;
  Output<tf2_msgs::msg::TFMessage> mounts_;
};

}  // namespace

BW_COMPONENT(WorldComponent, "world")

}  // namespace bw
