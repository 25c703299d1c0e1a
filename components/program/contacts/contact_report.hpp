// The contacts of drives as JSON for scripts and in words: who hit whom, and whether it could have been
// avoided (possible/theory.md 8.10).
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/judged_contact.hpp"

namespace bw {

/// [{t, person, who, at_speed, robot_closing_mps, person_closing_mps, bearing_rad, there_for_s,
/// begins_mid_floor, ends_mid_floor, verdict, saveable_until_s, lost_since_s}]. Times since the drive began;
/// `verdict` null where nothing was judged, `saveable_until_s` and `lost_since_s` null where they are not
/// known.
nlohmann::ordered_json to_json(const std::vector<JudgedContact>& contacts);

struct RobotContacts {
  std::string robot;  ///< empty: the only one, and not told
  std::vector<JudgedContact> contacts;
};

/// Puts the contacts of all on a score card, each with its `robot` where it has a name, and `possible`: false
/// when the goal was reached, and none of the contacts could have been avoided. The card has `reached` and
/// `collisions`, which are those of all together.
void add_contacts(nlohmann::json& card, const std::vector<RobotContacts>& robots);

/// Contacts of a card, each on a line of its own after `indent`; empty without any.
std::string contacts_in_words(const nlohmann::json& card, const std::string& indent);

/// A contact of that JSON in a line: "12.3 s person 4: person_behind (robot 0.10, person 0.90 m/s), avoidable
/// until 11.2 s"; "robot2 at
/// 12.3 s ..." where a robot is named.
std::string contact_in_words(const nlohmann::ordered_json& contact);

/// How many contacts were of which kind. Recordings that begin or end in mid-floor are counted under that
/// name alone.
class HitCounts {
 public:
  void add(const ContactRecord& contact);
  void add(const nlohmann::ordered_json& contact);
  void add(const HitCounts& others);
  /// {robot_closing, person_ahead, person_side, person_behind, robot_standing, mid_floor}.
  nlohmann::ordered_json to_json() const;
  /// The same in words, without those that never were; "none".
  std::string in_words() const;

 private:
  std::map<std::string, int> counts_;
};

}  // namespace bw
