#include "components/lab/bench/slam/bench_kidnaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <fmt/format.h>
#include <nav_msgs/msg/odometry.hpp>
#include <nlohmann/json.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/messages/geometry.hpp"
#include "components/recordings/adaptor/recording_messages.hpp"
#include "runtime/base/quantile.hpp"
#include "runtime/host/host.hpp"
#include "runtime/host/lockstep_runner.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw {
namespace {

constexpr std::size_t kSamplesPerScan = 5;
constexpr int kStands = 50;                                     // samples
constexpr double kRightWithin = 0.5;                            // [m]
constexpr double kRightTurn = 10.0 * std::numbers::pi / 180.0;  // [rad]
constexpr double kWrongFrom = 1.0;                              // [m]
constexpr double kLongestWrong = 3.0;                           // [s]
constexpr double kSoon = 10.0;                                  // [s]
constexpr double kShortWay = 5.0;                               // [m]

/// Base and scanner of the log, carried about, and the judge of what SLAM says.
class CarriedRobot final : public Component {
 public:
  CarriedRobot(const RecordedDrive& drive, const KidnapOptions& options, std::vector<Kidnap>& kidnaps)
      : drive_(drive), truth_of_log_(drive), options_(options), kidnaps_(kidnaps), random_(options.seed) {}

  void configure(Setup& setup) override {
    finish_run_ = setup.finish_run();
    scan_ = setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor());
    odom_ = setup.output<nav_msgs::msg::Odometry>("odom");
    tf_static_ = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched());
    setup.input<nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50),
                                         [this](const auto& told, const Tick&) { judge(told); });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(), [this](const auto& all, const Tick&) { hear(all); }, Need::optional);
    setup.every(buildings::kOdometryPeriod, "drive", [this](const Tick& tick) { step(tick); });
  }

 private:
  void step(const Tick& tick) {
    if (tick.sequence == 0) {
      tf2_msgs::msg::TFMessage mount;
      mount.transforms().push_back(to_transform("base_link", drive_.scans.front().frame, tick.now, {}));
      tf_static_.publish(mount);
    }
    if (stands_ == 0 && is_over(tick.now)) {
      stands_ = kStands;
      is_taken_ = true;
    }
    if (stands_ == 0) {
      ++at_;
    } else if (--stands_ == 0 && std::exchange(is_taken_, false)) {
      if (kidnaps_.size() == static_cast<std::size_t>(options_.times))
        return finish_run_(true, "carried often enough");
      carry(tick.now);
      stands_ = kStands;
    }
    const Pose2 X_OB = X_OL_ * drive_.odometry[at_].X_OB;
    const Pose2 truth = truth_of_log_.at(drive_.truth[at_].time);
    if (!kidnaps_.empty() && !kidnaps_.back().found_after)
      kidnaps_.back().way += (truth.position() - here_.position()).norm();
    here_ = truth;
    truth_.emplace_back(tick.now, truth);
    if (truth_.size() > 100) truth_.pop_front();
    if (at_ % kSamplesPerScan == 0)
      scan_.publish(to_message(drive_.scans[at_ / kSamplesPerScan], drive_.scans.front().frame, tick.now));
    nav_msgs::msg::Odometry odometry;
    odometry.header(make_header("odom", tick.now));
    odometry.child_frame_id("base_link");
    odometry.pose().pose(to_pose(X_OB));
    if (stands_ == 0) odometry.twist().twist(to_twist_message(drive_.odometry[at_].twist));
    odom_.publish(odometry);
  }

  double seconds_since(Time now) const { return (now - *carried_).to_seconds(); }

  bool is_over(Time now) const {
    if (at_ % kSamplesPerScan != 0) return false;
    return at_ + kSamplesPerScan >= drive_.odometry.size() ||
           (carried_ && seconds_since(now) >= options_.stay);
  }

  /// To another place of the log.
  void carry(Time now) {
    const std::size_t stay =
        static_cast<std::size_t>(options_.stay / buildings::kOdometryPeriod.to_seconds());
    if (drive_.odometry.size() <= stay)
      throw std::runtime_error("the drive is too short to be carried about in");
    const std::size_t places = (drive_.odometry.size() - stay) / kSamplesPerScan;
    const Pose2 X_OB = X_OL_ * drive_.odometry[at_].X_OB;
    std::size_t to = at_;
    for (int tries = 0; tries < 1000; ++tries) {
      to = kSamplesPerScan * (random_() % places);
      if ((drive_.truth[to].position - here_.position()).norm() >= options_.least) break;
    }
    at_ = to;
    X_OL_ = X_OB * inverse(drive_.odometry[at_].X_OB);
    here_ = truth_of_log_.at(drive_.truth[at_].time);
    carried_ = now;
    wrong_since_.reset();
    kidnaps_.emplace_back();
  }

  void judge(const nav_msgs::msg::Odometry& told) {
    if (!carried_) return;
    const Time time = from_stamp(told.header().stamp());
    const auto truth = std::ranges::find(truth_, time, &std::pair<Time, Pose2>::first);
    if (truth == truth_.end() || time < *carried_) return;
    const Pose2 error = inverse(truth->second) * from_pose(told.pose().pose());
    Kidnap& kidnap = kidnaps_.back();
    const double off = error.position().norm();
    if (!kidnap.found_after && off <= kRightWithin && std::abs(error.theta) <= kRightTurn)
      kidnap.found_after = seconds_since(time);
    if (off <= kWrongFrom || !is_ok_) {
      wrong_since_.reset();
      return;
    }
    if (!wrong_since_) wrong_since_ = time;
    kidnap.wrong_while_ok = std::max(kidnap.wrong_while_ok, (time - *wrong_since_).to_seconds());
  }

  void hear(const diagnostic_msgs::msg::DiagnosticArray& all) {
    for (const auto& status : all.status())
      if (status.name().find("slam") != std::string::npos) is_ok_ = status.message().starts_with("OK");
  }

  const RecordedDrive& drive_;
  slam::TruthOfScans truth_of_log_;
  const KidnapOptions& options_;
  std::vector<Kidnap>& kidnaps_;
  std::mt19937_64 random_;
  std::function<void(bool, const std::string&)> finish_run_;
  Output<sensor_msgs::msg::LaserScan> scan_;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<tf2_msgs::msg::TFMessage> tf_static_;
  std::size_t at_ = 0;     ///< sample of the log, which the robot is at
  int stands_ = kStands;   ///< so many steps more
  bool is_taken_ = false;  ///< when it has stood
  Pose2 X_OL_;             ///< the log's odometry in the robot's, which knows of no carrying
  Pose2 here_;
  std::deque<std::pair<Time, Pose2>> truth_;  ///< of the last two seconds
  std::optional<Time> carried_;
  std::optional<Time> wrong_since_;
  bool is_ok_ = false;
};

}  // namespace

