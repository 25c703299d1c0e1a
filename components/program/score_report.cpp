#include "components/program/score_report.hpp"

#include <fmt/format.h>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/evaluation/success.hpp"
#include "components/messages/geometry.hpp"
#include "components/program/contacts/contact_report.hpp"
#include "components/program/score_card_json.hpp"

namespace bw {
namespace {

nlohmann::json to_json(const ScoredDrive& drive) {
  nlohmann::json json = card_json(to_message(drive.card, drive.pose_errors, make_header("map", {})));
  if (!drive.has_goal) json["has_goal"] = false;
  if (drive.pose_errors.count() == 0) json["localization"] = nullptr;
  add_contacts(json, {{"", drive.contacts}});
  if (drive.has_goal && !drive.card.is_outcome_known) json["reached"] = nullptr;
  if (drive.is_measured) return json;
  for (auto& [key, value] : json.items())
    if (value.is_number() || key == "contacts" || key == "possible") value = nullptr;
  return json;
}

/// How the goals of the drives went.
struct Tally {
  int known = 0, missed = 0, unknown = 0;
  int successes = 0, possible = 0;

  void add(const ScoredDrive& drive, const nlohmann::json& json) {
    if (!drive.has_goal) return;
    if (!drive.card.is_outcome_known) {
      ++unknown;
      return;
    }
    ++known;
    missed += drive.card.reached ? 0 : 1;
    successes += is_success(drive.card.reached, drive.card.collisions) ? 1 : 0;
    possible += json["possible"] == true ? 1 : 0;
  }
};

}  // namespace

ScoreReport report_of(const BagScore& score) {
  ScoreReport report;
  Tally tally;
  report.json = {{"judged_by", score.judged_by}, {"notes", score.notes}, {"drives", nlohmann::json::array()}};
  for (const std::string& note : score.notes) report.text += "note: " + note + "\n";
  if (score.drives.empty()) report.text += "No drive is in the bag: no goal was set.\n";
  for (const ScoredDrive& drive : score.drives) {
    const nlohmann::json& json = report.json["drives"].emplace_back(to_json(drive));
    report.text += in_words(json);
    tally.add(drive, json);
  }
  report.json["success_means"] = kSuccessMeans;
  report.json["successes"] = tally.successes;
  report.json["possible"] = tally.possible;
  report.json["unknown"] = tally.unknown;
  if (tally.possible > 0 || tally.successes > 0)
    report.text += fmt::format("{} of {} drives without a contact to the goal, {} of {} where possible.\n",
                               tally.successes, tally.known, tally.successes, tally.possible);
  if (tally.unknown > 0)
    report.text +=
        fmt::format("Not known of {} {}.\n", tally.unknown, tally.unknown == 1 ? "drive" : "drives");
  report.exit_status = tally.missed > 0 ? 1 : tally.unknown > 0 || score.drives.empty() ? 3 : 0;
  return report;
}

}  // namespace bw
