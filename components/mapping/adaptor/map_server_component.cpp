// Adaptor of the map server: one latched map.
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/files/map_file.hpp"
#include "components/files/shape_file.hpp"
#include "components/mapping/map_server_options.hpp"
#include "components/mapping/rasterize.hpp"
#include "components/messages/grid.hpp"
#include "runtime/component.hpp"

namespace bw {

class MapServerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto options = setup.parameters<MapServerOptions>();
    const std::filesystem::path file = setup.file_parameter("map");
    grid_ = file.empty() ? area_grid(options.area) : load_map(file);
    draw_shapes(grid_, options.walls, options.boxes);
    if (const auto walls = setup.file_parameter("track_walls"); !walls.empty()) {
      for (const Segment& wall : read_walls(walls.string())) draw_segment(grid_, wall);
    }
    if (const auto circles = setup.file_parameter("track_circles"); !circles.empty()) {
      for (const Disc& circle : read_circles(circles.string())) draw_disc(grid_, circle);
    }
    frame_ = setup.frame("map");
    map_ = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched());
  }

  void activate(const Tick& tick) override { map_.publish(to_message(grid_, frame_, tick.now)); }

 private:
  OccupancyGrid grid_;
  std::string frame_;
  Output<nav_msgs::msg::OccupancyGrid> map_;
};

BW_COMPONENT(MapServerComponent, "map_server")

}  // namespace bw
