#include "components/evaluation/contact_diary.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/rim_gap.hpp"

namespace bw {
void ContactDiary::add(double time, const TruthSample& sample, const Footprint& robot) {
  if (!is_sound(sample) || (last_ && time <= last_->time)) return;
  if (!began_) began_ = time;
  note_leaving(time, sample);
  Twist2 twist = sample.twist;
  if (!std::isfinite(twist.v)) {  // a truth without speed: from position to position
    const double dt = last_ ? time - last_->time : 1.0;
    twist.v = last_ ? (sample.X_MB.position() - last_->pose.position()).norm() / dt : 0.0;
  }
  // A wall takes the speed in the moment of contact, so the sample before it counts too.
  const bool is_fast = std::abs(twist.v) > kStandingSpeed || (last_ && std::abs(last_->v) > kStandingSpeed);
  for (const TruePerson& person : sample.people) {
    there_since_.emplace(person.id, time == *began_ ? 0.0 : time);
    touch(time, sample, person, twist, rim_gap(robot, sample.X_MB, person.position, person.radius), is_fast);
  }
  last_ = Look{time, sample.X_MB, twist.v};
}

void ContactDiary::note_leaving(double time, const TruthSample& sample) {
  for (auto there = there_since_.begin(); there != there_since_.end();) {
    const std::uint32_t id = there->first;
    const bool is_there = std::any_of(sample.people.begin(), sample.people.end(),
                                      [id](const TruePerson& person) { return person.id == id; });
    if (is_there) {
      ++there;
      continue;
    }
    touching_.erase(id);
    for (ContactRecord& contact : contacts_)
      if (contact.person == id && time - contact.time < kMidFloor) contact.ends_mid_floor = true;
    there = there_since_.erase(there);
  }
}

void ContactDiary::touch(double time, const TruthSample& sample, const TruePerson& person,
                         const Twist2& twist, double gap, bool is_fast) {
  const auto known = touching_.find(person.id);
  if (known == touching_.end()) {
    if (gap > 0.0) return;
    ContactRecord contact;
    contact.time = contact.end = time;
    contact.person = person.id;
    contact.at_speed = is_fast;
    contact.closing = who_hit_whom(sample.X_MB, twist, person.position, person.velocity);
    contact.there_since = there_since_[person.id];
    contact.begins_mid_floor = contact.there_since > 0.0 && time - contact.there_since < kMidFloor;
    touching_[person.id] = contacts_.size();
    contacts_.push_back(contact);
    return;
  }
  if (gap > kBodiesApart) {
    touching_.erase(known);
    return;
  }
  ContactRecord& contact = contacts_[known->second];
  contact.end = time;
  contact.at_speed = contact.at_speed || is_fast;
}

}  // namespace bw
