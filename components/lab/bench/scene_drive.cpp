#include "components/lab/bench/scene_drive.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/planner_alone.hpp"
#include "components/lab/bench/unicycle.hpp"
#include "components/model/nearest_point.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kHorizon = 6.0;  // [s] of a roll-out
constexpr int kRollOutSteps = 4;  // between two predicted positions
constexpr double kJudgedAfter =
    6.0;  // [s] for which the others go on after a contact: more than a search's 5 s

// Within what the base does in kSceneStep.
Twist2 applied(const Twist2& command, const Twist2& last, const Limits& limits) {
  const double up = limits.acc_max * kSceneStep;
  const double down = limits.stop_deceleration * kSceneStep;
  const double turn = limits.alpha_max * kSceneStep;
  const double v = std::clamp(command.v, -limits.v_back_max, limits.v_max);
  const double omega = std::clamp(command.omega, -limits.omega_max, limits.omega_max);
  return {std::clamp(v, last.v - down, last.v + up), std::clamp(omega, last.omega - turn, last.omega + turn)};
}

class Drive {
 public:
  Drive(const DriveScene& scene, ScenePrediction prediction)
      : scene_(scene), prediction_(prediction), movers_(scene.movers->clone()), pose_(scene.start) {
    keep();
  }

  SceneDrive with(LocalPlanner& planner, const CpuClock& clock) {
    SceneDrive drive;
    drive.name = scene_.name;
    std::vector<double> accelerations;
    while (!drive.passed && time() < scene_.timeout - 1e-9) {
      const PlanningProblem problem = problem_now();
      const double before = clock();
      const Twist2 command = planner.plan(problem).command;
      drive.ms.push_back(clock() - before);
      const Twist2 last = twist_;
      twist_ = applied(command, last, scene_.limits);
      accelerations.push_back((twist_.v - last.v) / kSceneStep);
      states_.push_back({time(), pose_, twist_});
      step(drive);
      drive.passed = scene_.is_done(pose_);
    }
    drive.duration = time();
    drive.rms_jerk = rms_jerk(accelerations, kSceneStep);
    for (const ContactRecord& contact : diary_.contacts())
      if (contact.begins_mid_floor) ++drive.sudden_contacts;
    drive.judged = judged();
    return drive;
  }

 private:
  double time() const { return steps_ * kSceneStep; }
  SceneRobot robot() const { return {pose_.position(), twist_.v * direction(pose_.theta)}; }

  PlanningProblem problem_now() const {
    PlanningProblem problem = problem_alone(time(), pose_, twist_, scene_.path(pose_), scene_.robot_radius,
                                            scene_.limits, kSceneStep);
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
    movers_->step(robot());
    const Pose2 next = unicycle_step(pose_, twist_, kSceneStep);
    const Vector2 way = next.position() - pose_.position();
    const bool counts = time() >= scene_.unscored;
    for (std::size_t i = 0; counts && i < before.size(); ++i) {
      const SceneDisc& after = movers_->discs()[i];
      if (after.id != before[i].id) continue;
      const Vector2 walked = after.position - before[i].position;
      const double distance =
          closest_approach(before[i].position - pose_.position(), (walked - way) / kSceneStep, kSceneStep);
      drive.min_gap = std::min(drive.min_gap, distance - scene_.robot_radius - after.radius);
    }
    drive.path += way.norm();
    pose_ = next;
    ++steps_;
    keep();
    for (const Segment& wall : scene_.walls.segments)
      drive.min_wall =
          std::min(drive.min_wall,
                   (nearest_point(wall, pose_.position()) - pose_.position()).norm() - scene_.robot_radius);
    if (!counts) return;
    TruthSample sample;
    sample.time = Time::seconds(time());
    sample.X_MB = pose_;
    sample.twist = twist_;
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
      movers_->step({pose_.position(), {0.0, 0.0}});
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
  Pose2 pose_;
  Twist2 twist_;
  int steps_ = 0;
  ContactDiary diary_;
  std::vector<possible::MotionState> states_;
  std::map<std::uint32_t, possible::Walk> walks_;
};

const char* outcome_of(const SceneDrive& drive) {
  if (!drive.passed) return "timeout";
  return drive.contacts > 0 ? "contact" : "passed";
}

}  // namespace

const char* to_text(ScenePrediction prediction) {
  return prediction == ScenePrediction::roll_out ? "roll_out" : "constant_velocity";
}

SceneDrive drive_scene(const DriveScene& scene, ScenePrediction prediction, LocalPlanner& planner,
                       const CpuClock& clock) {
  return Drive(scene, prediction).with(planner, clock);
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
                            {"contacts_counted", d.contacts},
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
