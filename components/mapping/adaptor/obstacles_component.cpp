// Adaptor of the obstacle extraction: the map's walls near the robot, in odom.
#include "components/mapping/adaptor/keepout_mask.hpp"
#include "components/mapping/obstacle_extraction.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/obstacles.hpp"
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

}  // namespace

class ObstaclesComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<ObstaclesOptions>(
        [this](const ObstaclesOptions& changed, const Tick&) { options_ = changed; }, {"rate"});
    odom_frame_ = setup.frame("odom");
    base_frame_ = setup.frame("base_link");
    transforms_ = setup.transforms();
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles");
    map_ = listen_to_map(setup);
    keepout_.listen(setup, transforms_);
    setup.every(Duration::seconds(1.0 / options_.rate), "extract",
                [this](const Tick& tick) { extract(tick.now); });
  }

 private:
  /// Silent until there is a map and a position in it, and it is known where the keep-out zones are: whoever
  /// reads obstacles watches their age.
  void extract(Time now) {
    if (map_->frame.empty() || !keepout_.fault(map_->frame).empty()) return;
    const std::optional<Pose2> X_OM = transforms_->lookup_planar(odom_frame_, map_->frame);
    const std::optional<Pose2> X_MB = transforms_->lookup_planar(map_->frame, base_frame_);
    if (!X_OM || !X_MB) return;
    StaticObstacles near = extract_obstacles(map_->grid, X_MB->position(), options_.extraction).obstacles;
    keepout_.add_to(near, X_MB->position(), map_->frame, options_.extraction);
    obstacles_.publish(to_message(near, *X_OM, odom_frame_, now));
  }

  ObstaclesOptions options_;
  std::string odom_frame_;
  std::string base_frame_;
  KeepoutMask keepout_;
  std::shared_ptr<const KnownMap> map_;
  std::shared_ptr<const TransformTree> transforms_;
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
};

BW_COMPONENT(ObstaclesComponent, "obstacles")

}  // namespace bw
