#include "components/lab/bench/scene_drive.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/planner_alone.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/progress_checker.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kHorizon = 6.0;  // [s] of a roll-out
constexpr int kRollOutSteps = 4;  // between two predicted positions
constexpr double kJudgedAfter =
    6.0;  // [s] for which the others go on after a contact: more than a search's 5 s

// What the base does in kSceneStep.
TwistChange change_of(const Limits& limits) {
  return {limits.acc_max * kSceneStep, limits.stop_deceleration * kSceneStep, limits.alpha_max * kSceneStep};
}

class Drive {
 public:
  Drive(const DriveScene& scene, ScenePrediction prediction, LocalPlanner& planner, const CpuClock& clock)
      : scene_(scene),
        prediction_(prediction),
        movers_(scene.movers->clone()),
        base_(scene.start, scene.robot_radius, scene.limits, kSceneStep, change_of(scene.limits), planner,
              clock) {
    keep();
  }

  SceneDrive run() {
    SceneDrive drive;
    drive.name = scene_.name;
    while (!drive.passed && time() < scene_.timeout - 1e-9) {
      const PlanningResult result = base_.plan(problem_now());
      drive.infeasible += result.status == PlanningStatus::infeasible ? 1 : 0;
      states_.push_back({time(), base_.pose(), base_.twist()});
      step(drive);
      const bool gets_on = progress_.update(Time::seconds(time()), base_.pose(), {.time = kBlockedTime});
      drive.passed = scene_.is_done(base_.pose()) || (scene_.is_blocked && !gets_on);
    }
    drive.duration = time();
    drive.rms_jerk = base_.rms_jerk();
    drive.ms = base_.ms();
    drive.wall = scene_.walls_count && drive.min_wall < 0.0;
    drive.contacts += drive.wall ? 1 : 0;
    for (const ContactRecord& contact : diary_.contacts())
      if (contact.begins_mid_floor) ++drive.sudden_contacts;
    drive.judged = judged();
    return drive;
  }

 private:
  double time() const { return steps_ * kSceneStep; }
  Vector2 at() const { return base_.pose().position(); }

  PlanningProblem problem_now() const {
    PlanningProblem problem = base_.problem(time(), scene_.path(base_.pose()));
    problem.goal_is_final = scene_.goal_is_final;
    problem.command_lead = kSceneStep;
    problem.obstacles = scene_.walls;
    for (const SceneDisc& disc : movers_->discs())
      add_mover(problem, disc.id + 1, disc.position, disc.velocity, disc.radius);
    if (prediction_ == ScenePrediction::roll_out) roll_out(problem);
    return problem;
  }

  void roll_out(PlanningProblem& problem) const {
    const std::unique_ptr<SceneMovers> ahead = movers_->clone();
    const SceneRobot standing{scene_.start.position(), {0.0, 0.0}};
    const int count = static_cast<int>(std::lround(kHorizon / kSceneStep)) / kRollOutSteps;
    for (int step = 1; step <= count; ++step) {
      for (int k = 0; k < kRollOutSteps; ++k) ahead->step(standing);
      for (std::size_t i = 0; i < problem.movers.size(); ++i)
        problem.movers[i].predictions.push_back(
            {.time = step * kRollOutSteps * kSceneStep, .position = ahead->discs()[i].position});
    }
  }

  void step(SceneDrive& drive) {
    const std::vector<SceneDisc> before = movers_->discs();
    const Vector2 from = at();
    movers_->step({from, base_.velocity()});
    base_.move(kSceneStep);
    const Vector2 way = at() - from;
    const bool counts = time() >= scene_.unscored;
    for (std::size_t i = 0; counts && i < before.size(); ++i) {
      const SceneDisc& after = movers_->discs()[i];
      if (after.id != before[i].id) continue;
      const Vector2 walked = after.position - before[i].position;
      const double distance =
          closest_approach(before[i].position - from, (walked - way) / kSceneStep, kSceneStep);
      drive.min_gap = std::min(drive.min_gap, distance - scene_.robot_radius - after.radius);
    }
    drive.path += way.norm();
    ++steps_;
    keep();
    for (const Segment& wall : scene_.walls.segments)
      drive.min_wall =
          std::min(drive.min_wall, (nearest_point(wall, at()) - at()).norm() - scene_.robot_radius);
    if (!counts) return;
    TruthSample sample;
    sample.time = Time::seconds(time());
    sample.X_MB = base_.pose();
    sample.twist = base_.twist();
    for (const SceneDisc& disc : movers_->discs())
      sample.people.push_back({disc.id + 1, disc.position, disc.velocity, disc.radius});
    diary_.add(time(), sample, {.radius = scene_.robot_radius, .polygon = {}});
    // One between two samples is one all the same.
    drive.contacts = std::max(static_cast<int>(diary_.contacts().size()), drive.min_gap < 0.0 ? 1 : 0);
  }

