#include "components/lab/experiments/navigation_report.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

double figure(const nlohmann::json& card, const char* key) {
  const auto found = card.find(key);
  return found != card.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string name_of(std::size_t pair) {
  const NavigationPair& p = navigation_pairs().at(pair);
  std::string planner = p.planner;
  std::ranges::transform(planner, planner.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return p.robot + ", " + planner + (p.as_published ? " as published" : "");
}

NavigationRow row_of(std::size_t pair, const std::string& hallway,
                     const std::vector<NavigationDrive>& drives) {
  NavigationRow row{.pair = pair, .hallway = hallway};
  std::vector<double> times, lengths, persons, indices, localization;
  for (const NavigationDrive& drive : drives) {
    if (drive.pair != pair || drive.hallway != hallway) continue;
    ++row.drives;
    row.reached += drive.reached ? 1 : 0;
    row.successes += drive.succeeded() ? 1 : 0;
    row.contacts += drive.contacts;
    row.contacts_at_speed += drive.contacts_at_speed;
    persons.push_back(drive.closest_person);
    indices.push_back(drive.max_collision_index);
    localization.push_back(drive.localization_rms);
    if (!drive.reached) continue;
    times.push_back(drive.time);
    lengths.push_back(drive.path_length);
  }
  row.time = spread_of(times);
  row.path_length = spread_of(lengths);
  row.closest_person = spread_of(persons);
  row.max_collision_index = spread_of(indices);
  row.localization_rms = spread_of(localization);
  return row;
}

Json drive_json(const NavigationDrive& drive) {
  const NavigationPair& pair = navigation_pairs().at(drive.pair);
  Json json = {{"robot", pair.robot},
               {"planner", pair.planner},
               {"as_published", pair.as_published},
               {"hallway", drive.hallway},
               {"seed", drive.seed},
               {"success", drive.succeeded()},
               {"reached", drive.reached},
               {"reason", drive.reason},
               {"contacts", drive.contacts},
               {"contacts_at_speed", drive.contacts_at_speed},
               {"time_s", drive.time},
               {"path_length_m", drive.path_length},
               {"closest_person_m", drive.closest_person},
               {"max_collision_index", drive.max_collision_index},
               {"localization_rms_m", drive.localization_rms}};
  if (!drive.page.empty()) json["page"] = drive.page;
  return json;
}

}  // namespace

const std::vector<NavigationPair>& navigation_pairs() {
  static const std::vector<NavigationPair> kPairs = {
      {"Eddie", "eddie", "edwa", "Figure 3.5", "reached, without contact (four runs, pictures)"},
      {"Eddie", "eddie", "edwa", "Figure 3.5", "reached, without contact (four runs, pictures)", true},
      {"Eddie", "eddie", "eteb", "-", "not driven there"},
      {"QBot 2e", "qbot2e", "eteb", "Section 3.4", "reached, without contact (a video)"},
      {"QBot 2e", "qbot2e", "pteb", "-", "not driven there"},
  };
  return kPairs;
}

NavigationDrive navigation_drive(std::size_t pair, const std::string& hallway, std::int64_t seed,
                                 const nlohmann::json& card) {
  NavigationDrive drive{.pair = pair, .hallway = hallway, .seed = seed};
  drive.reached = card.value("reached", false);
  drive.reason = card.value("reason", "");
  drive.contacts = static_cast<int>(figure(card, "collisions"));
  drive.contacts_at_speed = static_cast<int>(figure(card, "collisions_at_speed"));
  drive.time = figure(card, "time_to_goal_s");
  drive.path_length = figure(card, "path_length_m");
  drive.closest_person = figure(card, "closest_person_m");
  drive.max_collision_index = figure(card, "max_collision_index");
  const auto localization = card.find("localization");
  if (localization != card.end() && localization->is_object())
    drive.localization_rms = figure(*localization, "rms_m");
  return drive;
}

std::vector<NavigationRow> navigation_rows(const NavigationResults& results) {
  std::vector<NavigationRow> rows;
  for (const char* hallway : {"light", "full"}) {
    for (std::size_t pair = 0; pair < navigation_pairs().size(); ++pair) {
      rows.push_back(row_of(pair, hallway, results.drives));
      if (rows.back().drives == 0) rows.pop_back();
    }
  }
  return rows;
}

std::vector<Criterion> navigation_criteria(const NavigationResults& results, const std::string& hallway) {
  std::vector<Criterion> criteria;
  for (const NavigationRow& row : navigation_rows(results)) {
    if (row.hallway != hallway || navigation_pairs()[row.pair].as_published) continue;
    criteria.push_back({fmt::format("{}, {} hallway: drives that reach the goal without a contact",
                                    name_of(row.pair), hallway),
                        fmt::format("{} of {}", row.drives, row.drives), static_cast<double>(row.successes),
                        row.successes == row.drives});
  }
  return criteria;
}

std::vector<PublishedValue> published_values(const NavigationResults& results) {
  std::vector<PublishedValue> values;
  for (const NavigationRow& row : navigation_rows(results)) {
    const NavigationPair& pair = navigation_pairs()[row.pair];
    if (row.hallway != kNavigationHallway || pair.as_published) continue;
    values.push_back({pair.source,
                      name_of(row.pair) + ": share of drives that reach the goal without a contact", "",
                      pair.published, share_of(row.successes, row.drives)});
    const NavigationRow full = row_of(row.pair, "full", results.drives);
    if (full.drives > 0)
      values.back().others.push_back({"six people instead of three", share_of(full.successes, full.drives)});
    for (std::size_t i = 0; i < navigation_pairs().size(); ++i) {
      const NavigationPair& other = navigation_pairs()[i];
      if (!other.as_published || other.robot != pair.robot || other.planner != pair.planner) continue;
      const NavigationRow literal = row_of(i, kNavigationHallway, results.drives);
      if (literal.drives > 0)
        values.back().others.push_back(
            {"the planner as published", share_of(literal.successes, literal.drives)});
    }
  }
  return values;
}

nlohmann::ordered_json navigation_json(const NavigationResults& results) {
  Json rows = Json::array();
  for (const NavigationRow& row : navigation_rows(results)) {
    const NavigationPair& pair = navigation_pairs()[row.pair];
    rows.push_back({{"robot", pair.robot},
                    {"planner", pair.planner},
                    {"as_published", pair.as_published},
                    {"hallway", row.hallway},
                    {"drives", row.drives},
                    {"successes", row.successes},
                    {"reached", row.reached},
                    {"contacts", row.contacts},
                    {"contacts_at_speed", row.contacts_at_speed},
                    {"time_s", spread_json(row.time)},
                    {"path_length_m", spread_json(row.path_length)},
                    {"closest_person_m", spread_json(row.closest_person)},
                    {"max_collision_index", spread_json(row.max_collision_index)},
                    {"localization_rms_m", spread_json(row.localization_rms)}});
  }
  Json drives = Json::array();
  for (const NavigationDrive& drive : results.drives) drives.push_back(drive_json(drive));
  return {{"experiment", "navigation"},
          {"emulated", results.emulated},
          {"success_means", kSuccessMeans},
          {"rows", std::move(rows)},
          {"drives", std::move(drives)}};
}

std::string navigation_table(const NavigationResults& results) {
  std::string out = fmt::format("{:<24} {:<8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n",
                                "robot, planner", "hallway", "success", "reached", "contacts", "at speed",
                                "time s", "person m", "CI", "pose m");
  for (const NavigationRow& row : navigation_rows(results)) {
    out += fmt::format("{:<24} {:<8} {:>9} {:>9} {:>9} {:>9} {:>9.1f} {:>9.2f} {:>9.2f} {:>9.3f}\n",
                       name_of(row.pair), row.hallway, fmt::format("{} of {}", row.successes, row.drives),
                       row.reached, row.contacts, row.contacts_at_speed, row.time.mean,
                       row.closest_person.mean, row.max_collision_index.mean, row.localization_rms.mean);
  }
  return out;
}

}  // namespace bw
