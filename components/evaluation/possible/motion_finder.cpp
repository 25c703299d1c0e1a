#include "components/evaluation/possible/motion_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "components/evaluation/possible/bit_field.hpp"

namespace bw::possible {
namespace {

constexpr double kLook = 0.05;          // [s] between two looks
constexpr double kLookAgain = 0.01;     // [s] when a motion is proven
constexpr double kMargin = 0.006;       // [m] nobody comes nearer than this between two looks
constexpr double kMarginAgain = 3e-4;   // [m] likewise: sqrt(0.6^2 + (0.0075 3 m/s)^2) - 0.6
constexpr double kStandingCell = 0.02;  // [m]
constexpr double kWidest = 15.0;        // [m] from the start to the edge of what stands about

struct Node {
  Pose2 pose;
  Twist2 twist;
  std::int32_t parent = -1;
  double gap = 0.0;  ///< to the nearest who walks, at its end [m]
};

/// Steady change of both speeds over `dt`.
Pose2 moved(const Pose2& pose, const Twist2& from, const Twist2& to, double dt) {
  const double heading = pose.theta + dt * (3.0 * from.omega + to.omega) / 8.0;  // half way
  const double s = dt * (from.v + to.v) / 2.0;
  return {pose.x + s * std::cos(heading), pose.y + s * std::sin(heading),
          wrap_angle(pose.theta + dt * (from.omega + to.omega) / 2.0)};
}

Twist2 between(const Twist2& a, const Twist2& b, double share) {
  return {a.v + share * (b.v - a.v), a.omega + share * (b.omega - a.omega)};
}

std::uint64_t mixed(std::uint64_t x) {  // splitmix64's last part: spreads neighbours
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// What may be asked for at the end of a step: by extreme accelerations, none, or a stop.
struct Choices {
  std::array<double, 4> values{};
  int count = 0;

  void add(double value) {
    for (int k = 0; k < count; ++k)
      if (values[static_cast<std::size_t>(k)] == value) return;
    values[static_cast<std::size_t>(count++)] = value;
  }
};

Choices choices_of(double now, double change, double low, double high) {
  Choices choices;
  choices.add(std::max(std::min(low, now), now - change));
  choices.add(now);
  choices.add(std::min(std::max(high, now), now + change));
  if (std::abs(now) < change) choices.add(0.0);
  return choices;
}

class Finder {
 public:
  Finder(const SearchScene& scene, const MotionState& start, const MotionBounds& bounds, double until,
         const FinderOptions& options)
      : scene_(scene), start_(start), bounds_(bounds), options_(options), until_(until) {
    // Everybody at each look.
    const int looks = static_cast<int>(std::ceil((until - start.time) / kLook - 1e-9));
    for (int look = 0; look <= looks + 8; ++look) walkers_.push_back(walkers_at(start.time + look * kLook));
    paint_standing();
  }

  std::optional<std::vector<MotionState>> run() {
    if (!is_free(start_.pose, walkers_at(start_.time), 0.0, nullptr)) return std::nullopt;
    layers_.push_back({Node{start_.pose, start_.twist}});
    const int steps = static_cast<int>(std::ceil((until_ - start_.time) / options_.step - 1e-9));
    for (int step = 0;; ++step) {
      if (auto found = follow_some(step, steps)) return found;
      if (step == steps) {
        for (std::size_t i = 0; i < layers_.back().size(); ++i)
          if (auto found = proven(twists_to(step, i))) return found;
        return std::nullopt;
      }
      expand(step);
      if (layers_.back().empty()) return std::nullopt;
    }
  }

 private:
  struct Body {
    Vector2 position;
    double radius = 0.0;
  };
  using Bodies = std::vector<Body>;

  Bodies walkers_at(double time) const {
    Bodies bodies;
    for (const Walk& walk : scene_.walks)
      if (const std::optional<Vector2> p = walk.at(time)) bodies.push_back({*p, walk.radius});
    return bodies;
  }

  void paint_standing() {
    const double farthest =
        (std::max({bounds_.v_max, bounds_.v_back_max, std::abs(start_.twist.v)})) * (until_ - start_.time) +
        1.0;
    frame_ = {start_.pose.position(), kStandingCell,
              2 * static_cast<int>(std::min(farthest, kWidest) / kStandingCell) + 1};
    standing_ = BitField(frame_.side);
    const double robot =
        scene_.outer_radius + kStandingCell;  // any point of a cell is that close to its centre
    for (const Disc& disc : scene_.shapes.discs)
      paint(standing_, frame_, disc.center, disc.center, robot + disc.radius);
    for (const Vector2& point : scene_.shapes.points) paint(standing_, frame_, point, point, robot);
    for (const Segment& segment : scene_.shapes.segments)
      paint(standing_, frame_, segment.a, segment.b, robot);
    for (const Vector2& square : scene_.squares)  // the disc around it
      paint(standing_, frame_, square, square, robot + 0.7072 * scene_.square_edge);
    // Who starts beside a wall is let out of it: what is cut off there is the rim of rounding.
    starts_blocked_ = stands_in_something(start_.pose);
  }

  bool stands_in_something(const Pose2& pose) const {
    const int column = frame_.column_of(pose.x);
    const int row = frame_.row_of(pose.y);
    return !frame_.contains(column, row) || standing_.at(column, row);
  }

  bool is_free(const Pose2& pose, const Bodies& bodies, double margin, double* gap) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Body& body : bodies) {
      const double reach = body.radius + scene_.outer_radius + margin;
      const double squared = (body.position - pose.position()).squaredNorm();
      if (squared < reach * reach) return false;
      least = std::min(least, squared);
    }
    if (gap != nullptr) *gap = std::sqrt(least);
    if (!stands_in_something(pose)) return true;
    return starts_blocked_ && (pose.position() - start_.pose.position()).norm() < 2.0 * kStandingCell;
  }

