// Adaptor: the newest map of a topic into a file, all of it or a part.
#include <cmath>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <bandwagon_msgs/srv/save_map_part.hpp>
#include <fmt/format.h>
#include <nav2_msgs/srv/save_map.hpp>

#include "components/files/map_file.hpp"
#include "components/files/map_image.hpp"
#include "components/mapping/map_part.hpp"
#include "components/messages/map_input.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using bandwagon_msgs::srv::SaveMapPart;
using nav2_msgs::srv::SaveMap;

struct MapSaverOptions {
  std::vector<std::string> topics = {"map"};
  double free_thresh_default = 0.25;
  double occupied_thresh_default = 0.65;
  std::string folder = "run/maps";
  bool overwrite = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("topics", topics,
      {.doc = "topics with occupancy grids that can be saved; the first where a request names none"});
    v("free_thresh_default", free_thresh_default,
      {.min = 0.01, .max = 0.98, .doc = "cells up to this share are saved as free where a request has 0"});
    v("occupied_thresh_default", occupied_thresh_default,
      {.min = 0.02,
       .max = 0.99,
       .doc = "cells from this share on are saved as occupied where a request has 0"});
    v("folder", folder,
      {.path = true,
       .doc = "where maps are saved, and nowhere else; the default is below the working directory"});
    v("overwrite", overwrite, {.doc = "a map takes the place of one with its name"});
  }

  std::optional<std::string> violated_rule() const {
    if (topics.empty()) return "topics must name one";
    if (folder.empty()) return "folder must name one";
    return fault_of(
        MapShades{.free_thresh = free_thresh_default, .occupied_thresh = occupied_thresh_default});
  }
};

template <ChoiceField Enum>
Enum chosen(const std::string& key, const std::string& text, Enum usual) {
  if (text.empty()) return usual;
  if (const auto value = choice_of<Enum>(text)) return *value;
  throw std::runtime_error(
      fmt::format("{} '{}' is none of {}", key, text, fmt::join(choice_texts<Enum>(), ", ")));
}

/// The message carries a float; a decimal such as 0.65 is meant, not the float nearest to it.
double threshold(float asked, double usual) {
  return asked == 0.0F ? usual : std::round(static_cast<double>(asked) * 1e6) / 1e6;
}

}  // namespace

class MapSaverComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    options_ = setup.parameters<MapSaverOptions>();
    setup.longest_callback(Duration::milliseconds(10'000));  // files
    log_ = setup.log();
    const std::filesystem::path folder = setup.file_parameter("folder");
    folder_ = std::filesystem::absolute(folder.empty() ? std::filesystem::path(options_.folder) : folder);
    for (const std::string& topic : options_.topics)
      maps_[topic] = listen_to_map(setup, {}, Need::required, topic);
    setup.service<SaveMap>(
        "~/save_map",
        [this](const SaveMap::Request& request, const Tick&) {
          SaveMap::Response response;
          try {
            log_.info("saved {}", save(request));
            response.result(true);
          } catch (const std::exception& fault) {
            log_.error("no map is saved: {}", fault.what());
          }
          return response;
        },
        [](const std::string&) { return SaveMap::Response(); });
    const auto refuse = [](const std::string& why) {
      SaveMapPart::Response response;
      response.message(why);
      return response;
    };
    setup.service<SaveMapPart>(
        "~/save_map_part",
        [this, refuse](const SaveMapPart::Request& request, const Tick&) {
          try {
            log_.info("saved {}", save_part(request));
          } catch (const std::exception& fault) {
            log_.error("no map is saved: {}", fault.what());
            return refuse(fault.what());
          }
          SaveMapPart::Response response;
          response.success(true);
          return response;
        },
        refuse);
  }

 private:
  // These return the file's name, and throw what is told to people.

  std::string save_part(const SaveMapPart::Request& request) const {
    const MapPart part{{request.corner().x(), request.corner().y(), request.corner().theta()},
                       request.length(),
                       request.width()};
    SaveMap::Request file;
    file.map_url(request.map_url());
    return write(part_of(newest(request.map_topic()), part, static_cast<double>(kMaxMapCells)), file);
  }

  std::string save(const SaveMap::Request& request) const {
    return write(newest(request.map_topic()), request);
  }

  std::string write(const OccupancyGrid& grid, const SaveMap::Request& request) const {
    const auto url = path_of_url(request.map_url());
    if (!url) throw std::runtime_error("'" + request.map_url() + "' is no path and no file:// URL");
    std::filesystem::create_directories(folder_);
    const std::filesystem::path yaml = path_of_map(folder_, *url);
    const MapShades shades{
        .mode = chosen("map_mode", request.map_mode(), MapMode::trinary),
        .free_thresh = threshold(request.free_thresh(), options_.free_thresh_default),
        .occupied_thresh = threshold(request.occupied_thresh(), options_.occupied_thresh_default)};
    const ImageFormat usual = shades.mode == MapMode::scale ? ImageFormat::png : ImageFormat::pgm;
    save_map(grid, yaml, shades, chosen("image_format", request.image_format(), usual),
             options_.overwrite ? Existing::replace : Existing::refuse);
    return yaml.string();
  }

  const OccupancyGrid& newest(const std::string& topic) const {
    for (const auto& [name, map] : maps_) {
      if (name != (topic.empty() ? options_.topics.front() : topic) && "/" + name != topic) continue;
      if (map->frame.empty()) throw std::runtime_error("no map came on " + name + " yet");
      return map->grid;
    }
    throw std::runtime_error(fmt::format("'{}' is none of the topics in the parameter `topics` ({})", topic,
                                         fmt::join(options_.topics, ", ")));
  }

  MapSaverOptions options_;
  std::filesystem::path folder_;
  Logger log_;
  std::map<std::string, std::shared_ptr<const KnownMap>> maps_;
};

BW_COMPONENT(MapSaverComponent, "map_saver")

}  // namespace bw
