#include "components/program/calibrate/session.hpp"

#include <iostream>

#include "runtime/cli/signals.hpp"
#include "runtime/host/statistics.hpp"

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(50);

Time now() { return {steady_time().nanoseconds}; }

}  // namespace

void CalibrationSession::end(const std::string& why) {
  for (int i = 0; i < 3; ++i) robot_.command({});
  throw CalibrationAborted(why);
}

void CalibrationSession::step(const Twist2& twist) {
  robot_.command(twist);
  if (cli::interrupted()) end("interrupted: the robot stands, nothing was written");
}

void CalibrationSession::wait_for_robot() {
  std::string fault;
  for (const Time last = now() + Duration::milliseconds(10'000); now() < last;) {
    step({});
    if (lines_.wait(kPeriod)) end("typed something before it began");
    robot_.hear(now());
    fault = robot_.fault(now());
    if (fault.empty()) return;
  }
  end(fault);
}

std::string CalibrationSession::ask(const std::string& question) {
  std::cout << question << std::flush;
  for (;;) {
    if (auto line = lines_.wait(kPeriod)) return *line;
    // Zero holds the planner back, as a hand on the stick does.
    step({});
    robot_.hear(now());
    if (lines_.is_over()) end("the input is over: the robot stands, nothing was written");
  }
}

void CalibrationSession::confirm(const std::string& what) {
  const std::string answer = ask(what + " Is the way free? [Enter drives, q ends] ");
  if (!answer.empty()) end("ended by hand: the robot stands, nothing was written");
}

std::vector<WheelRotations> CalibrationSession::drive(const Leg& leg) {
  robot_.hear(now());
  LegDriver driver(leg, legs_, robot_.X_OB());
  std::vector<WheelRotations> rotations;
  WheelRotations last = robot_.angles();
  for (const Time latest = now() + Duration::seconds(driver.longest());;) {
    const auto twist = driver.step(robot_.X_OB(), robot_.twist());
    if (now() > latest) end("something holds the robot: the leg did not end in time");
    step(twist.value_or(Twist2{}));
    if (lines_.wait(kPeriod)) end("stopped by hand: nothing was written");
    robot_.hear(now());
    rotations.push_back({robot_.angles().left - last.left, robot_.angles().right - last.right});
    last = robot_.angles();
    if (!twist) return rotations;
    if (const std::string fault = robot_.fault(now()); !fault.empty()) end(fault);
  }
}

Pose2 CalibrationSession::pose_on_map() {
  const Time stood = now() + Duration::milliseconds(1000);
  for (const Time last = stood + Duration::milliseconds(5000); now() < last;) {
    step({});
    lines_.wait(kPeriod);
    robot_.hear(now());
    if (const auto pose = robot_.pose_since(stood)) return *pose;
  }
  end("the localization does not tell where the robot is");
}

}  // namespace bw
