// Ten seconds of a robot's topics to fill bags with: what a scanner of 1081 beams, an inertial unit, wheels
// and a local costmap send, about 1 MB/s. Bytes compress as real ones do: ranges carry noise, the costmap has
// rooms and few levels.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct BagMaterial {
  struct Message {
    std::size_t topic = 0;  ///< in `topics`
    Duration at;            ///< from the beginning of the ten seconds
    bag::Bytes cdr;
  };
  std::vector<bag::BagTopic> topics;
  std::vector<Message> messages;  ///< by time
  Duration length;
};

BagMaterial make_bag_material(std::uint64_t seed);

}  // namespace bw