  void keep() {
    for (const SceneDisc& disc : movers_->discs()) {
      possible::Walk& walk = walks_[disc.id];
      walk.radius = disc.radius;
      walk.positions.push_back({time(), disc.position});
    }
  }

  // The others go on as they would around the robot where it is.
  std::vector<JudgedContact> judged() {
    const std::vector<ContactRecord> contacts = diary_.contacts();
    if (contacts.empty()) return {};
    while (time() < contacts.back().time + kJudgedAfter) {
      movers_->step({at(), {0.0, 0.0}});
      ++steps_;
      keep();
    }
    possible::SearchScene searched;
    searched.outer_radius = searched.inner_radius = scene_.robot_radius;
    searched.shapes = scene_.walls;
    for (const auto& [id, walk] : walks_) searched.walks.push_back(walk);
    return judge_contacts(contacts, searched, states_, time(), scene_.limits);
  }

  const DriveScene& scene_;
  ScenePrediction prediction_;
  std::unique_ptr<SceneMovers> movers_;
  PlannedBase base_;
  int steps_ = 0;
  ProgressChecker progress_;
  ContactDiary diary_;
  std::vector<possible::MotionState> states_;
  std::map<std::uint32_t, possible::Walk> walks_;
};

const char* outcome_of(const SceneDrive& drive) {
  if (!drive.passed) return "timeout";
  if (drive.wall) return "wall";
  return drive.contacts > 0 ? "contact" : "passed";
}

}  // namespace

const char* to_text(ScenePrediction prediction) {
  return prediction == ScenePrediction::roll_out ? "roll_out" : "constant_velocity";
}

SceneDrive drive_scene(const DriveScene& scene, ScenePrediction prediction, LocalPlanner& planner,
                       const CpuClock& clock) {
  return Drive(scene, prediction, planner, clock).run();
}

std::vector<RatedDrive> rated(const std::vector<SceneDrive>& drives) {
  std::vector<RatedDrive> all;
  for (const SceneDrive& d : drives)
    all.push_back({.name = d.name,
                   .outcome = outcome_of(d),
                   .success = d.success(),
                   .is_late = !d.passed && d.contacts == 0,
                   .is_excused = d.passed && is_excused(d.judged, d.contacts),
                   .contacts = d.judged,
                   .rms_jerk = d.rms_jerk,
                   .ms = d.ms});
  return all;
}

Json to_json(const std::vector<SceneDrive>& drives) {
  Json rows = Json::array();
  const std::vector<RatedDrive> rates = rated(drives);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const SceneDrive& d = drives[i];
    rows.push_back(to_json(rates[i]));
    rows.back().update(Json{{"success", d.success()},
                            {"passed", d.passed},
                            {"time_s", d.duration},
                            {"path_m", d.path},
                            {"infeasible_cycles", d.infeasible},
                            {"contacts_counted", d.contacts},
                            {"wall", d.wall},
                            {"sudden_contacts", d.sudden_contacts},
                            {"min_gap_m", d.min_gap},
                            {"min_wall_m", d.min_wall}});
  }
  return rows;
}

std::string in_a_line(const SceneDrive& d) {
  return fmt::format("{:<24} {:<8} {:6.2f} s  contacts {} (sudden {})  gap {:6.3f}  {:5.2f} ms mean\n",
                     d.name, outcome_of(d), d.duration, d.contacts, d.sudden_contacts, d.min_gap, mean(d.ms));
}

}  // namespace bw
