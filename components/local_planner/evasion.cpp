#include "components/local_planner/evasion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/timed_gaps.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kSpeedShares{1.0, 0.5, 0.0};  // of v_max; v_back_max is added
constexpr std::array kTurnRateShares{0.0, 1.0, -1.0, 0.5, -0.5};
constexpr std::array kLaterTurnRateShares{0.0, 1.0, -1.0};
constexpr std::array kLastSpeeds{1.0, 0.0};
constexpr double kShortestPeriod = 0.05;                // [s] of the simulation
constexpr std::array kFirstPhases{0.3, 0.6, 1.0, 1.5};  // [s]
constexpr std::array kSecondPhases{0.5, 1.0};           // [s]; the third lasts as long as the horizon
constexpr double kGapWeight = 100.0;  // metres of progress that a metre of gap is worth below enough_gap
constexpr double kNoCloser =
    0.01;                      // [m] of what is too near already, by which a motion that comes closer is told
constexpr double kGain = 0.1;  // [m/s] by which a gap that is too small is asked to grow
constexpr double kTestTime = 0.06;            // [s] at most between gap tests
constexpr std::size_t kMaxLooks = 2'000'000;  // of all moves; bounds the time of a search
constexpr std::size_t kLooksOfStep = 40;      // as long as these takes a step of the simulation
constexpr double kWorthMoving = 0.2;  // [s] of later contact for which a robot that could stop moves instead
// Of the moves that all become contacts: where the robot comes nearer than this [m] to somebody with more
// speed than that towards them [m/s], it would run into them.
constexpr double kRunsIntoGap = 0.1;
constexpr double kRunsIntoSpeed = 0.2;

double approach(double now, double target, double speeding_up, double slowing_down, double period) {
  if (target * now < 0.0) target = 0.0;  // first to rest: only braking may use the deceleration of a stop
  const double change = (std::abs(target) < std::abs(now) ? slowing_down : speeding_up) * period;
  return std::clamp(target, now - change, now + change);
}

// How far a motion has come, and what it has met. Its points are the first of those that the search has in
// hand.
struct Motion {
  std::size_t points = 0;
  double gap = kInfinity;
  double mover_gap = kInfinity;
  double contact_time = kInfinity;
  double shortfall = 0.0;  // [m] of the gap wanted, at the worst moment
  bool runs_into = false;  // somebody or something, among moves that all become contacts
};

// One that is kept.
struct Kept {
  Motion motion;
  std::vector<TrajectoryPoint> trajectory;
};

PlanningProblem without_touched(const PlanningProblem& problem) {
  PlanningProblem others;
  others.pose = problem.pose;
  others.twist = problem.twist;
  others.footprint = problem.footprint;
  others.limits = problem.limits;
  for (const Mover& mover : problem.movers) {
    if (gap_at(problem.pose, 0.0, problem.footprint, {}, {mover}) >= 0.0) others.movers.push_back(mover);
  }
  if (others.movers.size() < problem.movers.size()) others.obstacles = problem.obstacles;
  return others;
}

// Of who is touched already every motion would be a contact from the start, and none better than a stop in
// front of them. So these count by how far the robot gets out from under their feet alone; contact is with
// the others.
struct Others {
  Others(PlanningProblem without, double horizon, double step, double reach)
      : problem(std::move(without)), gaps(problem, horizon, step, reach) {}
  Others(const Others&) = delete;
  Others& operator=(const Others&) = delete;

  PlanningProblem problem;
  TimedGaps gaps;
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
        gaps_(problem, steps_ * options.period, options.period / tests_, options.enough_gap),
        top_speed_(std::max({problem.limits.v_max, problem.limits.v_back_max, std::abs(problem.twist.v)})) {
    const Limits& limits = problem.limits;
    const auto add = [&](const auto& shares, std::vector<Twist2>& targets) {
      for (const double share : shares) {
        for (const double speed : kSpeedShares)
          targets.push_back({speed * limits.v_max, share * limits.omega_max});
        if (limits.v_back_max > 0.0) targets.push_back({-limits.v_back_max, share * limits.omega_max});
      }
    };
    add(kTurnRateShares, first_targets_);
    add(kLaterTurnRateShares, later_targets_);
    now_ = gaps_.at(problem.pose, 0, gaps_.farthest()).all;
    double nearest = now_;
    if (PlanningProblem others = without_touched(problem); others.movers.size() < problem.movers.size()) {
      const double step = options.period / tests_;
      others_.emplace(std::move(others), steps_ * options.period, step, options.enough_gap);
      nearest = others_->gaps.at(problem.pose, 0, gaps_.farthest()).all;
    }
    options_.asked_gap = std::min(options.asked_gap, std::max(0.0, nearest - kNoCloser));
  }

