#include "components/slam/files/slam_settings.hpp"

#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/parameters.hpp"

namespace bw::slam {

SlamOptions slam_options_of(const std::vector<std::string>& settings) {
  ConfigNode root;
  for (const std::string& text : settings) {
    const Override change = parse_override(text);
    apply_override(root, change, change.path.size() > 1 && change.path.front() == "slam" ? 1 : 0);
  }
  return read_parameters<SlamOptions>(root, "slam");
}

}  // namespace bw::slam
