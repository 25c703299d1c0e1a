#include "components/lab/bench/buildings/building_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "components/lab/bench/buildings/building_people.hpp"
#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/model/sweep_motion.hpp"
#include "components/robot_base/encoder_odometry.hpp"
#include "components/world/random_streams.hpp"
#include "components/world/ray.hpp"

namespace bw::buildings {
namespace {

constexpr double kStep = 0.02;                 // [s]: kOdometryPeriod
constexpr std::int64_t kDay = 24 * 3600 * 50;  // [steps]
constexpr const char* kLaserFrame = "laser";

Time time_of_step(std::int64_t i) { return Time{} + kOdometryPeriod * i; }

ReferencePose reference(Time time, const Pose2& X) { return {time, X.position(), X.theta}; }
Pose2 pose_of(const ReferencePose& r) { return {r.position.x(), r.position.y(), *r.heading}; }

void check(const ScannerOptions& o) {
  const bool is_sound =
      o.beams >= 2 && o.angle_increment > 0.0 && o.range_max > o.range_min && o.noise >= 0.0;
  if (!is_sound) throw std::invalid_argument("no scanner has such beams");
  if (o.period <= Duration{} || o.period.nanoseconds % kOdometryPeriod.nanoseconds != 0)
    throw std::invalid_argument("the scanner's period must be a multiple of the odometry's");
  if (o.time_increment < 0.0 || Duration::seconds(o.time_increment * (o.beams - 1)) > o.period)
    throw std::invalid_argument("the beams of a scan must be taken within its period");
}

/// Drives the route so often: odometry and truth, and when each round begins.
std::vector<Time> drive_wheels(const Building& building, std::size_t rounds,
                               const BuildingDriveOptions& options, RecordedDrive& drive) {
  const Robot robot = robot_of(options.base);
  const WheelRadii radii = robot.wheel_radii();
  const StaticScene open_floor({}, std::nullopt);  // the route keeps clear of the walls
  RouteFollower follower(building.route, options.follower);
  DriveModel base(options.wheels.value_or(wheels_of(options.base)), robot, follower.start(),
                  random_stream(options.seed, RandomPurpose::wheels));
  EncoderOdometry odometry(robot, OdometryOptions{});
  drive.wheel_separation = robot.wheel_separation;
  std::vector<Time> begin{Time{}};

  for (std::int64_t i = 0;; ++i) {
    const Time now = time_of_step(i);
    odometry.add(now, {now, base.ticks().left, base.ticks().right});
    const WheelTravel& travel = odometry.travel();
    drive.odometry.push_back({now, odometry.state().X_OB,
                              to_twist({travel.left / kStep, travel.right / kStep}, robot.wheel_separation)});
    drive.truth.push_back(reference(now, base.pose()));
    if (options.longest && now - Time{} >= *options.longest) return begin;
    auto twist = follower.next(base.pose());
    if (!twist && begin.size() < rounds) {
      begin.push_back(now);
      follower = RouteFollower(building.route, options.follower);
      twist = follower.next(base.pose());
    }
    if (!twist) return begin;
    if (i > kDay) throw std::runtime_error(building.name + ": the route does not end");
    const WheelSpeeds wheels = to_wheel_speeds(*twist, robot.wheel_separation);
    base.command({wheels.left / radii.left, wheels.right / radii.right});
    base.step(kStep, open_floor);
  }
}

/// Scans along a drive whose truth is known, in the order of time.
class ScanTaker {
 public:
  ScanTaker(const Building& building, const BuildingDriveOptions& options, std::uint64_t seed,
            const std::vector<ReferencePose>& truth, Time start)
      : options_(options.scanner),
        truth_(truth),
        walls_(building.walls),
        people_(building, walls_, options.walkers, random_stream(seed, RandomPurpose::walkers)),
        random_(random_stream(seed, RandomPurpose::laser)),
        moved_to_(static_cast<std::size_t>((start - Time{}).nanoseconds / kOdometryPeriod.nanoseconds)) {}

