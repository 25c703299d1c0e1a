// Actions as discovery shows them, and the layouts in which one of them speaks. nav2_msgs has other fields in
// each distribution under the same names, so the layout is what the server's type hashes say; a server that
// tells none, as in Humble, has that of a distribution.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runtime/base/ros_distro.hpp"
#include "runtime/dds/participant.hpp"
#include "runtime/ports.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::cli {

struct SeenAction {
  std::string type;                           ///< nav2_msgs/action/NavigateToPose
  std::vector<dds::Guid> servers;             ///< their writers of feedback
  std::vector<dds::Guid> clients;             ///< their readers of feedback
  std::map<std::string, std::string> hashes;  ///< of the server's types, by ROS name; those that are told
};

/// By name. Known by the topic of its feedback, as to ROS 2.
std::map<std::string, SeenAction> actions_among(const std::vector<dds::Endpoint>& endpoints);

/// The messages of one action.
struct ActionLayout {
  const TypeDescription* send_goal_request = nullptr;
  const TypeDescription* send_goal_response = nullptr;
  const TypeDescription* get_result_request = nullptr;
  const TypeDescription* get_result_response = nullptr;
  const TypeDescription* feedback = nullptr;

  ServiceType send_goal() const;
  ServiceType get_result() const;
};

/// `distro` counts where no hash is told. Throws std::runtime_error when this program does not know a type,
/// or not with that hash.
ActionLayout layout_of(const SeenAction& action, RosDistro distro);

}  // namespace bw::cli
