// Drawings of the local planners, at a moment of the drive in which two people cross the robot's path.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "components/lab/figures/crossing_moment.hpp"
#include "components/lab/figures/figures.hpp"
#include "components/lab/figures/plane.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/velocity_window.hpp"
#include "components/local_planner/teb/teb_options.hpp"

namespace bw::figures {
namespace {

using Box = Eigen::AlignedBox2d;

constexpr double kBeforeTheyMeet = 3.5;  // [s]
const Axes kVelocities{.x = "v_x [m/s]", .y = "v_y [m/s]", .tick = 0.5, .decimals = 1};

std::vector<Vector2> positions(const std::vector<TrajectoryPoint>& trajectory) {
  std::vector<Vector2> points;
  for (const TrajectoryPoint& point : trajectory) points.push_back(point.pose.position());
  return points;
}

void draw_robot(Plane& plane, const PlanningProblem& problem) {
  plane.disc(problem.pose.position(), problem.footprint.radius, kBlue, 0.3);
  plane.arrow(problem.pose.position(), 0.5 * direction(problem.pose.theta), kBlue, 2.0);
  plane.note(problem.pose.position(), "robot", -18.0, -30.0, kBlue);
}

/// Where they are, with their velocity, and, lighter, where they are expected each second.
void draw_people(Plane& plane, const PlanningProblem& problem, double seconds) {
  char name = 'A';
  for (const Mover& person : problem.movers) {
    for (double t = 1.0; t <= seconds; t += 1.0)
      plane.disc(person.position_at(t), person.radius, kPurple, 0.06);
    plane.disc(person.position, person.radius, kPurple, 0.4);
    plane.arrow(person.position, person.velocity, kPurple);
    plane.note(person.position, std::string(1, name++), -4.0, -4.0);
  }
}

}  // namespace

std::string elastic_band() {
  const PlannerOptions options;
  const auto [problem, result] = crossing_moment("teb", options, kBeforeTheyMeet);
  const double reach = options.of<teb::TebOptions>("teb").band.dynamic_obstacle_inflation_dist;
  Plane plane(fmt::format("Timed elastic band, {:.1f} s into the drive", kBeforeTheyMeet),
              Box(Vector2(0.0, -3.0), Vector2(10.5, 3.0)), kFloor);
  draw_people(plane, problem, 5.0);
  plane.curve(positions(result.trajectory), kGreen, 2.4);
  for (const TrajectoryPoint& point : result.trajectory) {
    plane.dot(point.pose.position(), 2.8, kGreen);
    plane.arrow(point.pose.position(), 0.28 * direction(point.pose.theta), kGreen, 1.2);
    for (const Mover& person : problem.movers) {
      const Vector2 from_person = point.pose.position() - person.position_at(point.time);
      const double missing = reach - (from_person.norm() - problem.footprint.radius - person.radius);
      if (missing <= 0.0) continue;
      plane.curve({point.pose.position(), person.position_at(point.time)}, kGrey, 0.8, "2 3");
      plane.arrow(point.pose.position(), 1.5 * missing * from_person.normalized(), kVermilion, 2.0);
    }
  }
  draw_robot(plane, problem);
  plane.key(kGreen, "poses of the band with their headings, and the segments between them");
  plane.key(
      kVermilion,
      fmt::format(
          "push of a person whose gap, at the time of that pose, is below dynamic_obstacle_inflation_dist ({} m)",
          reach));
  plane.key(kPurple, "people A and B: now (the arrow is 1 s of their walk) and each second from now on");
  return std::move(plane).finish();
}

std::string homotopy_classes() {
  const auto [problem, result] = crossing_moment("eteb", PlannerOptions{}, 1.5);
  Plane plane("Homotopy classes around two people: one band in each",
              Box(Vector2(0.0, -5.5), Vector2(10.5, 3.5)), kFloor);
  draw_people(plane, problem, 5.0);
  constexpr std::array kColors{kOrange, kSky, kVermilion, kGrey, kBlack};
  std::size_t next = 0;
  for (const Candidate& candidate : result.candidates) {
    const std::string_view color = candidate.chosen ? kGreen : kColors[next++ % kColors.size()];
    plane.curve(positions(candidate.trajectory), color, candidate.chosen ? 3.0 : 1.8,
                candidate.chosen ? "" : "6 4");
    plane.key(color, fmt::format("{}: cost {:.1f}{}", candidate.label, candidate.cost,
                                 candidate.chosen ? ", driven" : ""));
  }
  draw_robot(plane, problem);
  plane.key(kPurple,
            "people A and B: now and each second from now on; a class says on which side each is passed");
  return std::move(plane).finish();
}

std::string velocity_obstacle() {
  const auto [problem, result] = crossing_moment("hrvo", PlannerOptions{}, kBeforeTheyMeet);
  Plane plane("Velocity obstacles of two people, in the space of velocities",
              Box(Vector2(-1.6, -1.4), Vector2(1.8, 1.4)), kVelocities, 620.0);
  constexpr double kFar = 6.0;  // [m/s]
  for (const VelocityCone& cone : result.velocity_cones) {
    plane.area({cone.apex, cone.apex + kFar * cone.right, cone.apex + kFar * cone.left}, kPurple, 0.16);
    plane.dot(cone.apex, 3.5, kPurple);
    plane.note(cone.apex, "apex", 6.0, 4.0, kPurple);
  }
  plane.disc({0.0, 0.0}, problem.limits.v_max, kGrey, 0.0);
  const Vector2 now = problem.twist.v * direction(problem.pose.theta);
  plane.arrow({0.0, 0.0}, now, kBlue, 2.0);
  plane.note(now, "velocity now", 6.0, -14.0, kBlue);
  if (result.velocity_wanted) {
    plane.arrow({0.0, 0.0}, *result.velocity_wanted, kGreen, 2.4);
    plane.note(*result.velocity_wanted, "advised", 6.0, 8.0, kGreen);
  }
  plane.key(kPurple, "velocities that lead to a contact; the apex is the person's velocity");
  plane.key(kGrey, "top speed");
  plane.key(kGreen, "the velocity outside all obstacles that is nearest to straight on");
  return std::move(plane).finish();
}

std::string dynamic_window() {
  PlannerOptions options;
  auto& dwa = options.of<dwa::DwaOptions>("dwa");
  dwa.profile = dwa::Profile::scales;
  dwa.shown_candidates = 100'000;
  const auto [problem, result] = crossing_moment("dwa", options, kBeforeTheyMeet);
  const Limits& limits = problem.limits;
  const dwa::VelocityWindow window =
      dwa::velocity_window(problem.twist, limits, limits.v_max, problem.command_lead);
  const auto at = [](const Twist2& twist) { return Vector2(-twist.omega, twist.v); };
  const Box reach(at({window.v.low, window.omega.high}), at({window.v.high, window.omega.low}));
  const Vector2 around = 0.25 * reach.sizes();
  Plane plane("Dynamic window, samples and their objective", Box(reach.min() - around, reach.max() + around),
              {.x = "turn rate [rad/s]; left is negative here",
               .y = "speed [m/s]",
               .tick = 0.05,
               .decimals = 2,
               .is_metric = false});
  plane.area(
      {reach.min(), {reach.max().x(), reach.min().y()}, reach.max(), {reach.min().x(), reach.max().y()}},
      kSky, 0.12);
  for (const Twist2& sample : dwa::velocity_samples(window, problem.twist, dwa.v_samples, dwa.omega_samples))
    plane.dot(at(sample), 2.5, kGrey);
  double best = 1e9, worst = -1e9;
  for (const Candidate& candidate : result.candidates) {
    best = std::min(best, candidate.cost);
    worst = std::max(worst, candidate.cost);
  }
  for (const Candidate& candidate : result.candidates) {
    const double share = worst > best ? (worst - candidate.cost) / (worst - best) : 1.0;
    plane.dot(at(candidate.trajectory.back().twist), 3.0 + 5.0 * share,
              candidate.chosen ? kVermilion : kGreen, 0.2 + 0.8 * share);
  }
  plane.dot(at(problem.twist), 4.5, kBlue);
  plane.note(at(problem.twist), "now", 8.0, -14.0, kBlue);
  plane.key(kSky, fmt::format(
                      "dynamic window: what the accelerations reach in {} s, of at most {} m/s and {} rad/s",
                      problem.command_lead, limits.v_max, limits.omega_max));
  plane.key(kGreen, "admissible samples, larger for a larger objective; red is the command");
  plane.key(kGrey, "a sample that is not admissible: it cannot brake before its first contact");
  return std::move(plane).finish();
}

}  // namespace bw::figures