  ScanSample take(Time stamp) {
    const ScannerOptions& o = options_;
    ScanSample scan{
        .time = stamp, .frame = kLaserFrame, .geometry = geometry(), .ranges = {}, .intensities = {}};
    scan.ranges.reserve(static_cast<std::size_t>(o.beams));
    move_to(stamp);
    for (int i = 0; i < o.beams; ++i) {
      if (o.time_increment > 0.0) move_to(stamp + Duration::seconds(i * o.time_increment));
      scan.ranges.push_back(range(o.angle_min + i * o.angle_increment));
    }
    return scan;
  }

 private:
  ScanGeometry geometry() const {
    const auto narrow = [](double value) { return static_cast<float>(value); };
    return {.angle_min = narrow(options_.angle_min),
            .angle_max = narrow(options_.angle_min + (options_.beams - 1) * options_.angle_increment),
            .angle_increment = narrow(options_.angle_increment),
            .time_increment = narrow(options_.time_increment),
            .period = narrow(options_.period.to_seconds()),
            .range_min = narrow(options_.range_min),
            .range_max = narrow(options_.range_max)};
  }

  void move_to(Time time) {
    const std::int64_t after_start = (time - Time{}).nanoseconds;
    const auto i = static_cast<std::size_t>(after_start / kOdometryPeriod.nanoseconds);
    const std::int64_t rest = after_start % kOdometryPeriod.nanoseconds;
    const Pose2 before = pose_of(truth_[i]);
    const double share = static_cast<double>(rest) / static_cast<double>(kOdometryPeriod.nanoseconds);
    X_map_laser_ = rest == 0 ? before : pose_between(before, pose_of(truth_[i + 1]), share);
    if (moved_to_ > i) return;
    for (; moved_to_ <= i; ++moved_to_) people_.step(kStep, truth_[moved_to_].position);
    legs_ = people_.legs();
    std::erase_if(legs_, [&](const Disc& leg) {
      constexpr double kMoves = 0.1;  // until people are moved again [m]
      return (leg.center - X_map_laser_.position()).norm() > options_.range_max + leg.radius + kMoves;
    });
  }

  float range(double angle) {
    const Vector2 looks = direction(X_map_laser_.theta + angle);
    double hit = walls_.ray_hit(X_map_laser_.position(), looks, options_.range_max);
    for (const Disc& leg : legs_) hit = std::min(hit, ray_hit(X_map_laser_.position(), looks, leg));
    // Drawn for every beam: what one beam meets never changes the noise of the next.
    const double measured = hit + options_.noise * random_.normal();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (hit >= options_.range_max || measured > options_.range_max) return kInfinity;
    return measured < options_.range_min ? -kInfinity : static_cast<float>(measured);
  }

  const ScannerOptions& options_;
  const std::vector<ReferencePose>& truth_;
  WallIndex walls_;
  BuildingPeople people_;
  Random random_;
  Pose2 X_map_laser_;
  std::vector<Disc> legs_;  ///< within reach
  std::size_t moved_to_;    ///< step up to which people have moved
};

}  // namespace

ScannerOptions front_scanner() {
  ScannerOptions scanner;
  scanner.beams = 180;
  scanner.angle_min = -89.5 * std::numbers::pi / 180.0;
  scanner.range_max = 30.0;
  return scanner;
}

RecordedDrive drive_through(const Building& building, const BuildingDriveOptions& options) {
  return drive_rounds(std::span(&building, 1), options).drive;
}

Rounds drive_rounds(std::span<const Building> rounds, const BuildingDriveOptions& options) {
  check(options.scanner);
  Rounds result;
  RecordedDrive& drive = result.drive;
  drive.mounts.push_back({.parent = "base_link", .child = kLaserFrame});
  result.begin = drive_wheels(rounds.front(), rounds.size(), options, drive);
  const Duration sweep = Duration::seconds(options.scanner.time_increment * (options.scanner.beams - 1));
  Time stamp;
  for (std::size_t k = 0; k < result.begin.size(); ++k) {
    const bool is_last = k + 1 == result.begin.size();
    const Time end = is_last ? drive.truth.back().time : result.begin[k + 1];
    ScanTaker scanner(rounds[k], options, options.seed + k, drive.truth, result.begin[k]);
    for (; is_last ? stamp + sweep <= end : stamp < end; stamp = stamp + options.scanner.period)
      drive.scans.push_back(scanner.take(stamp));
  }
  return result;
}

}  // namespace bw::buildings
