#include "components/program/contacts/contact_report.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMidFloorName = "mid_floor";

/// To a thousandth; no zero has a sign.
double rounded(double value) { return std::round(value * 1e3) / 1e3 + 0.0; }

/// As it is written, to a hundredth: no zero has a sign.
double shown(double value) { return std::round(value * 1e2) / 1e2 + 0.0; }

Json rounded(const std::optional<double>& value) { return value ? Json(rounded(*value)) : Json(); }

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const WhoHit who : kAllWhoHit) all.emplace_back(text_of(who));
  all.emplace_back(kMidFloorName);
  return all;
}

}  // namespace

Json to_json(const std::vector<JudgedContact>& contacts) {
  Json list = Json::array();
  for (const JudgedContact& contact : contacts) {
    const ContactRecord& record = contact.record;
    list.push_back(
        {{"t", rounded(record.time)},
         {"person", record.person},
         {"who", text_of(record.closing.who)},
         {"at_speed", record.at_speed},
         {"robot_closing_mps", rounded(record.closing.robot)},
         {"person_closing_mps", rounded(record.closing.person)},
         {"bearing_rad", rounded(record.closing.bearing)},
         {"there_for_s", rounded(record.time - record.there_since)},
         {"begins_mid_floor", record.begins_mid_floor},
         {"ends_mid_floor", record.ends_mid_floor},
         {"verdict", contact.is_judged ? Json(possible::text_of(contact.verdict.avoidance)) : Json()},
         {"saveable_until_s", rounded(contact.verdict.saveable_until)},
         {"lost_since_s", rounded(contact.verdict.lost_since)}});
  }
  return list;
}

std::string contact_in_words(const Json& contact) {
  std::string text = fmt::format(
      "{:.2f} s person {}: {} (robot {:.2f}, person {:.2f} m/s)", contact["t"].get<double>(),
      contact["person"].get<std::uint32_t>(), contact["who"].get<std::string>(),
      shown(contact["robot_closing_mps"].get<double>()), shown(contact["person_closing_mps"].get<double>()));
  if (contact.contains("robot")) text = contact["robot"].get<std::string>() + " at " + text;
  if (contact["begins_mid_floor"].get<bool>())
    text += fmt::format(", there for {:.2f} s", contact["there_for_s"].get<double>());
  if (contact["ends_mid_floor"].get<bool>()) text += ", gone soon after";
  if (!contact["verdict"].is_string()) return text + ", not judged";
  text += ", " + contact["verdict"].get<std::string>();
  if (contact["saveable_until_s"].is_number())
    text += fmt::format(" until {:.1f} s", contact["saveable_until_s"].get<double>());
  if (contact["lost_since_s"].is_number())
    text += fmt::format(", lost since {:.1f} s", contact["lost_since_s"].get<double>());
  return text;
}

void add_contacts(nlohmann::json& card, const std::vector<RobotContacts>& robots) {
  card["contacts"] = nlohmann::json::array();
  std::vector<JudgedContact> all;
  for (const RobotContacts& robot : robots) {
    for (const Json& contact : to_json(robot.contacts)) {
      card["contacts"].push_back(nlohmann::json(contact));
      if (!robot.robot.empty()) card["contacts"].back()["robot"] = robot.robot;
    }
    all.insert(all.end(), robot.contacts.begin(), robot.contacts.end());
  }
  const int counted = card.value("collisions", 0);
  card["possible"] = !(card.value("reached", false) && counted > 0 && is_excused(all, counted));
}

std::string contacts_in_words(const nlohmann::json& card, const std::string& indent) {
  std::string text;
  const auto contacts = card.find("contacts");
  if (contacts == card.end() || !contacts->is_array()) return text;
  for (const nlohmann::json& contact : *contacts) text += indent + contact_in_words(Json(contact)) + "\n";
  return text;
}

void HitCounts::add(const ContactRecord& contact) {
  const bool is_apart = contact.begins_mid_floor || contact.ends_mid_floor;
  ++counts_[is_apart ? kMidFloorName : text_of(contact.closing.who)];
}

void HitCounts::add(const Json& contact) {
  const bool is_apart = contact.value("begins_mid_floor", false) || contact.value("ends_mid_floor", false);
  ++counts_[is_apart ? kMidFloorName : contact.value("who", "")];
}

void HitCounts::add(const HitCounts& others) {
  for (const auto& [name, count] : others.counts_) counts_[name] += count;
}

Json HitCounts::to_json() const {
  Json json = Json::object();
  for (const std::string& name : names()) {
    const auto found = counts_.find(name);
    json[name] = found == counts_.end() ? 0 : found->second;
  }
  return json;
}

std::string HitCounts::in_words() const {
  std::string text;
  for (const std::string& name : names()) {
    const auto found = counts_.find(name);
    if (found == counts_.end()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", found->second, name);
  }
  return text.empty() ? "none" : text;
}

}  // namespace bw
