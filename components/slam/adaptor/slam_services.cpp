// The services of slam_toolbox on the map as a grid. What they do not do is told in the log.
#include <fmt/format.h>
#include <nav_msgs/srv/get_map.hpp>
#include <slam_toolbox/srv/pause.hpp>
#include <slam_toolbox/srv/reset.hpp>
#include <slam_toolbox/srv/save_map.hpp>

#include "components/files/map_file.hpp"
#include "components/slam/adaptor/slam_component.hpp"

namespace bw::slam {
namespace {

using nav_msgs::srv::GetMap;
using slam_toolbox::srv::Pause;
using slam_toolbox::srv::Reset;
using slam_toolbox::srv::SaveMap;

SaveMap::Response saved(std::uint8_t result) {
  SaveMap::Response response;
  response.result(result);
  return response;
}

}  // namespace

void SlamComponent::offer_services(Setup& setup) {
  namespace result = slam_toolbox::srv::SaveMap_Response_Constants;
  setup.service<SaveMap>(
      "slam_toolbox/save_map",
      [this](const SaveMap::Request& request, const Tick&) {
        if (slam_->nodes().empty()) {
          log_.error("save_map: there is no map yet");
          return saved(result::RESULT_NO_MAP_RECEIEVD);
        }
        try {
          slam_->settle();
          painter_->finish(*slam_);
          const std::filesystem::path file = path_of_map(folder_, request.name().data());
          save_map(painter_->grid(), file, {}, ImageFormat::pgm,
                   parameters_.overwrite ? Existing::replace : Existing::refuse);
          log_.info("the map is saved: {}", file.string());
        } catch (const std::exception& error) {
          log_.error("save_map: {}", error.what());
          return saved(result::RESULT_UNDEFINED_FAILURE);
        }
        return saved(result::RESULT_SUCCESS);
      },
      [](const std::string&) { return saved(result::RESULT_UNDEFINED_FAILURE); });
  setup.service<Pause>(
      "slam_toolbox/pause_new_measurements",
      [this](const Pause::Request&, const Tick&) {
        paused_ = !paused_;
        waiting_.clear();
        log_.info("{}", paused_ ? "paused: scans are not used" : "scans are used again");
        Pause::Response response;
        response.status(true);
        return response;
      },
      [](const std::string&) { return Pause::Response(); });
  setup.service<Reset>(
      "slam_toolbox/reset",
      [this](const Reset::Request& request, const Tick&) {
        begin_map();
        waiting_.clear();
        paused_ = request.pause_new_measurements();
        log_.info("the map begins anew{}", paused_ ? ", paused" : "");
        return Reset::Response();
      },
      [](const std::string&) {
        Reset::Response response;
        response.result(255);
        return response;
      });
  setup.service<GetMap>("slam_toolbox/dynamic_map", [this](const GetMap::Request&, const Tick&) {
    GetMap::Response response;
    response.map(map_message(map_time_));
    return response;
  });
}

}  // namespace bw::slam
