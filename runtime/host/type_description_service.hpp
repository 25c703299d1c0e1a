// ~/get_type_description, which every node of ROS 2 has from Iron on: what the types look like that the node
// uses.
#pragma once

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

/// Declares it. A type is asked for by its hash: that of a topic's message, of a request, response or event,
/// and, as rclcpp has them, of a whole service or action. `actor` is read when it is asked, in every state of
/// its component.
void offer_type_descriptions(Setup& setup, const Actor& actor);

}  // namespace bw
