#include <algorithm>
#include <cmath>

#include "components/lab/bench/flows/flow_frame.hpp"
#include "components/lab/bench/flows/flow_scenes.hpp"

namespace bw {
namespace {

constexpr double kFlowApart = 0.7;    // [m] between centres at the start
constexpr double kOffTheRobot = 1.5;  // [m] from its centre
constexpr double kOffTheWall = 0.5;   // [m]
constexpr double kGrouped = 0.2;      // share of the people
constexpr double kSideBySide = 0.8;   // [m] in a group

/// Each group side by side, across the corridor.
class FlowGenerator {
 public:
  explicit FlowGenerator(std::uint64_t seed) : random_(seed) {}

  std::vector<WalkerOptions> people(int count) {
    const int grouped = static_cast<int>(std::lround(kGrouped * count));
    while (static_cast<int>(there_.size()) < grouped) {
      const int left = grouped - static_cast<int>(there_.size());
      const int drawn = 2 + static_cast<int>(random_.bits() % 2);
      add(left <= 3 ? std::max(left, 2) : left == 4 ? 2 : drawn, ++groups_);  // nobody is left over
    }
    while (static_cast<int>(there_.size()) < count) add(1, 0);
    return there_;
  }

 private:
  void add(int members, int group) {
    const double way = random_.uniform() < 0.5 ? kFlowFar : -kFlowFar;
    const double width = (members - 1) * kSideBySide;
    std::vector<WalkerOptions> drawn;
    do {
      drawn.clear();
      const double x = random_.uniform(kFlowLoop.from, kFlowLoop.to);
      const double room = kFlowHalfWidth - kOffTheWall;
      const double y = random_.uniform(-room, room - width);
      for (int k = 0; k < members; ++k)
        drawn.push_back({x, y + k * kSideBySide, x + way, y + k * kSideBySide, group});
    } while (!std::ranges::all_of(drawn, [this](const WalkerOptions& one) { return is_free(one); }));
    there_.insert(there_.end(), drawn.begin(), drawn.end());
  }

  bool is_free(const WalkerOptions& one) const {
    if (std::hypot(one.x, one.y) < kOffTheRobot) return false;
    return std::ranges::none_of(there_, [&](const WalkerOptions& other) {
      return std::hypot(one.x - other.x, one.y - other.y) < kFlowApart;
    });
  }

  Random random_;
  int groups_ = 0;
  std::vector<WalkerOptions> there_;
};

}  // namespace

DriveScene flow_scene(double density, std::uint64_t seed) {
  DriveScene scene = in_a_corridor("flow", seed, kFlowHalfWidth, kFlowLength, 60.0);
  const double area = 2.0 * kFlowHalfWidth * (kFlowLoop.to - kFlowLoop.from);
  SocialWalkersOptions options = flow_walkers();
  options.walkers = FlowGenerator(seed).people(static_cast<int>(std::lround(density * area)));
  scene.movers = std::make_shared<SocialPeople>(options, scene.walls, seed, kFlowLoop);
  return scene;
}

}  // namespace bw
