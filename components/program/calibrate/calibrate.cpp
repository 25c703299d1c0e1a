// `bandwagon calibrate odometry`: the sizes of the wheels and their distance, driven and measured on the
// floor.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "components/program/calibrate/geometry_lines.hpp"
#include "components/program/calibrate/session.hpp"
#include "components/robot_base/calibration/calibrate_odometry.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;

struct CalibrateOptions {
  std::string robot;
  double straight = 5.0;
  int straights = 4;
  double side = 4.0;
  int laps = 5;
  LegOptions legs;
  std::string poses;
  std::string ns;
  std::string out;
};

/// Numbers of a line, or nothing if it is anything else.
std::vector<double> numbers_in(const std::string& line) {
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double value = 0.0; stream >> value;) numbers.push_back(value);
  return stream.eof() ? numbers : std::vector<double>{};
}

class OdometryCalibration {
 public:
  OdometryCalibration(const CalibrateOptions& options, RobotFront& robot)
      : options_(options), session_(robot, options.legs) {}

  std::vector<MeasuredMotion> measure() {
    session_.wait_for_robot();
    for (int i = 0; i < options_.straights; ++i) drive_straight(i);
    for (int i = 0; i < 2 * options_.laps; ++i) drive_square(i);
    return std::move(motions_);
  }
  CalibrationSession& session() { return session_; }

 private:
  bool has_map() const { return !options_.poses.empty(); }

  void drive_straight(int index) {
    using Known = MeasuredMotion::Known;
    std::cout << fmt::format("\nStraight {} of {}: {:.2f} m ahead.", index + 1, options_.straights,
                             options_.straight)
              << (has_map() ? "" : " Mark the floor where the robot stands.") << std::endl;
    const Pose2 from = has_map() ? session_.pose_on_map() : Pose2{};
    session_.confirm("It drives straight on and stops.");
    MeasuredMotion motion{.rotations = session_.drive({.distance = options_.straight})};
    if (has_map()) {
      motion.moved = inverse(from) * session_.pose_on_map();
    } else {
      motion.known = Known::distance;
      motion.moved.x =
          ask_numbers("How far is it from the mark to the same point of the robot [m]? ", 1, 1).front();
    }
    motions_.push_back(motion);
    if (index + 1 == options_.straights) return;
    session_.confirm("It turns round on the spot.");
    session_.drive({.rotation = kPi});
  }

  void drive_square(int index) {
    const bool is_left = index < options_.laps;
    std::cout << fmt::format("\nSquare {} of {}, to the {}: side {:.2f} m.", index + 1, 2 * options_.laps,
                             is_left ? "left" : "right", options_.side)
              << (has_map() ? "" : " Mark where the robot stands, and where it looks.") << std::endl;
    MeasuredMotion motion;
    Pose2 from = has_map() ? session_.pose_on_map() : Pose2{};
    for (int leg = 0; leg < 8; ++leg) {
      const bool is_rotation = leg % 2 == 1;
      session_.confirm(
          is_rotation
              ? fmt::format("Corner {}: it turns {} on the spot.", leg / 2 + 1, is_left ? "left" : "right")
              : fmt::format("Side {}: {:.2f} m straight on.", leg / 2 + 1, options_.side));
      const auto rotations = session_.drive(is_rotation ? Leg{.rotation = (is_left ? kPi : -kPi) / 2.0}
                                                        : Leg{.distance = options_.side});
      motion.rotations.insert(motion.rotations.end(), rotations.begin(), rotations.end());
      if (!has_map()) continue;
      const Pose2 to = session_.pose_on_map();
      motion.moved = inverse(from) * to;
      motions_.push_back(std::exchange(motion, {}));
      from = to;
    }
    if (!has_map()) motions_.push_back(with_typed_end(std::move(motion)));
  }

  MeasuredMotion with_typed_end(MeasuredMotion motion) {
    const std::vector<double> end = ask_numbers(
        "Where is it, seen from the mark: ahead [m], to the left [m], and turned to the left [degrees, may be left out]? ",
        2, 3);
    motion.moved = {end[0], end[1], end.size() > 2 ? wrap_angle(end[2] * kDegree) : 0.0};
    motion.known = end.size() > 2 ? MeasuredMotion::Known::pose : MeasuredMotion::Known::position;
    return motion;
  }

  std::vector<double> ask_numbers(const std::string& question, std::size_t least, std::size_t most) {
    for (;;) {
      const std::vector<double> numbers = numbers_in(session_.ask(question));
      if (numbers.size() >= least && numbers.size() <= most) return numbers;
      std::cout << fmt::format("{} to {} numbers with blanks between them, please.\n", least, most);
    }
  }

  const CalibrateOptions& options_;
  CalibrationSession session_;
  std::vector<MeasuredMotion> motions_;
};

void print(const WheelGeometry& before, const Calibration& found) {
  const auto row = [](const char* name, double old_value, double value, double error) {
    constexpr double kNotMeasured = 0.05;
    std::cout << fmt::format("{:20} {:10.6g}  ->  {:10.6g}   ", name, old_value, value)
              << (error > kNotMeasured ? "not measured\n"
                                       : fmt::format("{:+.2f} %, +- {:.2f} %\n",
                                                     100.0 * (value / old_value - 1.0), 100.0 * error));
  };
  std::cout << "\n";
  row("wheel_radius", before.radius, found.geometry.radius, found.share_of_error.radius);
  row("wheel_radius_ratio", before.ratio, found.geometry.ratio, found.share_of_error.ratio);
  row("wheel_separation", before.separation, found.geometry.separation, found.share_of_error.separation);
  std::cout
      << "The errors are those of how well the motions agree with each other; more of them make them smaller.\n";
}

