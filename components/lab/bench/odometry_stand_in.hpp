// Odometry for a bag without: from the transforms of the robot's base in odom, or of a robot that stands.
#pragma once

#include <memory>

#include "components/lab/bench/people_bag.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Publishes nav_msgs/Odometry on `topics.odom`; not for OdometrySource::topic.
std::unique_ptr<Component> make_odometry_stand_in(const PeopleTopics& topics);

}  // namespace bw
