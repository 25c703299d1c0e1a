// An output of a running graph as a topic of a bag.
#pragma once

#include "runtime/bag/bag.hpp"
#include "runtime/host/actor.hpp"

namespace bw::bag {

[[nodiscard]] BagTopic topic_of(const OutputEnd& output);

}  // namespace bw::bag