  /// Goes on from `node` at look `look` to speeds `to` over `looks` looks; false when somebody is in the way.
  bool go(Node& node, int look, int looks, const Twist2& to) const {
    const Twist2 from = node.twist;
    for (int k = 1; k <= looks; ++k) {
      const Twist2 a = between(from, to, (k - 1.0) / looks);
      const Twist2 b = between(from, to, static_cast<double>(k) / looks);
      node.pose = moved(node.pose, a, b, kLook);
      if (!is_free(node.pose, walkers_[static_cast<std::size_t>(look + k)], kMargin, &node.gap)) return false;
    }
    node.twist = to;
    return true;
  }

  int looks_of_step() const { return static_cast<int>(std::lround(options_.step / kLook)); }

  std::uint64_t key_of(const Node& node) const {
    const auto cell = [](double value, double size) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size)) + 1024) & 0xfffU;
    };
    return cell(node.pose.x - start_.pose.x, options_.position) |
           cell(node.pose.y - start_.pose.y, options_.position) << 12 |
           cell(node.pose.theta, options_.heading) << 24 | cell(node.twist.v, options_.speed) << 36 |
           cell(node.twist.omega, options_.turn_rate) << 48;
  }

  void expand(int step) {
    struct Candidate {
      std::uint64_t key = 0;
      Node node;
    };
    const int looks = looks_of_step();
    std::vector<Candidate> candidates;
    const std::vector<Node>& layer = layers_.back();
    for (std::size_t i = 0; i < layer.size(); ++i) {
      const Twist2& now = layer[i].twist;
      const Choices v =
          choices_of(now.v, bounds_.acceleration * options_.step, -bounds_.v_back_max, bounds_.v_max);
      const Choices omega =
          choices_of(now.omega, bounds_.alpha * options_.step, -bounds_.omega_max, bounds_.omega_max);
      for (int a = 0; a < v.count; ++a) {
        for (int b = 0; b < omega.count; ++b) {
          Node node = layer[i];
          node.parent = static_cast<std::int32_t>(i);
          if (!go(node, step * looks, looks,
                  {v.values[static_cast<std::size_t>(a)], omega.values[static_cast<std::size_t>(b)]}))
            continue;
          candidates.push_back({key_of(node), node});
        }
      }
    }
    // One for each cell: the one with the most room.
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.key != b.key ? a.key < b.key : a.node.gap > b.node.gap;
    });
    const auto same = [](const Candidate& a, const Candidate& b) { return a.key == b.key; };
    candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
    const auto most = static_cast<std::size_t>(options_.most_states);
    if (candidates.size() > most) {
      std::sort(candidates.begin(), candidates.end(),
                [](const Candidate& a, const Candidate& b) { return mixed(a.key) < mixed(b.key); });
      candidates.resize(most);
    }
    std::vector<Node> kept;
    kept.reserve(candidates.size());
    for (const Candidate& candidate : candidates) kept.push_back(candidate.node);
    layers_.push_back(std::move(kept));
  }

  /// The roomiest states of a step, each going on as it is, straight on, and braking.
  std::optional<std::vector<MotionState>> follow_some(int step, int steps) const {
    const std::vector<Node>& layer = layers_.back();
    std::vector<std::size_t> order(layer.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const std::size_t count = std::min(order.size(), static_cast<std::size_t>(options_.followed));
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) {
                        return layer[a].gap != layer[b].gap ? layer[a].gap > layer[b].gap : a < b;
                      });
    for (std::size_t k = 0; k < count; ++k) {
      for (const bool is_braking : {false, true}) {
        std::vector<Twist2> speeds;
        if (!follow(layer[order[k]], step, steps, is_braking, speeds)) continue;
        Twists twists = twists_to(step, order[k]);
        twists.insert(twists.end(), speeds.begin(), speeds.end());
        if (auto found = proven(twists)) return found;
      }
    }
    return std::nullopt;
  }

  /// `speeds`: at the end of each further step.
  bool follow(Node node, int step, int steps, bool is_braking, std::vector<Twist2>& speeds) const {
    const int looks = looks_of_step();
    for (; step < steps; ++step) {
      const auto towards = [](double now, double aim, double change) {
        return now + std::clamp(aim - now, -change, change);
      };
      const Twist2 to{
          towards(node.twist.v, is_braking ? 0.0 : bounds_.v_max, bounds_.acceleration * options_.step),
          towards(node.twist.omega, 0.0, bounds_.alpha * options_.step)};
      if (!go(node, step * looks, looks, to)) return false;
      speeds.push_back(to);
    }
    return true;
  }

  /// Speeds at the end of each step.
  using Twists = std::vector<Twist2>;

  Twists twists_to(int step, std::size_t index) const {
    Twists twists;
    for (int layer = step; layer > 0; --layer) {
      const Node& node = layers_[static_cast<std::size_t>(layer)][index];
      twists.push_back(node.twist);
      index = static_cast<std::size_t>(node.parent);
    }
    std::reverse(twists.begin(), twists.end());
    return twists;
  }

  /// Driven again in small steps.
  std::optional<std::vector<MotionState>> proven(const Twists& twists) const {
    std::vector<MotionState> states{start_};
    Pose2 pose = start_.pose;
    Twist2 from = start_.twist;
    double time = start_.time;
    const int parts = static_cast<int>(std::lround(options_.step / kLookAgain));
    const int every = static_cast<int>(std::lround(kLook / kLookAgain));
    for (const Twist2& to : twists) {
      for (int k = 1; k <= parts; ++k) {
        const Twist2 before = between(from, to, (k - 1.0) / parts);
        const Twist2 now = between(from, to, static_cast<double>(k) / parts);
        pose = moved(pose, before, now, kLookAgain);
        time += kLookAgain;
        if (time > until_ + 1e-9) return states;
        if (!is_free(pose, walkers_at(time), kMarginAgain, nullptr)) return std::nullopt;
        if (k % every == 0) states.push_back({time, pose, now});
      }
      from = to;
    }
    return states;
  }

  const SearchScene& scene_;
  const MotionState start_;
  const MotionBounds bounds_;
  const FinderOptions options_;
  double until_;
  std::vector<Bodies> walkers_;  ///< at each look
  BitFrame frame_;
  BitField standing_;
  bool starts_blocked_ = false;
  std::vector<std::vector<Node>> layers_;
};

}  // namespace

std::optional<std::vector<MotionState>> find_motion(const SearchScene& scene, const MotionState& start,
                                                    const MotionBounds& bounds, double until,
                                                    const FinderOptions& options) {
  return Finder(scene, start, bounds, until, options).run();
}

}  // namespace bw::possible
