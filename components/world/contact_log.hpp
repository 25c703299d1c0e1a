// Counts what a robot touched. A contact begins when two bodies meet, and counts once until they are
// clearly apart.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "components/model/footprint.hpp"
#include "components/world/person.hpp"
#include "runtime/base/time.hpp"

namespace bw {

enum class ContactKind { wall, person, robot };

struct Contact {
  Duration time;  ///< world time of the first touch
  ContactKind kind = ContactKind::wall;
  std::uint32_t person = 0;  ///< id, for people and robots
  double robot_speed = 0.0;  ///< ground speed at the first touch [m/s]
};

class ContactLog {
 public:
  /// Bodies this far apart [m] are no longer in contact: trembling at the edge is one contact.
  static constexpr double kApart = 0.02;

  /// `held_by_wall`: the base was stopped by a wall in this step; `wall_gap` [m]: from the robot's rim to the
  /// nearest wall; `speed_before` [m/s]: ground speed as the step began, before a wall took it; `others`:
  /// people and other robots.
  void step(Duration now, const Footprint& footprint, const Pose2& pose, double speed_before,
            bool held_by_wall, double wall_gap, const std::vector<Person>& others);

  const std::vector<Contact>& contacts() const { return contacts_; }
  int count(ContactKind kind) const;
  bool touching_wall() const { return touching_wall_; }
  bool touching_somebody() const { return !touched_.empty(); }

 private:
  std::vector<Contact> contacts_;
  bool touching_wall_ = false;
  std::set<std::uint32_t> touched_;
};

}  // namespace bw
