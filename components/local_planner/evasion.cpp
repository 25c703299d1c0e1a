#include "components/local_planner/evasion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "components/local_planner/timed_gaps.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kSpeedShares{1.0, 0.5, 0.0};  // of v_max; v_back_max is added
constexpr std::array kTurnShares{0.0, 1.0, -1.0, 0.5, -0.5};
constexpr std::array kLaterTurns{0.0, 1.0, -1.0};
constexpr std::array kLastSpeeds{1.0, 0.0};
constexpr double kShortestPeriod = 0.05;                // [s] of the simulation
constexpr std::array kFirstPhases{0.3, 0.6, 1.0, 1.5};  // [s]
constexpr std::array kSecondPhases{0.5, 1.0};           // [s]; the third lasts as long as the horizon
constexpr double kGapWeight = 100.0;  // metres of progress that a metre of gap is worth below enough_gap
constexpr double kTestTime = 0.06;    // [s] at most between gap tests
constexpr std::size_t kMostLooks = 2'000'000;  // of all moves; bounds the time of a search
constexpr double kWorthMoving = 0.2;  // [s] of later contact for which a robot that could stop moves instead

double approach(double now, double target, double speeding_up, double slowing_down, double period) {
  if (target * now < 0.0) target = 0.0;  // first to rest: only braking may use the deceleration of a stop
  const double change = (std::abs(target) < std::abs(now) ? slowing_down : speeding_up) * period;
  return std::clamp(target, now - change, now + change);
}

// A motion so far and what it has met.
struct Motion {
  std::vector<TrajectoryPoint> trajectory;
  double gap = kInfinity;
  double mover_gap = kInfinity;
  double contact_time = kInfinity;
};

// Depth-first over the phases: moves that begin alike are simulated once, and given up when they fall behind.
class Search {
 public:
  Search(const PlanningProblem& problem, const Vector2& goal, const EvasionOptions& options)
      : problem_(problem),
        goal_(goal),
        options_(options),
        tests_(static_cast<int>(std::ceil(options.period / kTestTime))),
        steps_(std::max(1, static_cast<int>(std::lround(options.horizon / options.period)))),
        gaps_(problem, steps_ * options.period, options.period / tests_, options.enough_gap) {
    const Limits& limits = problem.limits;
    const auto add = [&](const auto& turns, std::vector<Twist2>& targets) {
      for (const double turn : turns) {
        for (const double speed : kSpeedShares)
          targets.push_back({speed * limits.v_max, turn * limits.omega_max});
        if (limits.v_back_max > 0.0) targets.push_back({-limits.v_back_max, turn * limits.omega_max});
      }
    };
    add(kTurnShares, first_targets_);
    add(kLaterTurns, later_targets_);
  }

  EvasiveMove run() {
    Motion stop = start();
    extend(stop, {}, steps_);
    if (stop.gap >= options_.enough_gap) return as_move(stop);
    latest_ = stop;
    consider(stop);
    for (const Twist2& first : first_targets_) {
      Motion motion = start();
      for (const double phase : kFirstPhases) {
        extend(motion, first, steps_until(phase));
        if (is_pruned(motion)) break;
        second_phase(motion);
      }
    }
    if (best_score_ > -kInfinity) return as_move(best_);
    const double stopping = std::abs(latest_.trajectory[1].twist.v) / problem_.limits.stop_deceleration;
    const bool worth_it = latest_.contact_time > stop.contact_time + kWorthMoving &&
                          latest_.contact_time > options_.period + stopping + kWorthMoving;
    return as_move(worth_it ? latest_ : stop);
  }

 private:
  Motion start() {
    Motion motion;
    motion.trajectory.reserve(static_cast<std::size_t>(steps_) + 1);
    motion.trajectory.push_back({0.0, problem_.pose, problem_.twist});
    test(motion, problem_.pose, 0);
    return motion;
  }

