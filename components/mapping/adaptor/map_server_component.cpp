// Adaptor of the map server: one latched map, and services to ask for it, to put another in its place and to
// draw into it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <bandwagon_msgs/srv/draw_polygon.hpp>
#include <nav2_msgs/srv/load_map.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/srv/get_map.hpp>

#include "components/files/map_file.hpp"
#include "components/files/map_image.hpp"
#include "components/files/shape_file.hpp"
#include "components/mapping/map_server_options.hpp"
#include "components/mapping/rasterize.hpp"
#include "components/messages/grid.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using bandwagon_msgs::srv::DrawPolygon;
using nav2_msgs::srv::LoadMap;
using nav_msgs::srv::GetMap;

std::uint8_t to_result(MapFault fault) {
  namespace result = nav2_msgs::srv::LoadMap_Response_Constants;
  switch (fault) {
    case MapFault::none:
      return result::RESULT_SUCCESS;
    case MapFault::no_file:
      return result::RESULT_MAP_DOES_NOT_EXIST;
    case MapFault::bad_data:
      return result::RESULT_INVALID_MAP_DATA;
    case MapFault::bad_metadata:
      return result::RESULT_INVALID_MAP_METADATA;
    case MapFault::other:
      break;
  }
  return result::RESULT_UNDEFINED_FAILURE;
}

DrawPolygon::Response refusal_to_draw(const std::string& why) {
  DrawPolygon::Response response;
  response.message(why);
  return response;
}

/// Why it is nothing that can be drawn; empty: it is.
std::string fault_of(const DrawPolygon::Request& request, const std::string& frame) {
  constexpr std::size_t kMaxCorners = 10'000;
  const auto& corners = request.polygon().polygon().points();
  const std::string& asked = request.polygon().header().frame_id();
  const bool is_finite = std::ranges::all_of(
      corners, [](const auto& corner) { return std::isfinite(corner.x()) && std::isfinite(corner.y()); });
  if (asked != frame) return "the polygon is in frame '" + asked + "', and must be in '" + frame + "'";
  if (corners.empty() || corners.size() > kMaxCorners)
    return "a polygon has from 1 to " + std::to_string(kMaxCorners) + " corners";
  if (!is_finite) return "a corner is not finite";
  if (request.value() < OccupancyGrid::kUnknown || request.value() > OccupancyGrid::kOccupied)
    return "value must be -1, or from 0 to 100";
  return {};
}

LoadMap::Response response_of(MapFault fault) {
  LoadMap::Response response;
  response.result(to_result(fault));
  return response;
}

}  // namespace

class MapServerComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    const auto options = setup.parameters<MapServerOptions>();
    setup.longest_callback(Duration::milliseconds(10'000));  // files
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
    log_ = setup.log();
    map_ = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched());
    setup.service<GetMap>("~/map", [this](const GetMap::Request&, const Tick&) {
      GetMap::Response response;
      response.map(message());
      return response;
    });
    setup.service<LoadMap>(
        "~/load_map",
        [this](const LoadMap::Request& request, const Tick& tick) { return load(request.map_url(), tick); },
        [](const std::string&) { return response_of(MapFault::other); },
        ServiceScope::node);  // as Nav2's: a map may be changed before it is shown
    setup.service<DrawPolygon>(
        "~/draw_polygon",
        [this](const DrawPolygon::Request& request, const Tick& tick) { return draw(request, tick); },
        refusal_to_draw);
  }

  void activate(const Tick& tick) override {
    since_ = tick.now;
    map_.publish(message());
  }

 private:
  /// A map that cannot be used changes nothing.
  LoadMap::Response load(const std::string& url, const Tick& tick) {
    const auto file = path_of_url(url);
    MapReading reading{.fault = MapFault::no_file, .reason = "'" + url + "' is no path and no file:// URL"};
    if (file) reading = try_load_map(*file);
    if (reading.fault != MapFault::none) {
      log_.error("the map stays as it is: {}", reading.reason);
      return response_of(reading.fault);
    }
    grid_ = std::move(reading.grid);
    since_ = tick.now;
    log_.info("map {}: {} x {} cells of {} m", file->string(), grid_.width, grid_.height, grid_.resolution);
    LoadMap::Response response = response_of(MapFault::none);
    response.map(message());
    map_.publish(response.map());
    return response;
  }

  DrawPolygon::Response draw(const DrawPolygon::Request& request, const Tick& tick) {
    std::vector<Vector2> corners;
    for (const auto& corner : request.polygon().polygon().points())
      corners.emplace_back(corner.x(), corner.y());
    std::string fault = fault_of(request, frame_);
    if (fault.empty() && !grow_to_hold(grid_, corners, static_cast<double>(kMaxMapCells)))
      fault = "the polygon reaches too far: the map would have more than " + std::to_string(kMaxMapCells) +
              " cells";
    if (!fault.empty()) {
      log_.error("nothing is drawn: {}", fault);
      return refusal_to_draw(fault);
    }
    draw_polygon(grid_, corners, request.value());
    since_ = tick.now;
    map_.publish(message());
    DrawPolygon::Response response;
    response.success(true);
    return response;
  }

  nav_msgs::msg::OccupancyGrid message() const { return to_message(grid_, frame_, since_); }

  OccupancyGrid grid_;
  Time since_;  ///< when it became the map
  std::string frame_;
  Logger log_;
  Output<nav_msgs::msg::OccupancyGrid> map_;
};

BW_COMPONENT(MapServerComponent, "map_server")

}  // namespace bw
