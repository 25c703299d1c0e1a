// An output of a running graph as a topic of a bag.
#pragma once

#include "runtime/host/actor.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw::bag {

[[nodiscard]] BagTopic topic_of(const OutputEnd& output);

}  // namespace bw::bag
