#include "components/lab/bench/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

namespace bw {
namespace {

constexpr std::size_t kMaxScenes = 10'000;
constexpr std::size_t kMaxObstacles = 10'000;

// A mapping of the file, with the place to name in errors.
class Section {
 public:
  Section(const std::string& file, const YAML::Node& node, std::string name,
          std::initializer_list<const char*> known)
      : file_(file), node_(node), name_(std::move(name)) {
    if (!node.IsMap()) fail(node, name_, "must be a mapping");
    for (const auto& entry : node) {
      const std::string key = entry.first.Scalar();
      if (std::find(known.begin(), known.end(), key) == known.end())
        fail(entry.first, key, "is not a known key");
    }
  }

  YAML::Node at(const char* key) const {
    const YAML::Node value = node_[key];
    if (!value.IsDefined()) fail(node_, key, "is missing");
    return value;
  }
  bool has(const char* key) const { return node_[key].IsDefined(); }

  double number(const char* key, double low, double high) const {
    const YAML::Node value = at(key);
    double result = 0.0;
    try {
      result = value.as<double>();
    } catch (const YAML::Exception&) {
      fail(value, key, "must be a number");
    }
    if (!(result >= low && result <= high)) {
      std::ostringstream rule;
      rule << "= " << result << " must be within " << low << " and " << high;
      fail(value, key, rule.str());
    }
    return result;
  }
  int count(const char* key, int low, int high) const {
    const double value = number(key, low, high);
    if (value != std::floor(value)) fail(at(key), key, "must be a whole number");
    return static_cast<int>(value);
  }
  std::string text(const char* key) const {
    const YAML::Node value = at(key);
    if (!value.IsScalar()) fail(value, key, "must be a text");
    return value.Scalar();
  }
  YAML::Node list(const char* key, std::size_t most) const {
    const YAML::Node value = at(key);
    if (!value.IsSequence()) fail(value, key, "must be a list");
    if (value.size() > most) fail(value, key, "has more than " + std::to_string(most) + " entries");
    return value;
  }

  [[noreturn]] void fail(const YAML::Node& where, const std::string& key, const std::string& rule) const {
    std::ostringstream message;
    message << file_ << ":" << where.Mark().line + 1 << ": " << key << " " << rule;
    if (key != name_) message << " (in " << name_ << ")";
    throw std::runtime_error(message.str());
  }

