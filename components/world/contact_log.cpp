#include "components/world/contact_log.hpp"

#include <algorithm>
#include <utility>

#include "components/model/rim_gap.hpp"

namespace bw {

void ContactLog::step(Duration now, const Footprint& footprint, const Pose2& pose, double speed_before,
                      bool held_by_wall, double wall_gap, const std::vector<Person>& others) {
  if (held_by_wall && !touching_wall_) contacts_.push_back({now, ContactKind::wall, 0, speed_before});
  touching_wall_ = held_by_wall || (touching_wall_ && wall_gap < kApart);

  std::set<std::uint32_t> touched;
  for (const Person& other : others) {
    const double gap = rim_gap(footprint, pose, other.position, other.radius);
    const ContactKind kind = other.id < kFirstRobotId ? ContactKind::person : ContactKind::robot;
    const bool was_touched = touched_.count(other.id) > 0;
    if (gap < 0.0 && !was_touched) contacts_.push_back({now, kind, other.id, speed_before});
    if (gap < 0.0 || (was_touched && gap < kApart)) touched.insert(other.id);
  }
  touched_ = std::move(touched);
}

int ContactLog::count(ContactKind kind) const {
  return static_cast<int>(std::count_if(contacts_.begin(), contacts_.end(),
                                        [&](const Contact& contact) { return contact.kind == kind; }));
}

}  // namespace bw
