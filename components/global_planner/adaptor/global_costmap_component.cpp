// Adaptor of the global costmap: what the planner pays for each cell of the map, under the names of the
// costmap inside Nav2's planner_server. A graph puts it into the namespace `global_costmap`.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <nav2_msgs/srv/get_costmap.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/global_planner/costs.hpp"
#include "components/global_planner/global_costmap_parameters.hpp"
#include "components/mapping/adaptor/keepout_mask.hpp"
#include "components/mapping/costmap/inflation.hpp"
#include "components/messages/costmap.hpp"
#include "components/messages/costmap_clearing.hpp"
#include "components/messages/footprint_source.hpp"
#include "components/messages/map_input.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

class GlobalCostmapComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<GlobalCostmapParameters>(
        [this](const GlobalCostmapParameters& changed, const Tick& tick) {
          footprint_.set_options(changed.footprint, tick);
        },
        {"publish_frequency", "clearance_range", "clearance_weight", "unknown_is_obstacle"});
    footprint_.offer(setup, setup.shared<Robot>("robot"), parameters_.footprint,
                     [this](const Footprint&) { has_new_footprint_ = true; });
    setup.longest_callback(Duration::milliseconds(5'000));  // a large map
    log_ = setup.log();
    base_frame_ = setup.frame("base_link");
    transforms_ = setup.transforms();
    costmap_ = setup.output<nav_msgs::msg::OccupancyGrid>("costmap", Qos::latched());
    costmap_raw_ = setup.output<nav2_msgs::msg::Costmap>("costmap_raw", Qos::latched());
    published_footprint_ = setup.output<geometry_msgs::msg::PolygonStamped>("published_footprint");
    listen_to_map(setup, [this](const KnownMap& map, const Tick& tick) { on_map(map, tick.now); });
    keepout_.listen(setup, transforms_, [this](const Tick& tick) {
      if (!map_frame_.empty()) publish_costs(tick.now);
    });
    setup.every(Duration::seconds(1.0 / parameters_.publish_frequency), "footprint",
                [this](const Tick& tick) {
                  if (std::exchange(has_new_footprint_, false) && !map_frame_.empty())
                    publish_costs(tick.now);
                  publish_footprint(tick.now);
                });
    offer_services(setup);
  }

  void activate(const Tick& tick) override { footprint_.activate(tick); }

 private:
  void offer_services(Setup& setup) {
    using nav2_msgs::srv::GetCostmap;
    setup.service<GetCostmap>("get_costmap", [this](const GetCostmap::Request&, const Tick& tick) {
      GetCostmap::Response response;
      response.map(costs(tick.now));
      return response;
    });
    const auto tell = [this] {
      if (std::exchange(has_told_, true)) return;
      log_.info("the global costmap holds the map alone: there is nothing to clear");
    };
    offer_clear_services(
        setup, "", "global_costmap",
        {.entirely = tell, .inside = [tell](double) { tell(); }, .outside = [tell](double) { tell(); }});
  }

  void on_map(const KnownMap& map, Time now) {
    if (map.grid.width > SearchGrid::kMaxSide || map.grid.height > SearchGrid::kMaxSide) {
      log_.warn("the map is not used: it has more than {} cells on a side", SearchGrid::kMaxSide);
      return;
    }
    map_ = map.grid;
    map_frame_ = map.frame;
    publish_costs(now);
  }

  void publish_costs(Time now) {
    OccupancyGrid shown = map_;
    keepout_.mark(shown, map_frame_);
    SearchGrid grid;
    grid.build(shown, footprint_.now(), parameters_.planner);
    costs_ = costs_of(grid, shown, parameters_.planner.clearance_weight);
    costmap_raw_.publish(costs(now));
    for (std::size_t i = 0; i < costs_.size(); ++i) shown.cells[i] = costmap::occupancy_of(costs_[i]);
    costmap_.publish(to_message(shown, map_frame_, now));
  }

  nav2_msgs::msg::Costmap costs(Time now) const {
    if (map_frame_.empty()) return {};
    return to_costmap(map_, costs_, map_frame_, now);
  }

  void publish_footprint(Time now) {
    if (map_frame_.empty() || !published_footprint_.has_readers()) return;
    const std::optional<Pose2> X_MB = transforms_->lookup_planar(map_frame_, base_frame_);
    if (X_MB)
      published_footprint_.publish(
          to_published_footprint(*X_MB, footprint_.now(), make_header(map_frame_, now)));
  }

  GlobalCostmapParameters parameters_;
  FootprintSource footprint_;
  bool has_new_footprint_ = false;
  Logger log_;
  bool has_told_ = false;
  OccupancyGrid map_;
  KeepoutMask keepout_;
  std::vector<std::uint8_t> costs_;  ///< of its cells
  std::string map_frame_;            ///< empty until a usable map came
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Output<nav_msgs::msg::OccupancyGrid> costmap_;
  Output<nav2_msgs::msg::Costmap> costmap_raw_;
  Output<geometry_msgs::msg::PolygonStamped> published_footprint_;
};

BW_COMPONENT(GlobalCostmapComponent, "global_costmap")

}  // namespace bw