 private:
  const std::string& file_;
  YAML::Node node_;
  std::string name_;
};

constexpr double kFarthest = 1e4;  // [m]

Pose2 read_pose(const std::string& file, const YAML::Node& node, const char* name) {
  const Section s(file, node, name, {"x", "y", "theta"});
  return {s.number("x", -kFarthest, kFarthest), s.number("y", -kFarthest, kFarthest),
          wrap_angle(s.number("theta", -kFarthest, kFarthest))};
}

SceneObstacle read_obstacle(const std::string& file, const YAML::Node& node) {
  const Section s(file, node, "obstacle", {"x", "y", "r", "vx", "vy"});
  SceneObstacle o;
  o.position = {s.number("x", -kFarthest, kFarthest), s.number("y", -kFarthest, kFarthest)};
  o.radius = s.number("r", 0.0, 100.0);
  o.velocity = {s.number("vx", -100.0, 100.0), s.number("vy", -100.0, 100.0)};
  return o;
}

Scene read_scene(const std::string& file, const YAML::Node& node) {
  const Section s(file, node, "scene", {"name", "about", "start", "goal", "obstacles"});
  Scene scene;
  scene.name = s.text("name");
  scene.start = read_pose(file, s.at("start"), "start");
  scene.goal = read_pose(file, s.at("goal"), "goal");
  for (const YAML::Node& obstacle : s.list("obstacles", kMaxObstacles)) {
    scene.obstacles.push_back(read_obstacle(file, obstacle));
  }
  return scene;
}

void read_limits(const std::string& file, const YAML::Node& node, Limits& limits) {
  const Section s(file, node, "limits", {"v_max", "v_back_max", "omega_max", "acc_max", "alpha_max"});
  limits.v_max = s.number("v_max", 0.01, 10);
  limits.v_back_max = s.number("v_back_max", 0, 10);
  limits.omega_max = s.number("omega_max", 0.01, 20);
  limits.acc_max = s.number("acc_max", 0.01, 20);
  limits.alpha_max = s.number("alpha_max", 0.01, 50);
  limits.stop_deceleration = std::max(limits.stop_deceleration, limits.acc_max);
}

SceneWeights read_weights(const std::string& file, const YAML::Node& node) {
  const Section s(file, node, "weights",
                  {"max_vel_x", "max_vel_theta", "acc_lim_x", "acc_lim_theta", "kinematics_nh",
                   "forward_drive", "time", "shortest_path", "obstacle", "inflation", "dynamic_obstacle",
                   "dynamic_inflation", "adapt_factor", "penalty_epsilon"});
  const auto weight = [&](const char* key) { return s.number(key, 0.0, 1e6); };
  SceneWeights w;
  w.max_vel_x = weight("max_vel_x");
  w.max_vel_theta = weight("max_vel_theta");
  w.acc_lim_x = weight("acc_lim_x");
  w.acc_lim_theta = weight("acc_lim_theta");
  w.kinematics_nh = weight("kinematics_nh");
  w.forward_drive = weight("forward_drive");
  w.time = weight("time");
  w.obstacle = weight("obstacle");
  w.inflation = weight("inflation");
  w.dynamic_obstacle = weight("dynamic_obstacle");
  w.dynamic_inflation = weight("dynamic_inflation");
  w.penalty_epsilon = s.number("penalty_epsilon", 0.0, 1.0);
  return w;
}

SceneBox read_box(const std::string& file, const YAML::Node& node) {
  const Section s(file, node, "box", {"x_min", "x_max", "y_min", "y_max"});
  const SceneBox box{s.number("x_min", -kFarthest, kFarthest), s.number("x_max", -kFarthest, kFarthest),
                     s.number("y_min", -kFarthest, kFarthest), s.number("y_max", -kFarthest, kFarthest)};
  if (box.x_max <= box.x_min || box.y_max <= box.y_min)
    s.fail(node, "box", "must have its max above its min");
  return box;
}

SceneFile read(const std::string& path, const YAML::Node& root) {
  const Section s(
      path, root, "file",
      {"version", "replan_period", "warm_cycles", "homotopy_candidates", "control_period", "timeout",
       "goal_tolerance", "robot_radius", "box", "limits", "band", "obstacles_cfg", "weights", "scenes"});
  SceneFile file;
  s.count("version", 1, 1);
  file.replan_period = s.number("replan_period", 0.001, 10.0);
  file.warm_cycles = s.count("warm_cycles", 0, 10'000);
  read_limits(path, s.at("limits"), file.limits);
  const Section band(
      path, s.at("band"), "band",
      {"dt_ref", "dt_hysteresis", "min_samples", "max_samples", "inner_iterations", "outer_iterations"});
  file.dt_ref = band.number("dt_ref", 0.02, 2.0);
  file.dt_hysteresis = band.number("dt_hysteresis", 0.0, 2.0);
  const Section obstacles(
      path, s.at("obstacles_cfg"), "obstacles_cfg",
      {"min_dist", "inflation_dist", "dynamic_inflation_dist", "force_inclusion_factor", "cutoff_factor"});
  file.min_dist = obstacles.number("min_dist", 0.0, 10.0);
  file.inflation_dist = obstacles.number("inflation_dist", 0.0, 10.0);
  file.dynamic_inflation_dist = obstacles.number("dynamic_inflation_dist", 0.0, 10.0);
  file.weights = read_weights(path, s.at("weights"));
  if (s.has("control_period")) {
    file.closed_loop = ClosedLoop{s.number("control_period", 0.01, 1.0), s.number("timeout", 0.1, 1e4),
                                  s.number("goal_tolerance", 0.0, 10.0), s.number("robot_radius", 0.0, 10.0),
                                  read_box(path, s.at("box"))};
  }
  for (const YAML::Node& scene : s.list("scenes", kMaxScenes)) file.scenes.push_back(read_scene(path, scene));
  if (file.scenes.empty()) s.fail(root, "scenes", "must hold at least one scene");
  return file;
}

}  // namespace

std::string_view text_of(WalkersManner walkers) {
  switch (walkers) {
    case WalkersManner::social:
      return "social";
    case WalkersManner::orca:
      return "orca";
    case WalkersManner::straight:
      break;
  }
  return "straight";
}

SceneFile read_scene_file(const std::string& path) {
  try {
    return read(path, YAML::LoadFile(path));
  } catch (const YAML::BadFile&) {
    throw std::runtime_error(path + ": cannot be opened");
  } catch (const YAML::Exception& e) {
    throw std::runtime_error(path + ":" + std::to_string(e.mark.line + 1) + ": " + e.msg);
  }
}

}  // namespace bw
