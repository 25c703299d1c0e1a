// The ROS 2 distributions whose bytes differ: ids of nodes up to Humble and from Iron on, nav2_msgs from each
// to the next.
#pragma once

#include <optional>
#include <string_view>

#include "runtime/base/choice.hpp"

namespace bw {

enum class RosDistro {
  automatic,  ///< as the others on the domain, jazzy where nobody is
  humble,
  jazzy,
  kilted,
  lyrical
};
constexpr auto choice_table(RosDistro) {
  using enum RosDistro;
  return choices<RosDistro>(
      {{automatic, "auto"}, {humble, "humble"}, {jazzy, "jazzy"}, {kilted, "kilted"}, {lyrical, "lyrical"}});
}

/// Of ROS_DISTRO, as ROS 2's own set-up script sets it; nothing for a name that this does not know.
constexpr std::optional<RosDistro> distro_named(std::string_view name) {
  if (name == "iron") return RosDistro::jazzy;
  if (name == "rolling") return RosDistro::lyrical;
  const std::optional<RosDistro> distro = choice_of<RosDistro>(name);
  return distro == RosDistro::automatic ? std::nullopt : distro;
}

}  // namespace bw
