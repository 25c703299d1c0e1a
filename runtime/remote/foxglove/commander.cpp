#include "runtime/remote/foxglove/commander.hpp"

#include <array>

namespace bw::foxglove {

bool only_asks(std::string_view service_type) {
  constexpr std::array<std::string_view, 14> kThatAsk = {
      "composition_interfaces/srv/ListNodes",
      "lifecycle_msgs/srv/GetAvailableStates",
      "lifecycle_msgs/srv/GetAvailableTransitions",
      "lifecycle_msgs/srv/GetState",
      "nav2_msgs/srv/GetCostmap",
      "nav2_msgs/srv/IsPathValid",
      "nav_msgs/srv/GetMap",
      "nav_msgs/srv/GetPlan",
      "rcl_interfaces/srv/DescribeParameters",
      "rcl_interfaces/srv/GetParameterTypes",
      "rcl_interfaces/srv/GetParameters",
      "rcl_interfaces/srv/ListParameters",
      "tf2_msgs/srv/FrameGraph",
      "type_description_interfaces/srv/GetTypeDescription",
  };
  for (const std::string_view type : kThatAsk) {
    if (type == service_type) return true;
  }
  return service_type.find("/action/") != std::string_view::npos && service_type.ends_with("_GetResult");
}

}  // namespace bw::foxglove
