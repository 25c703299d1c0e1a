#include "components/world/contact_log.hpp"

#include <algorithm>
#include <utility>

namespace bw {

void ContactLog::step(Duration now, const RobotBody& robot, double speed_before, bool held_by_wall,
                      double wall_gap, const std::vector<Person>& people) {
  if (held_by_wall && !touching_wall_) contacts_.push_back({now, ContactKind::wall, 0, speed_before});
  touching_wall_ = held_by_wall || (touching_wall_ && wall_gap < kApart);

  std::set<std::uint32_t> touched;
  for (const Person& person : people) {
    const double gap = (person.position - robot.position).norm() - robot.radius - person.radius;
    const bool was_touched = touched_people_.count(person.id) > 0;
    if (gap < 0.0 && !was_touched) contacts_.push_back({now, ContactKind::person, person.id, speed_before});
    if (gap < 0.0 || (was_touched && gap < kApart)) touched.insert(person.id);
  }
  touched_people_ = std::move(touched);
}

int ContactLog::count(ContactKind kind) const {
  return static_cast<int>(std::count_if(contacts_.begin(), contacts_.end(),
                                        [&](const Contact& contact) { return contact.kind == kind; }));
}

}  // namespace bw
