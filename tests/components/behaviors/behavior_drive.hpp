// A behavior drives a base: commands each cycle, odometry back. The base is motor_control's limiter at 50 Hz
// (jerk, acceleration), or obeys at once.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "components/behaviors/behavior_goals.hpp"
#include "components/model/differential_drive.hpp"
#include "components/motor_control/velocity_limiter.hpp"

namespace bw {

enum class Base { obeys_at_once, limiter };

struct BehaviorDrive {
  BehaviorOptions options;
  Robot robot;
  Base base = Base::limiter;
  StaticObstacles obstacles;
  std::vector<Mover> movers;  ///< at the start; they go on as `position_at` says
  Pose2 start;
  Twist2 start_twist;
  double longest = 120.0;  ///< [s]
  std::function<void(double t, BehaviorSituation&)> spoil = [](double, BehaviorSituation&) {};

  // What is seen.
  Pose2 pose;
  Twist2 twist;
  BehaviorStep last;
  double time = 0.0;     ///< [s] at the end
  double rotated = 0.0;  ///< [rad], whole revolutions counted
  std::vector<Twist2> commands;
  double least_gap =
      1e9;  ///< [m] of the disc to obstacles and movers, to the instant the base has come to rest

  static Time begin() { return Time::seconds(1000.0); }

  void run(Behavior& behavior) {
    pose = start;
    twist = start_twist;
    VelocityLimiter limiter(robot, {});
    hand_over(limiter);
    const double period = 1.0 / options.cycle_frequency;
    for (time = 0.0; time < longest; time += period) {
      last = behavior.step(situation());
      const Twist2 command = last.command.value_or(Twist2{});
      commands.push_back(command);
      if (last.state != BehaviorStep::State::running) break;
      move(limiter, command, period);
    }
    // As the component does it: zero until the base stands.
    for (int i = 0; i < 100 && twist != Twist2{}; ++i) {
      time += 0.02;
      move(limiter, {}, 0.02);
    }
  }

 private:
  BehaviorSituation situation() {
    BehaviorSituation s;
    PlanningProblem& p = s.problem;
    p.now = begin() + Duration::seconds(time);
    p.pose = pose;
    p.twist = twist;
    p.footprint.radius = robot.radius;
    p.limits = robot.limits;
    p.control_period = 1.0 / options.cycle_frequency;
    p.command_lead = options.command_lead;
    p.obstacles = obstacles;
    p.movers = movers;
    for (Mover& mover : p.movers) mover.position = mover.position_at(time);
    spoil(time, s);
    return s;
  }

  void hand_over(VelocityLimiter& limiter) {
    // The limiter gets to the velocity of the start by itself.
    for (double t = -5.0; t < 0.0; t += 0.02) {
      const Time now = begin() + Duration::seconds(t);
      limiter.command(now, start_twist);
      limiter.step(now);
    }
  }

  void move(VelocityLimiter& limiter, const Twist2& command, double duration) {
    const auto steps = static_cast<int>(std::lround(duration / 0.02));
    for (int i = 0; i < steps; ++i) {
      const Time now = begin() + Duration::seconds(time + 0.02 * i);
      limiter.command(now, command);
      twist = base == Base::limiter ? limiter.step(now).twist : command;
      pose = advance_exact(pose, twist, 0.02);
      rotated += twist.omega * 0.02;
      look(time + 0.02 * (i + 1));
    }
  }

  void look(double t) {
    const auto meet = [&](const Vector2& p, double radius) {
      least_gap = std::min(least_gap, (pose.position() - p).norm() - robot.radius - radius);
    };
    for (const Vector2& p : obstacles.points) meet(p, 0.0);
    for (const Disc& d : obstacles.discs) meet(d.center, d.radius);
    for (const Mover& m : movers) meet(m.position_at(t), m.radius);
  }
};

}  // namespace bw