  EvasiveMove run() {
    Motion motion = start();
    extend(motion, {}, steps_);
    const Kept stop{motion, points_};
    if (motion.gap >= options_.enough_gap) return as_move(stop);
    latest_ = stop;
    consider(motion);
    first_phase();
    if (best_score_ == -kInfinity && !is_touched()) look_for_least_contact();
    if (best_score_ > -kInfinity) return as_move(best_);
    const double stopping = std::abs(latest_.trajectory[1].twist.v) / problem_.limits.stop_deceleration;
    const double contact_time = latest_.motion.contact_time;
    const bool worth_it = contact_time > stop.motion.contact_time + kWorthMoving &&
                          contact_time > options_.period + stopping + kWorthMoving;
    return as_move(worth_it ? latest_ : stop);
  }

 private:
  Motion start() {
    points_.assign(1, {0.0, problem_.pose, problem_.twist});
    Motion motion{.points = 1};
    test(motion, problem_.pose, 0);
    return motion;
  }

  int steps_until(double time) const {
    return std::clamp(static_cast<int>(std::lround(time / options_.period)), 1, steps_);
  }

  void first_phase() {
    for (const Twist2& first : first_targets_) {
      Motion motion = start();
      for (const double phase : kFirstPhases) {
        extend(motion, first, steps_until(phase));
        if (is_pruned(motion)) break;
        second_phase(motion);
      }
    }
  }

  // No move stays clear of where people are expected. They will not be exactly there: what overlaps least may
  // clear, what touches last, along the path of who comes from behind, hardly will.
  void look_for_least_contact() {
    takes_contacts_ = true;
    Motion motion = start();
    extend(motion, {}, steps_);
    consider(motion);
    first_phase();
    takes_contacts_ = false;
  }

  void second_phase(const Motion& so_far) {
    const int begin = static_cast<int>(so_far.points) - 1;
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
    const double period = options_.period;
    points_.resize(motion.points);  // what else begins like this one has gone on from here
    while (static_cast<int>(motion.points) <= last && !is_pruned(motion)) {
      const TrajectoryPoint from = points_.back();
      const Twist2 twist{
          approach(from.twist.v, target.v, limits.acc_max, limits.stop_deceleration, period),
          approach(from.twist.omega, target.omega, limits.alpha_max, limits.alpha_max, period)};
      const std::size_t before = (motion.points - 1) * static_cast<std::size_t>(tests_);
      Pose2 pose;
      for (int test_step = 1; test_step <= tests_; ++test_step) {
        pose = advance_exact(from.pose, twist, test_step == tests_ ? period : test_step * (period / tests_));
        test(motion, pose, before + static_cast<std::size_t>(test_step));
      }
      points_.push_back({static_cast<double>(motion.points) * period, pose, twist});
      ++motion.points;
      looks_ += kLooksOfStep;
      if (takes_contacts_ && motion.gap < kRunsIntoGap) motion.runs_into |= runs_into_somebody();
    }
    if (!takes_contacts_ && motion.contact_time < kInfinity &&
        motion.contact_time > latest_.motion.contact_time)
      latest_ = {motion, points_};
  }

  bool is_touched() const { return others_.has_value(); }

