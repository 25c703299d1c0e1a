// Adaptor of the obstacle extraction: the map's walls near the robot, in odom.
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/mapping/grid_messages.hpp"
#include "components/mapping/obstacle_extraction.hpp"
#include "components/messages/geometry.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {
namespace {

struct ObstaclesOptions {
  double rate = 10.0;  ///< [Hz]
  ExtractionOptions extraction;

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0.1, .max = 100, .doc = "obstacle messages per second"});
    extraction.fields(v);
  }
};

geometry_msgs::msg::Point32 to_point32(const Vector2& p) {
  geometry_msgs::msg::Point32 point;
  point.x(static_cast<float>(p.x()));
  point.y(static_cast<float>(p.y()));
  return point;
}

bandwagon_msgs::msg::LineSegment to_line(const Vector2& a, const Vector2& b) {
  bandwagon_msgs::msg::LineSegment line;
  line.x1(static_cast<float>(a.x()));
  line.y1(static_cast<float>(a.y()));
  line.x2(static_cast<float>(b.x()));
  line.y2(static_cast<float>(b.y()));
  return line;
}

bandwagon_msgs::msg::Disc to_disc(const Vector2& center, double radius) {
  bandwagon_msgs::msg::Disc disc;
  disc.x(static_cast<float>(center.x()));
  disc.y(static_cast<float>(center.y()));
  disc.radius(static_cast<float>(radius));
  return disc;
}

}  // namespace

class ObstaclesComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<ObstaclesOptions>();
    log_ = setup.log();
    odom_frame_ = setup.frame("odom");
    base_frame_ = setup.frame("base_link");
    transforms_ = setup.transforms();
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles");
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [this](const auto& message, const Tick&) { keep_map(message); });
    setup.every(Duration::seconds(1.0 / options_.rate), "extract",
                [this](const Tick& tick) { extract(tick.now); });
  }

 private:
  void keep_map(const nav_msgs::msg::OccupancyGrid& message) {
    const std::string fault = read_grid(message, grid_);
    if (fault.empty()) {
      map_frame_ = message.header().frame_id();
    } else {
      log_.warn("the map is not used: {}", fault);
    }
  }

  /// Silent until there is a map and a place in it: whoever reads obstacles watches their age.
  void extract(Time now) {
    if (map_frame_.empty()) return;
    const std::optional<Pose2> X_OM = transforms_->lookup_planar(odom_frame_, map_frame_);
    const std::optional<Pose2> X_MB = transforms_->lookup_planar(map_frame_, base_frame_);
    if (!X_OM || !X_MB) return;
    const ExtractionResult near = extract_obstacles(grid_, X_MB->position(), options_.extraction);
    bandwagon_msgs::msg::Obstacles message;
    message.header(make_header(odom_frame_, now));
    for (const Vector2& p : near.obstacles.points) message.points().push_back(to_point32(*X_OM * p));
    for (const Disc& d : near.obstacles.discs) message.discs().push_back(to_disc(*X_OM * d.center, d.radius));
    for (const Segment& s : near.obstacles.segments)
      message.segments().push_back(to_line(*X_OM * s.a, *X_OM * s.b));
    obstacles_.publish(message);
    if (near.dropped > 0 && !dropping_) {
      log_.warn("the farthest {} obstacles are left out (max_obstacles)", near.dropped);
    }
    dropping_ = near.dropped > 0;
  }

  ObstaclesOptions options_;
  Logger log_;
  std::string odom_frame_;
  std::string base_frame_;
  std::string map_frame_;  ///< empty until a usable map came
  OccupancyGrid grid_;
  bool dropping_ = false;
  std::shared_ptr<const TransformTree> transforms_;
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
};

BW_COMPONENT(ObstaclesComponent, "obstacles")

}  // namespace bw