/// A controller of speed in other units than its driver believes turns wheels at twice or half of what they
/// are told.
void print_obedience(std::vector<double> shares) {
  constexpr double kNear = 0.15;
  if (shares.empty()) return;
  std::ranges::nth_element(shares, shares.begin() + std::ssize(shares) / 2);
  const double median = shares[shares.size() / 2];
  std::cout << fmt::format("The wheels turn at {:.2f} of what they are told.\n", median);
  if (std::abs(median - 1.0) > kNear)
    std::cout
        << "That is the unit of the base's speed, not its wheels: for Eddie `positions_per` of section base.\n";
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return text.str();
}

/// Reads back what is to be written: a file that this program would refuse is not written.
void check(const std::string& text, const std::string& path, const WheelGeometry& geometry) {
  Robot robot;
  read_into(robot, parse_yaml(text, path), "robot");
  const auto is_near = [](double a, double b) { return std::abs(a - b) <= 1e-5 * std::abs(b); };
  if (!is_near(robot.wheel_radius, geometry.radius) || !is_near(robot.wheel_radius_ratio, geometry.ratio) ||
      !is_near(robot.wheel_separation, geometry.separation))
    throw std::runtime_error(path + ": the values stand elsewhere in this file; put the lines in by hand");
}

int write(const CalibrateOptions& options, CalibrationSession& session, const WheelGeometry& geometry) {
  std::cout << "\nFor the robot file:\n" << geometry_lines(geometry);
  const std::string path = options.out.empty() ? options.robot : options.out;
  const std::string answer = session.ask(fmt::format("Write them into {}? [y, or Enter for no] ", path));
  if (answer != "y" && answer != "yes") {
    std::cout << "Nothing was written.\n";
    return 0;
  }
  const std::string text = with_geometry(text_of(options.robot), geometry);
  check(text, path, geometry);
  write_file_atomically(path, text);
  std::cout << fmt::format("Written. A graph that runs takes them when it is started again.\n");
  return 0;
}

int calibrate_odometry_verb(const CalibrateOptions& options) {
  Robot robot;
  read_into(robot, load_yaml(options.robot), "robot");
  with_geometry(text_of(options.robot), geometry_of(robot));  // before an hour is spent
  cli::catch_interrupts();
  std::cout << fmt::format(
      "Calibrates the odometry of {}: {} straights of {:.1f} m, then {} squares of {:.1f} m to each side (UMBmark), at {:.2f} m/s.\n"
      "Keep everybody away. Ctrl-C, or Enter while it drives, stops it at once. Cancel its goal first: nothing else may drive it.\n",
      options.robot, options.straights, options.straight, options.laps, options.side, options.legs.v);
  try {
    RobotFront front(options.ns, options.poses);
    OdometryCalibration calibration(options, front);
    const std::vector<MeasuredMotion> motions = calibration.measure();
    const MeasuringErrors errors =
        options.poses.empty() ? MeasuringErrors{} : MeasuringErrors{.position = 0.01, .heading = 0.005};
    const auto found = calibrate_odometry(motions, geometry_of(robot), errors);
    if (!found)
      throw CalibrationAborted("the ends that were given fit no wheels at all: nothing was written");
    print(geometry_of(robot), *found);
    print_obedience(front.obedience());
    return write(options, calibration.session(), found->geometry);
  } catch (const CalibrationAborted& ended) {
    std::cerr << "\n" << ended.what() << "\n";
    return 1;
  }
}

void add_options(cli::Verb verb, CalibrateOptions& options) {
  verb.option("ROBOT", options.robot, "Robot file, with which the graph runs").required().existing_file();
  verb.option("--straight", options.straight, "Length of a straight way [m]")
      .within(0.5, 100.0)
      .shows_default();
  verb.option("--straights", options.straights, "How many").within(0, 100).shows_default();
  verb.option("--side", options.side, "Side of the squares [m]").within(0.3, 20.0).shows_default();
  verb.option("--laps", options.laps, "Squares to each side").within(0, 100).shows_default();
  verb.option("--v", options.legs.v, "Speed [m/s]").within(0.05, 1.0).shows_default();
  verb.option("--omega", options.legs.omega, "Turn rate [rad/s]").within(0.1, 2.0).shows_default();
  verb.option(
      "--poses", options.poses,
      "Takes ends and corners from this topic of a localization that has the laser and a map, such as amcl_pose; "
      "without it they are measured and typed in");
  verb.option("--namespace", options.ns, "Of the robot, among several");
  verb.option("--out", options.out,
              "Writes the corrected robot file here; default: over ROBOT, if you say so");
}

void add_calibrate(cli::Verb verb) {
  auto options = std::make_shared<CalibrateOptions>();
  cli::Verb odometry =
      verb.verb("odometry", "Wheel radius, ratio of the radii and wheel separation, on the floor");
  add_options(odometry, *options);
  odometry.run([options] { return calibrate_odometry_verb(*options); });
}

}  // namespace

BW_VERB(measure, "calibrate", "Measures what a robot file says of a robot", add_calibrate)

}  // namespace bw
