#include "components/files/map_file.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "components/files/map_image.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

enum class MapMode { trinary, scale, raw };
constexpr auto choice_table(MapMode) {
  return choices<MapMode>({{MapMode::trinary, "trinary"}, {MapMode::scale, "scale"}, {MapMode::raw, "raw"}});
}

struct MapYaml {
  std::string image;
  MapMode mode = MapMode::trinary;
  double resolution = 0.0;
  std::vector<double> origin;
  int negate = 0;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;

  template <class Visitor>
  void fields(Visitor& v) {
    v("image", image, {.doc = "picture, relative to this file"});
    v("mode", mode,
      {.doc = "what a shade means: free, occupied or unknown (trinary), in proportion (scale), or its own "
              "value (raw)"});
    v("resolution", resolution, {.unit = "m", .min = 0.001, .max = 100, .doc = "edge of a cell"});
    v("origin", origin, {.min = -1e6, .max = 1e6, .doc = "lower left corner: x [m], y [m], yaw [rad]"});
    v("negate", negate, {.min = 0, .max = 1, .doc = "1: white is occupied"});
    v("occupied_thresh", occupied_thresh,
      {.min = 0, .max = 1, .doc = "a cell is occupied when its shade, 0 to 1, lies above this"});
    v("free_thresh", free_thresh,
      {.min = 0, .max = 1, .doc = "a cell is free when its shade, 0 to 1, lies below this"});
  }

  std::optional<std::string> violated_rule() const {
    if (free_thresh > occupied_thresh) return "free_thresh must not exceed occupied_thresh";
    return std::nullopt;
  }
};

MapYaml read_map_yaml(ConfigNode& root) {
  std::vector<Violation> violations;
  for (const std::string_view key : {"image", "resolution", "origin"}) {
    if (root.find(key) == nullptr) violations.push_back({root.where, std::string(key), "", "must be given"});
  }
  // Written as 0 or 1 by tradition; some editors write a truth value.
  if (ConfigNode* negate = root.find("negate"); negate != nullptr && !negate->quoted) {
    if (negate->scalar == "true") negate->scalar = "1";
    if (negate->scalar == "false") negate->scalar = "0";
  }
  MapYaml yaml;
  read_into(yaml, root, "", violations);
  if (const ConfigNode* origin = root.find("origin"); origin != nullptr && violations.empty()) {
    if (yaml.origin.size() != 3) {
      violations.push_back({origin->where, "origin", origin->text(), "must be a list of x, y and yaw"});
    } else if (yaml.origin[2] != 0.0) {
      violations.push_back({origin->sequence[2].where, "origin.2", origin->sequence[2].text(),
                            "must be 0: a map that is turned against its grid is not supported"});
    }
  }
  throw_if_any(std::move(violations));
  return yaml;
}

CellOfShade rule_of(const MapYaml& yaml) {
  return [yaml](double shade) -> std::int8_t {
    if (yaml.mode == MapMode::raw) {
      const long value = std::lround(shade * 255.0);
      return value <= 100 ? static_cast<std::int8_t>(value) : OccupancyGrid::kUnknown;
    }
    const double p = yaml.negate == 1 ? shade : 1.0 - shade;
    if (p > yaml.occupied_thresh) return OccupancyGrid::kOccupied;
    if (p < yaml.free_thresh) return OccupancyGrid::kFree;
    if (yaml.mode == MapMode::trinary) return OccupancyGrid::kUnknown;
    const double range = yaml.occupied_thresh - yaml.free_thresh;
    const double share = range > 0.0 ? (p - yaml.free_thresh) / range : 0.5;
    return static_cast<std::int8_t>(1 + std::lround(98.0 * share));
  };
}

}  // namespace

OccupancyGrid load_map(const std::filesystem::path& yaml_path) {
  ConfigNode root = load_yaml(yaml_path);
  const MapYaml yaml = read_map_yaml(root);
  const ConfigNode& image_node = *root.find("image");
  MapImage image;
  try {
    image = read_map_image(resolve_path(image_node.where, yaml.image), rule_of(yaml));
  } catch (const ConfigError& error) {
    // Both files belong in the message: the one that is wrong, and the one that names it.
    std::vector<Violation> violations = error.violations();
    violations.push_back({image_node.where, "image", yaml.image, "must name a usable picture"});
    throw ConfigError(std::move(violations));
  }
  return {.resolution = yaml.resolution,
          .origin = {yaml.origin[0], yaml.origin[1]},
          .width = image.width,
          .height = image.height,
          .cells = std::move(image.cells)};
}

}  // namespace bw
