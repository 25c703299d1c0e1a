// bandwagon score BAG: how a recorded drive went. Exit status 0 when every goal of the bag was reached, 1 when not.
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/evaluation/adaptor/truth_messages.hpp"
#include "components/evaluation/success.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/robot.hpp"
#include "components/tools/contacts/contact_report.hpp"
#include "components/tools/program/score_bag.hpp"
#include "components/tools/program/score_card_json.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

struct ScoreOptions {
  std::string path;
  double robot_radius = 0.0;
  bool json = false;
};

/// From the robot file that the bag carries.
struct RecordedRobot {
  std::optional<Footprint> footprint;
  std::optional<Limits> limits;
};

RecordedRobot recorded_robot(const bag::Bag& recording) {
  const auto file = recording.attachment("robot.yaml");
  if (!file) return {};
  const ConfigNode root =
      parse_yaml({reinterpret_cast<const char*>(file->data()), file->size()}, "robot.yaml in the bag");
  Robot robot;
  std::vector<Violation> violations;
  ParameterReader reader(root, "robot", violations);
  robot.fields(reader);  // what else is in the file need not be known here
  if (!violations.empty()) return {};
  RecordedRobot recorded;
  if (root.find("radius") != nullptr || root.find("footprint") != nullptr)
    recorded.footprint = robot.outline();
  if (root.find("limits") != nullptr) recorded.limits = robot.limits;
  return recorded;
}

nlohmann::json to_json(const ScoredDrive& drive) {
  nlohmann::json json = card_json(to_message(drive.card, drive.pose_errors, make_header("map", {})));
  if (!drive.has_goal) json["has_goal"] = false;
  if (drive.pose_errors.count() == 0) json["localization"] = nullptr;
  add_contacts(json, {{"", drive.contacts}});
  return json;
}

int score(const ScoreOptions& options) {
  const auto recording = bag::open_bag(options.path);
  Footprint robot{options.robot_radius, {}};
  std::string known_from = "given";
  const RecordedRobot recorded = recorded_robot(*recording);
  if (robot.radius == 0.0) {
    known_from = recorded.footprint ? "the bag's robot file" : "the usual one";
    robot = recorded.footprint.value_or(Robot{}.outline());
  }
  const BagScore score = score_bag(*recording, robot, recorded.limits);
  nlohmann::json json = {{"bag", options.path},
                         {"judged_by", score.judged_by},
                         {"robot_radius_m", robot.radius},
                         {"notes", score.notes},
                         {"drives", nlohmann::json::array()}};
  if (robot.is_polygon()) json["robot_footprint_m"] = to_text(robot);
  bool all_reached = !score.drives.empty();
  int successes = 0;
  int possible = 0;
  for (const ScoredDrive& drive : score.drives) {
    json["drives"].push_back(to_json(drive));
    if (drive.has_goal) {
      successes += is_success(drive.card.reached, drive.card.collisions) ? 1 : 0;
      possible += json["drives"].back()["possible"].get<bool>() ? 1 : 0;
    }
    all_reached &= drive.card.reached || !drive.has_goal;
  }
  json["success_means"] = kSuccessMeans;
  json["successes"] = successes;
  json["possible"] = possible;
  if (options.json) {
    std::cout << json.dump(2) << "\n";
    return all_reached ? 0 : 1;
  }
  std::cout << fmt::format("Judged by {}; robot of radius {:.2f} m ({}).\n", score.judged_by, robot.radius,
                           known_from);
  for (const std::string& note : score.notes) std::cout << "note: " << note << "\n";
  if (score.drives.empty()) std::cout << "No drive is in the bag: no goal was set.\n";
  for (const auto& drive : json["drives"]) std::cout << in_words(drive);
  if (possible > 0 || successes > 0)
    std::cout << fmt::format("{} of {} drives without a contact to the goal, {} of {} where possible.\n",
                             successes, score.drives.size(), successes, possible);
  return all_reached ? 0 : 1;
}

void add_score(cli::Verb verb) {
  auto options = std::make_shared<ScoreOptions>();
  verb.option("BAG", options->path, "File or folder").required();
  verb.option("--robot-radius", options->robot_radius,
              "Of the robot's disc [m]; else the bag's robot file tells")
      .positive();
  verb.flag("--json", options->json, "As JSON");
  verb.run([options] { return score(*options); });
}

}  // namespace

BW_VERB(look, "score", "Score cards of the drives in a recording", add_score)

}  // namespace bw
