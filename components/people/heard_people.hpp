// People whom somebody else sees, as people_msgs/People tells them: a name, a position and a velocity. They
// become people with ids and with covariances that nobody told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "components/model/tracked_person.hpp"
#include "components/people/heard_person.hpp"
#include "runtime/base/field.hpp"

namespace bw::people {

struct HeardPeopleOptions {
  double radius = 0.3;
  /// [m] standard deviation of the positions, along each axis (set by code alone)
  double position_deviation = 0.1;
  /// [m/s] standard deviation of the velocities, along each axis (set by code alone)
  double velocity_deviation = 0.2;
  double min_reliability = 0.0;
  /// of people with reliability 0, as of a detector that tells none
  static constexpr double kUntoldReliability = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("radius", radius, {.unit = "m", .min = 0.05, .max = 2, .doc = "of everybody"});
    v("min_reliability", min_reliability, {.min = 0, .max = 1, .doc = "who is less sure is not there"});
    v.retired({"position_deviation", "velocity_deviation", "untold_reliability"},
              "a constant of heard_people.hpp");
  }
};

class HeardPeople {
 public:
  /// All in one frame, at `stamp`. Who is not finite is left out. An id stays one name's as long as each
  /// message has it; among equal names it is their order that tells.
  std::vector<TrackedPerson> take(const std::vector<HeardPerson>& people, Time stamp,
                                  const HeardPeopleOptions& options);

 private:
  std::map<std::pair<std::string, std::size_t>, std::uint32_t> ids_;  ///< by name and count of that name
  std::uint32_t last_id_ = 0;
};

}  // namespace bw::people
