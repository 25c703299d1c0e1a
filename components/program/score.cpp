// bandwagon score BAG: how a recorded drive went.
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/model/robot.hpp"
#include "components/program/score_bag.hpp"
#include "components/program/score_report.hpp"
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
  ScoreReport report = report_of(score);
  if (options.json) {
    report.json["bag"] = options.path;
    report.json["robot_radius_m"] = robot.radius;
    if (robot.is_polygon()) report.json["robot_footprint_m"] = to_text(robot);
    std::cout << report.json.dump(2) << "\n";
  } else {
    std::cout << fmt::format("Judged by {}; robot of radius {:.2f} m ({}).\n", score.judged_by, robot.radius,
                             known_from)
              << report.text;
  }
  return report.exit_status;
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