std::vector<Kidnap> drive_kidnapped(const RecordedDrive& drive, const KidnapOptions& options) {
  const TemporaryFolder folder;
  const std::filesystem::path graph = folder.path() / "kidnap.yaml";
  const Pose2 start = slam::TruthOfScans(drive).at(drive.truth.front().time);
  std::ofstream(graph) << fmt::format(
      "components: {{slam: {{parameters: {{folder: {}, map_start_pose: {{x: {}, y: {}, yaw: {}}}}}}}}}\n",
      folder.path().string(), start.x, start.y, wrap_angle(start.theta));
  std::vector<Kidnap> kidnaps;
  std::vector<ExtraComponent> extra;
  extra.push_back(
      {.name = "carried_robot", .component = std::make_unique<CarriedRobot>(drive, options, kidnaps)});
  HostOptions host_options;
  host_options.clock = ClockMode::lockstep;
  host_options.alone = true;
  Host host(load_graph(graph, options.set), host_options, std::move(extra));
  const RunEnd end = host.run(std::nullopt);
  if (end.has_thrown) throw std::runtime_error(end.reason);
  return kidnaps;
}

int bench_kidnaps(const BenchSlamArguments& arguments) {
  nlohmann::ordered_json places = nlohmann::ordered_json::array();
  for (const buildings::BuildingKind kind : arguments.kinds) {
    for (int i = 0; i < arguments.seeds; ++i) {
      const buildings::BuildingDriveOptions drive = drive_options(arguments, i);
      const buildings::Building building = buildings::make_building(kind, drive.seed);
      const std::vector<Kidnap> kidnaps =
          drive_kidnapped(buildings::drive_through(building, drive),
                          {.times = arguments.kidnaps, .seed = drive.seed, .set = arguments.set});
      std::vector<double> found_after;
      std::size_t soon = 0;
      std::size_t by_5m = 0;
      std::size_t wrong = 0;
      double longest = 0.0;
      nlohmann::ordered_json lines = nlohmann::ordered_json::array();
      for (const Kidnap& k : kidnaps) {
        if (k.found_after) found_after.push_back(*k.found_after);
        soon += k.found_after && *k.found_after <= kSoon ? 1 : 0;
        by_5m += k.found_after && k.way <= kShortWay ? 1 : 0;
        wrong += k.wrong_while_ok > kLongestWrong ? 1 : 0;
        longest = std::max(longest, k.wrong_while_ok);
        lines.push_back({{"found_after_s", k.found_after ? nlohmann::ordered_json(*k.found_after) : nullptr},
                         {"way_m", k.way},
                         {"wrong_while_ok_s", k.wrong_while_ok}});
      }
      std::printf(
          "%s",
          fmt::format(
              "{}: carried away {} times; found its place {} times, {} within {} s, {} within {} m{}; OK and more than 1 m off for more than {} s: {} (longest {:.1f} s)\n",
              building.name, kidnaps.size(), found_after.size(), soon, kSoon, by_5m, kShortWay,
              found_after.empty() ? ""
                                  : fmt::format("; after {:.1f} s at the median, {:.1f} at 95 %",
                                                quantile(found_after, 0.5), quantile(found_after, 0.95)),
              kLongestWrong, wrong, longest)
              .c_str());
      std::fflush(stdout);
      places.push_back({{"building", building.name}, {"kidnaps", lines}});
    }
  }
  write_json(arguments.json, {{"base", buildings::to_text(arguments.drive.base)}, {"buildings", places}});
  return 0;
}

}  // namespace bw