  // At the last point simulated.
  bool runs_into_somebody() const {
    const TrajectoryPoint& point = points_.back();
    const Vector2 velocity = point.twist.v * Vector2(std::cos(point.pose.theta), std::sin(point.pose.theta));
    return std::any_of(problem_.movers.begin(), problem_.movers.end(), [&](const Mover& mover) {
      const Vector2 offset = mover.position_at(point.time) - point.pose.position();
      const double distance = offset.norm();
      return distance < mover.radius + problem_.footprint.radius + kRunsIntoGap &&
             velocity.dot(offset) > kRunsIntoSpeed * distance;
    });
  }

  double wanted(double time) const {
    if (takes_contacts_) return options_.enough_gap - options_.error_growth * time;
    return is_touched() ? std::min(options_.enough_gap, now_ + kGain * time) : options_.enough_gap;
  }

  void test(Motion& motion, const Pose2& pose, std::size_t k) {
    const double time = static_cast<double>(k) * options_.period / tests_;
    // Only what makes the motion worse is looked for.
    const double worse = std::min(options_.enough_gap, std::max(motion.gap, wanted(time) - motion.shortfall));
    const double nearer = std::max(worse, std::min(options_.enough_gap, motion.mover_gap));
    const TimedGaps::Gap gap = gaps_.at(pose, k, {worse, nearer, 0});
    looks_ += gap.looks;
    motion.gap = std::min(motion.gap, gap.all);
    motion.mover_gap = std::min(motion.mover_gap, gap.movers);
    motion.shortfall = std::max(motion.shortfall, wanted(time) - gap.all);
    if (takes_contacts_ && gap.all < std::min(options_.asked_gap, gap.movers)) motion.runs_into = true;
    double contact_gap = gap.all;
    if (is_touched()) {
      const TimedGaps::Gap other = others_->gaps.at(pose, k, gaps_.farthest());
      looks_ += other.looks;
      contact_gap = other.all;
    }
    if (contact_gap < options_.asked_gap) motion.contact_time = std::min(motion.contact_time, time);
  }

  bool is_ruled_out(const Motion& motion) const {
    return takes_contacts_ ? motion.runs_into : motion.contact_time < kInfinity;
  }

  // It met something, can no longer win, or there is no time left to see.
  bool is_pruned(const Motion& motion) const {
    if (latest_.trajectory.empty()) return false;  // the stop is simulated to its end
    if (is_ruled_out(motion) || looks_ > kMaxLooks) return true;
    if (best_score_ == -kInfinity) return false;
    const double left = static_cast<double>(steps_ + 1 - static_cast<int>(motion.points)) * options_.period;
    const double nearest = distance_to_goal() - top_speed_ * left - kRounding;
    return -kGapWeight * motion.shortfall - std::max(0.0, nearest) < best_score_;
  }

  double distance_to_goal() const { return (points_.back().pose.position() - goal_).norm(); }

  double score(const Motion& motion) const { return -kGapWeight * motion.shortfall - distance_to_goal(); }

  void consider(const Motion& motion) {
    if (is_ruled_out(motion)) return;
    if (static_cast<int>(motion.points) <= steps_) return;  // given up
    const double s = score(motion);
    if (s <= best_score_) return;
    best_score_ = s;
    best_ = {motion, points_};
  }

  static EvasiveMove as_move(const Kept& kept) {
    return {kept.motion.gap, kept.motion.mover_gap, kept.motion.contact_time, kept.trajectory};
  }

  static constexpr double kRounding = 1e-9;  // [m]

  const PlanningProblem& problem_;
  Vector2 goal_;
  EvasionOptions options_;
  int tests_;
  int steps_;
  TimedGaps gaps_;
  std::optional<Others> others_;  // when somebody is touched
  double now_ = 0.0;              // gap [m], at most enough_gap
  std::vector<Twist2> first_targets_;
  std::vector<Twist2> later_targets_;
  double top_speed_;
  std::vector<TrajectoryPoint> points_;
  Kept best_;
  Kept latest_;
  double best_score_ = -kInfinity;
  std::size_t looks_ = 0;
  bool takes_contacts_ = false;  // contacts rule no move out
};

}  // namespace

EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal,
                              const EvasionOptions& options) {
  EvasionOptions stepped = options;
  stepped.period = std::max(options.period, kShortestPeriod);
  return Search(problem, goal, stepped).run();
}

}  // namespace bw