  int steps_until(double time) const {
    return std::clamp(static_cast<int>(std::lround(time / options_.period)), 1, steps_);
  }

  void second_phase(const Motion& so_far) {
    const int begin = static_cast<int>(so_far.trajectory.size()) - 1;
    for (const Twist2& second : later_targets_) {
      Motion motion = so_far;
      for (const double phase : kSecondPhases) {
        extend(motion, second, std::min(steps_, begin + steps_until(phase)));
        if (is_pruned(motion)) break;
        third_phase(motion);
      }
    }
  }

  void third_phase(const Motion& so_far) {
    for (const double speed : kLastSpeeds) {
      Motion motion = so_far;
      extend(motion, {speed * problem_.limits.v_max, 0.0}, steps_);
      consider(motion);
    }
  }

  // Simulates up to `last` steps from the start.
  void extend(Motion& motion, const Twist2& target, int last) {
    const Limits& limits = problem_.limits;
    const double h = options_.period / tests_;
    while (static_cast<int>(motion.trajectory.size()) <= last && !is_pruned(motion)) {
      const TrajectoryPoint from = motion.trajectory.back();
      const auto i = motion.trajectory.size();
      const double period = options_.period;
      const Twist2 twist{
          approach(from.twist.v, target.v, limits.acc_max, limits.stop_deceleration, period),
          approach(from.twist.omega, target.omega, limits.alpha_max, limits.alpha_max, period)};
      for (int test_step = 1; test_step <= tests_; ++test_step) {
        test(motion, advance_exact(from.pose, twist, test_step * h),
             (i - 1) * static_cast<std::size_t>(tests_) + static_cast<std::size_t>(test_step));
      }
      motion.trajectory.push_back(
          {static_cast<double>(i) * period, advance_exact(from.pose, twist, period), twist});
    }
    if (motion.contact_time < kInfinity && motion.contact_time > latest_.contact_time) latest_ = motion;
  }

  void test(Motion& motion, const Pose2& pose, std::size_t k) {
    const TimedGaps::Gap gap = gaps_.at(pose, k);
    looks_ += gap.looks;
    motion.gap = std::min(motion.gap, gap.all);
    motion.mover_gap = std::min(motion.mover_gap, gap.movers);
    if (gap.all < options_.asked_gap)
      motion.contact_time = std::min(motion.contact_time, static_cast<double>(k) * options_.period / tests_);
  }

  // It met something, can no longer win, or there is no time left to see.
  bool is_pruned(const Motion& motion) const {
    if (best_score_ == -kInfinity && latest_.trajectory.empty())
      return false;  // the stop is simulated to its end
    return motion.contact_time < kInfinity || kGapWeight * motion.gap < best_score_ || looks_ > kMostLooks;
  }

  double score(const Motion& motion) const {
    return kGapWeight * motion.gap - (motion.trajectory.back().pose.position() - goal_).norm();
  }

  void consider(const Motion& motion) {
    if (motion.contact_time < kInfinity) return;
    if (static_cast<int>(motion.trajectory.size()) <= steps_) return;  // given up
    const double s = score(motion);
    if (s <= best_score_) return;
    best_score_ = s;
    best_ = motion;
  }

  static EvasiveMove as_move(const Motion& motion) {
    return {motion.gap, motion.mover_gap, motion.contact_time, motion.trajectory};
  }

  const PlanningProblem& problem_;
  Vector2 goal_;
  EvasionOptions options_;
  int tests_;
  int steps_;
  TimedGaps gaps_;
  std::vector<Twist2> first_targets_;
  std::vector<Twist2> later_targets_;
  Motion best_;
  Motion latest_;
  double best_score_ = -kInfinity;
  std::size_t looks_ = 0;
};

}  // namespace

EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal,
                              const EvasionOptions& options) {
  EvasionOptions stepped = options;
  stepped.period = std::max(options.period, kShortestPeriod);
  return Search(problem, goal, stepped).run();
}

}  // namespace bw
