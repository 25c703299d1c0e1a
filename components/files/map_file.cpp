#include "components/files/map_file.hpp"

#include <algorithm>
#include <charconv>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "components/files/map_image.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

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

/// `stage` says what is being read, and so what is wrong when this throws.
OccupancyGrid read_map(const std::filesystem::path& yaml_path, MapFault& stage) {
  stage = MapFault::bad_metadata;
  ConfigNode root = load_yaml(yaml_path);
  const MapYaml yaml = read_map_yaml(root);
  const MapShades shades{yaml.mode, yaml.negate == 1, yaml.free_thresh, yaml.occupied_thresh};
  const ConfigNode& image_node = *root.find("image");
  stage = MapFault::bad_data;
  MapImage image;
  try {
    image = read_map_image(resolve_path(image_node.where, yaml.image),
                           [&shades](double shade) { return cell_of_shade(shades, shade); });
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

/// With %20 and the like as the characters they stand for.
std::optional<std::string> decoded(std::string_view url) {
  std::string text;
  for (std::size_t i = 0; i < url.size(); ++i) {
    if (url[i] != '%') {
      text += url[i];
      continue;
    }
    unsigned char code = 0;
    const std::string_view digits = url.substr(i + 1, 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc{} || digits.size() != 2 || end != digits.data() + 2) return std::nullopt;
    text += static_cast<char>(code);
    i += 2;
  }
  return text;
}

}  // namespace

OccupancyGrid load_map(const std::filesystem::path& yaml_path) {
  MapFault stage{};
  return read_map(yaml_path, stage);
}

MapReading try_load_map(const std::filesystem::path& yaml_path) {
  MapReading reading;
  std::error_code error;
  if (!std::filesystem::is_regular_file(yaml_path, error)) {
    reading.fault = MapFault::no_file;
    reading.reason = "there is no file " + yaml_path.string();
    return reading;
  }
  try {
    reading.grid = read_map(yaml_path, reading.fault);
    reading.fault = MapFault::none;
  } catch (const std::runtime_error& fault) {
    reading.reason = fault.what();
  } catch (const std::exception& fault) {  // no memory, say
    reading.fault = MapFault::other;
    reading.reason = yaml_path.string() + ": " + fault.what();
  }
  return reading;
}

std::optional<std::filesystem::path> path_of_url(std::string_view url) {
  constexpr std::string_view kFile = "file://";
  constexpr std::string_view kHere = "localhost";
  std::optional<std::string> path(url);
  if (url.substr(0, kFile.size()) == kFile) {
    url.remove_prefix(kFile.size());
    if (url.substr(0, kHere.size()) == kHere) url.remove_prefix(kHere.size());
    path = url.empty() || url.front() != '/' ? std::nullopt : decoded(url);
  } else if (url.find("://") != std::string_view::npos) {
    return std::nullopt;
  }
  const auto is_control = [](unsigned char c) { return c < ' '; };
  if (!path || path->empty() || std::any_of(path->begin(), path->end(), is_control)) return std::nullopt;
  return std::filesystem::path(*path);
}

}  // namespace bw
