// People whom another detector sees (a camera, mostly), whole and in one frame that does not jump (odom, O).
#pragma once

#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::people {

struct HeardPerson {
  std::string name;            ///< may be empty, and several may have the same
  Vector2 position{0.0, 0.0};  ///< in O [m]
  Vector2 velocity{0.0, 0.0};  ///< [m/s]; zero: standing, or not told
  double reliability = 1.0;    ///< 0 to 1
};

/// All whom one message tells of.
struct HeardSet {
  Time time;  ///< at which they were there
  std::vector<HeardPerson> people;
};

}  // namespace bw::people
