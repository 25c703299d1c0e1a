// The two legs a laser near the floor sees of a person: discs that swing against each other as the person
// walks.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/world/person.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct LegOptions {
  double radius = 0.07;
  double separation = 0.24;
  double stride = 1.4;
  double swing = 0.18;
  double full_swing_speed = 1.3;

  template <class Visitor>
  void fields(Visitor& v) {
    v("radius", radius, {.unit = "m", .min = 0.01, .max = 0.3, .doc = "radius of one leg"});
    v("separation", separation,
      {.unit = "m", .min = 0, .max = 1, .doc = "sideways distance between the centres of the legs"});
    v("stride", stride,
      {.unit = "m", .min = 0.1, .max = 5, .doc = "way walked in two steps: one period of the swing"});
    v("swing", swing,
      {.unit = "m", .min = 0, .max = 1, .doc = "reach of a leg to the front and to the back at full swing"});
    v("full_swing_speed", full_swing_speed,
      {.unit = "m/s", .min = 0.1, .max = 10, .doc = "below this speed the swing shrinks in proportion"});
  }
};

/// Remembers how far everybody has walked, and which way those who stand were facing.
class Legs {
 public:
  explicit Legs(const LegOptions& options) : options_(options) {}

  void step(double dt, const std::vector<Person>& people);

  /// Left leg, then right leg of each person, in map.
  std::vector<Disc> discs(const std::vector<Person>& people) const;

 private:
  struct Gait {
    double walked = 0.0;  ///< [m]
    Vector2 facing{1.0, 0.0};
  };

  LegOptions options_;
  std::map<std::uint32_t, Gait> gaits_;
};

}  // namespace bw
