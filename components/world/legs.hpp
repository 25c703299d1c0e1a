// The two legs a laser near the floor sees of a person: discs that swing against each other as the person
// walks, and, if asked for, sway and take small steps while they stand.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/model/random.hpp"
#include "components/world/person.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct LegOptions {
  /// [m] radius of one leg (set by code alone)
  double radius = 0.07;
  /// [m] sideways distance between the centres of the legs (set by code alone)
  double separation = 0.24;
  /// [m] distance walked in two steps: one period of the swing (set by code alone)
  double stride = 1.4;
  /// [m] reach of a leg to the front and to the back at full swing (set by code alone)
  double swing = 0.18;
  /// [m/s] below this speed the swing shrinks in proportion (set by code alone)
  double full_swing_speed = 1.3;
  /// [m] standard deviation of the wandering of a leg of who stands; 0: like a statue (set by code alone)
  double sway = 0.0;
  /// [s] who stands sets a foot 0.05 to 0.15 m aside after so long on average; 0: never (set by code alone)
  double shift_every = 0.0;
};

/// Remembers how far everybody has walked, which way those who stand were facing, and where they have set
/// their feet since. The same people and times give the same legs.
class Legs {
 public:
  explicit Legs(const LegOptions& options) : options_(options) {}

  void step(double dt, const std::vector<Person>& people);

  /// Left leg, then right leg of each person, in map.
  std::vector<Disc> discs(const std::vector<Person>& people) const;

 private:
  struct Foot {
    Vector2 from{0.0, 0.0};    ///< where it was set before, beside where it belongs [m]
    Vector2 to{0.0, 0.0};      ///< and where it is now, or on its way to
    Vector2 wander{0.0, 0.0};  ///< of the leg above it [m]
  };
  struct Gait {
    double walked = 0.0;  ///< [m]
    Vector2 facing{1.0, 0.0};
    std::optional<Random> random;  ///< of who sways or shifts
    std::array<Foot, 2> feet;
    double step = 1.0;        ///< share of the last step that is done
    double until_next = 0.0;  ///< step [s]; 0: not standing
  };

  void stand(double dt, std::uint32_t id, Gait& gait) const;
  void set_foot(Gait& gait) const;
  static void come_home(double dt, Foot& foot);

  LegOptions options_;
  std::map<std::uint32_t, Gait> gaits_;
};

}  // namespace bw
