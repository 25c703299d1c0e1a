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
      [this](const SaveMap::Request& request, const Reply<SaveMap>& reply, const Tick&) {
        if (slam_->nodes().empty()) {
          log_.error("save_map: there is no map yet");
          return reply(saved(result::RESULT_NO_MAP_RECEIEVD));
        }
        save([this, name = request.name().data(), reply] {
          return [this, name, reply, scans = placed_scans(*slam_, X_MW_), resolution = options_.resolution] {
            try {
              const std::filesystem::path file = path_of_map(folder_, name);
              save_map(render(scans, resolution), file, {}, ImageFormat::pgm,
                       parameters_.overwrite ? Existing::replace : Existing::refuse);
              log_.info("the map is saved: {}", file.string());
              reply(saved(result::RESULT_SUCCESS));
            } catch (const std::exception& error) {
              log_.error("save_map: {}", error.what());
              reply(saved(result::RESULT_UNDEFINED_FAILURE));
            }
          };
        });
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
  setup.service<GetMap>("slam_toolbox/dynamic_map", [this](const GetMap::Request&, const Reply<GetMap>& reply,
                                                           const Tick&) { map_.answer(reply, map_time_); });
}

void SlamComponent::save(std::function<std::function<void()>()> take) {
  saves_.push_back(std::move(take));
  if (is_lockstep_) finish_saves();
}

void SlamComponent::write_next() {
  is_saving_ = true;
  map_.add([this, write = saves_.front()()] {
    write();
    is_saving_ = false;
  });
  saves_.pop_front();
}

void SlamComponent::advance_saves() {
  for (int i = 0; i < kPiecesPerScan && !saves_.empty() && !is_saving_; ++i)
    if (!slam_->settle_a_piece()) write_next();
}

void SlamComponent::finish_saves() {
  while (!saves_.empty()) {
    slam_->settle();
    write_next();
  }
}

}  // namespace bw::slam
