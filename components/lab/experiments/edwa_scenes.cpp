#include "components/lab/experiments/edwa_scenes.hpp"

#include <array>
#include <cmath>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr std::array<std::string_view, kEdwaScenes> kNames = {"S1 head-on", "S2 crossing", "S3 two crossing",
                                                              "S4 head-on and two crossing"};
constexpr double kAcross = 0.2;  // [m] jitter of a line
constexpr double kAlong = 0.4;   // [m] jitter of a start on its line

StartAndGoal errand(const Vector2& start, const Vector2& goal) {
  const Vector2 to_goal = goal - start;
  const double theta = std::atan2(to_goal.y(), to_goal.x());
  return {{start.x(), start.y(), theta}, {goal.x(), goal.y(), theta}};
}

StartAndGoal head_on(double y, Random& random) {
  const double line = y + random.uniform(-kAcross, kAcross);
  return errand({16.0, line}, {0.0, line});
}

// Along x = `x`, from `from_y` to `to_y`.
StartAndGoal crossing(double x, double jitter_x, double from_y, double to_y, Random& random) {
  const double line = x + random.uniform(-jitter_x, jitter_x);
  return errand({line, from_y + random.uniform(-kAlong, kAlong)}, {line, to_y});
}

}  // namespace

std::string_view edwa_scene_name(int index) { return kNames.at(static_cast<std::size_t>(index)); }

EdwaScene edwa_scene(int index, std::uint64_t seed) {
  Random random(seed);
  EdwaScene scene{std::string(edwa_scene_name(index)), {errand({0.0, 0.0}, {16.0, 0.0})}};
  std::vector<StartAndGoal>& errands = scene.errands;
  switch (index) {
    case 0:
      errands.push_back(head_on(0.8, random));
      break;
    case 1:
      errands.push_back(crossing(8.0, kAcross, -7.5, 8.0, random));
      break;
    case 2:
      errands.push_back(crossing(7.0, kAcross, -6.5, 8.0, random));
      errands.push_back(crossing(10.0, 0.0, 6.5, -8.0, random));
      break;
    default:
      errands.push_back(head_on(1.1, random));
      errands.push_back(crossing(6.0, kAcross, -5.5, 8.0, random));
      errands.push_back(crossing(11.0, 0.0, 5.5, -8.0, random));
  }
  return scene;
}

}  // namespace bw
