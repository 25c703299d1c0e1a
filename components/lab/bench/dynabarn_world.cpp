#include "components/lab/bench/dynabarn_world.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr double kDynaBarnWay = 20.0;     // [m]
constexpr double kDynaBarnReached = 1.0;  // [m]
constexpr double kDynaBarnTimeout = 100.0;
constexpr double kDynaBarnLookahead = 8.0;  // [m] of the path that the planner is given
const Pose2 kDynaBarnStart{11.0, 0.0, std::numbers::pi};
const Vector2 kDynaBarnGoal(kDynaBarnStart.x - kDynaBarnWay, kDynaBarnStart.y);

// Of a Jackal, at the speed that its own course is driven at.
Limits jackal_limits() {
  return {.v_max = 2.0,
          .v_back_max = 0.5,
          .omega_max = 2.0,
          .acc_max = 2.0,
          .alpha_max = 4.0,
          .jerk_max = 20.0,
          .stop_deceleration = 4.0};
}
constexpr double kDynaBarnRobotRadius = 0.335;  // [m] around 0.51 x 0.43 m

// Along straight lines between the frames.
class DynaBarnMovers final : public SceneMovers {
 public:
  DynaBarnMovers(const DynaBarnWorld& world, std::uint64_t seed) : obstacles_(world.obstacles) {
    Random random(seed);
    for (const DynaBarnObstacle& obstacle : obstacles_) {
      phases_.push_back(random.uniform(0.0, obstacle.period));
      discs_.push_back({.id = next_id_++, .radius = obstacle.radius});
    }
    place();
  }

  std::unique_ptr<SceneMovers> clone() const override { return std::make_unique<DynaBarnMovers>(*this); }
  const std::vector<SceneDisc>& discs() const override { return discs_; }

  void step(const SceneRobot&) override {
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      phases_[i] += kSceneStep;
      if (phases_[i] < obstacles_[i].period) continue;
      phases_[i] = std::fmod(phases_[i], obstacles_[i].period);
      const Vector2 jump = obstacles_[i].frames.front().position - obstacles_[i].frames.back().position;
      if (jump.norm() > obstacles_[i].radius) discs_[i].id = next_id_++;
    }
    place();
  }

 private:
  void place() {
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      const auto& frames = obstacles_[i].frames;
      const auto after = std::upper_bound(frames.begin() + 1, frames.end() - 1, phases_[i],
                                          [](double time, const auto& frame) { return time < frame.time; });
      const auto before = after - 1;
      const double lasts = after->time - before->time;
      discs_[i].velocity = (after->position - before->position) / lasts;
      discs_[i].position = before->position + (phases_[i] - before->time) * discs_[i].velocity;
    }
  }

  std::vector<DynaBarnObstacle> obstacles_;
  std::vector<double> phases_;  // [s] since each began
  std::vector<SceneDisc> discs_;
  std::uint32_t next_id_ = 0;
};

double number(std::string_view text, const std::string& where) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw std::runtime_error(fmt::format("{}: \"{}\" is no number", where, text));
  return value;
}

std::vector<std::string_view> split(std::string_view text, char by) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(by);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

DynaBarnObstacle obstacle_of(const std::string& line, const std::string& where) {
  const std::vector<std::string_view> fields = split(line, ',');
  if (fields.size() != 4) throw std::runtime_error(where + ": must be name,radius,period,frames");
  DynaBarnObstacle obstacle;
  obstacle.radius = number(fields[1], where);
  obstacle.period = number(fields[2], where);
  for (const std::string_view frame : split(fields[3], ' ')) {
    const std::vector<std::string_view> parts = split(frame, ':');
    if (parts.size() != 3) throw std::runtime_error(where + ": a frame must be t:x:y");
    const double time = number(parts[0], where);
    if (!obstacle.frames.empty() && time <= obstacle.frames.back().time)
      throw std::runtime_error(where + ": times of frames must rise");
    obstacle.frames.push_back({time, {number(parts[1], where), number(parts[2], where)}});
  }
  if (obstacle.frames.size() < 2 || obstacle.frames.front().time != 0.0 || obstacle.radius <= 0.0 ||
      std::abs(obstacle.frames.back().time - obstacle.period) > 1e-9)
    throw std::runtime_error(where + ": frames must lead from 0 to the period, and radius be above 0");
  return obstacle;
}

}  // namespace

std::vector<DynaBarnWorld> read_dynabarn(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("world_") && name.ends_with(".csv")) files.insert(entry.path());
  }
  if (files.empty()) throw std::runtime_error(folder.string() + ": holds no world (world_N.csv)");
  std::vector<DynaBarnWorld> worlds;
  for (const std::filesystem::path& file : files) {
    worlds.push_back({.name = file.stem().string(), .obstacles = {}});
    std::ifstream stream(file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (line.empty() || line.front() == '#') continue;
      worlds.back().obstacles.push_back(obstacle_of(line, fmt::format("{}:{}", file.string(), number)));
    }
  }
  return worlds;
}

std::string difficulty_of(const DynaBarnWorld& world) {
  const double n = number(std::string_view(world.name).substr(std::string_view("world_").size()), world.name);
  return n < 20.0 ? "easy" : n < 40.0 ? "medium" : "hard";
}

DriveScene dynabarn_scene(const DynaBarnWorld& world, std::uint64_t seed) {
  DriveScene scene;
  scene.name = fmt::format("{}, phases {}", world.name, seed);
  scene.start = kDynaBarnStart;
  scene.movers = std::make_shared<DynaBarnMovers>(world, seed);
  scene.limits = jackal_limits();
  scene.robot_radius = kDynaBarnRobotRadius;
  scene.timeout = kDynaBarnTimeout;
  scene.is_done = [](const Pose2& pose) {
    return (pose.position() - kDynaBarnGoal).norm() <= kDynaBarnReached;
  };
  // Straight to the goal from where it is beside the line.
  scene.path = [](const Pose2& pose) {
    const Vector2 at = pose.position();
    const double heading = std::atan2(kDynaBarnGoal.y() - at.y(), kDynaBarnGoal.x() - at.x());
    const double ahead = std::min(kDynaBarnLookahead, (kDynaBarnGoal - at).norm());
    const Vector2 end = at + ahead * direction(heading);
    return std::vector<Pose2>{{at.x(), at.y(), heading}, {end.x(), end.y(), heading}};
  };
  return scene;
}

}  // namespace bw
