#include "components/program/map/map_making.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/recordings/files/drive_of_bag.hpp"
#include "components/slam/map_painter.hpp"

namespace bw {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Topics of a type that hold messages, each once.
std::vector<std::string> topics_with(const bag::Bag& recording, std::string_view type) {
  std::vector<std::string> names;
  for (const bag::BagTopic& topic : recording.topics()) {
    const bool is_new = std::ranges::find(names, topic.name) == names.end();
    if (topic.type == type && topic.message_count > 0 && is_new) names.push_back(topic.name);
  }
  return names;
}

/// The asked one, the usual one, or the only one of its type.
template <class Message>
std::string topic_for(const bag::Bag& recording, const std::string& path, const std::string& asked,
                      const std::string& usual, const char* option) {
  const std::string_view type = MessageTraits<Message>::ros_name;
  const std::vector<std::string> there = topics_with(recording, type);
  const std::string& wanted = asked.empty() ? usual : asked;
  if (std::ranges::find(there, wanted) != there.end()) return wanted;
  if (asked.empty() && there.size() == 1) return there.front();
  if (there.empty()) {
    std::vector<std::string> all;
    for (const bag::BagTopic& topic : recording.topics()) all.push_back(topic.name);
    throw std::runtime_error(
        fmt::format("{}: no message of type {} in it, and there is no map without; its topics: {}", path,
                    type, all.empty() ? "none" : fmt::format("{}", fmt::join(all, ", "))));
  }
  throw std::runtime_error(fmt::format("{}: there is no {} of type {}; {} names one of: {}", path, wanted,
                                       type, option, fmt::join(there, ", ")));
}

DriveTopics topics_of(const bag::Bag& recording, const std::string& path, const MapMakingOptions& options) {
  DriveTopics topics{
      .odometry = "", .commands = "", .wheels = "", .imu = "", .fixes = "", .ranges = "", .truth = ""};
  topics.scans.clear();
  for (const std::string& asked : options.scans.empty() ? std::vector<std::string>{""} : options.scans)
    topics.scans.push_back(topic_for<sensor_msgs::msg::LaserScan>(recording, path, asked, "/scan", "--scan"));
  topics.odometry = topic_for<nav_msgs::msg::Odometry>(recording, path, options.odometry, "/odom", "--odom");
  return topics;
}

LoopResiduals residuals_of(const slam::Slam& made) {
  LoopResiduals r;
  const std::vector<Pose2>& X_MS = made.X_MS();
  const auto count = static_cast<double>(std::ranges::count_if(made.edges(), &slam::Edge::loop));
  for (const slam::Edge& edge : made.edges()) {
    if (!edge.loop) continue;
    const Pose2 difference = inverse(edge.X.X) * (inverse(X_MS[edge.from]) * X_MS[edge.to]);
    const double distance = difference.position().norm();
    const double turn = std::abs(difference.theta);
    r.mean += distance / count;
    r.mean_turn += turn / count;
    r.largest = std::max(r.largest, distance);
    r.largest_turn = std::max(r.largest_turn, turn);
  }
  return r;
}

BagDrive read_drive(const DriveBag& bag, const MapMakingOptions& options) {
  BagDrive read = drive_of_bag(bag.recording, topics_of(bag.recording, bag.path, options), bag.path);
  for (const bool scans : {true, false}) {
    if (scans ? !read.drive.scans.empty() : !read.drive.odometry.empty()) continue;
    throw std::runtime_error(fmt::format("{}: {} of use in it{}{}", bag.path,
                                         scans ? "no scan" : "no odometry", read.left_out.empty() ? "" : ": ",
                                         fmt::join(read.left_out, "; ")));
  }
  return read;
}

/// Adds what is told of one drive, whose scans are those from `first` on.
void add_drive(const slam::SlamReplay& replayed, std::size_t first, MadeMap& map) {
  const auto& scans = replayed.scans;
  if (first >= scans.size()) return;
  map.seconds += (scans.back().time - scans[first].time).to_seconds();
  for (std::size_t k = first + 1; k < scans.size(); ++k)
    map.travel += (replayed.pose(k).position() - replayed.pose(k - 1).position()).norm();
}

}  // namespace

MadeMap make_map(const std::vector<DriveBag>& bags, const MapMakingOptions& options,
                 const slam::SlamProgress& progress) {
  MadeMap map;
  slam::SlamReplay replayed(options.slam);
  const auto tell = [&](std::size_t done, std::size_t of) {
    map.is_whole = !progress || progress(done, of);
    return map.is_whole;
  };
  for (const DriveBag& bag : bags) {
    const BagDrive read = read_drive(bag, options);
    const std::size_t first = replayed.scans.size();
    const std::size_t sentences = replayed.left_out.size();
    const bool is_placed = slam::replay_more(replayed, read.drive, options.slam, {.progress = tell});
    map.scans += read.drive.scans.size();
    add_drive(replayed, first, map);
    for (const bag::BagFault& fault : bag.recording.faults())
      map.left_out.push_back(fmt::format("{}: byte {}: {}", fault.file.string(), fault.offset, fault.what));
    map.left_out.insert(map.left_out.end(), read.left_out.begin(), read.left_out.end());
    for (std::size_t i = sentences; i < replayed.left_out.size(); ++i)
      map.left_out.push_back((bags.size() > 1 ? bag.path + ": " : "") + replayed.left_out[i]);
    if (!is_placed && map.is_whole) map.unplaced = bag.path;
    if (!is_placed || !map.is_whole) break;
  }
  map.grid = slam::render(slam::placed_scans(replayed.slam, {}), options.slam.resolution);
  map.scans_used = replayed.scans.size();
  map.unmatched = replayed.slam.counts().unmatched;
  map.submaps = replayed.slam.submaps();
  map.loops = replayed.slam.loop_counts();
  map.residuals = residuals_of(replayed.slam);
  const auto free = std::ranges::count(map.grid.cells, OccupancyGrid::kFree);
  map.free_area = static_cast<double>(free) * map.grid.resolution * map.grid.resolution;
  return map;
}

std::string map_report(const MadeMap& map) {
  std::string text =
      fmt::format("scans     {} of {} used, {} of them by odometry alone; {:.0f} m in {:.0f} s\n",
                  map.scans_used, map.scans, map.unmatched, map.travel, map.seconds);
  for (const std::string& sentence : map.left_out) text += "          " + sentence + "\n";
  text += fmt::format("loops     {} closed of {} found, {} submaps, {} of them left since all was seen again",
                      map.loops.accepted, map.loops.found, map.submaps, map.loops.marginalised);
  if (map.loops.accepted > 0) {
    const LoopResiduals& r = map.residuals;
    text +=
        fmt::format("; what is left: {:.3f} m and {:.2f} deg in the mean, {:.3f} m and {:.2f} deg at most",
                    r.mean, r.mean_turn / kDegree, r.largest, r.largest_turn / kDegree);
  }
  text += fmt::format("\ncoverage  {:.1f} m2 free; {} x {} cells of {} m\n", map.free_area, map.grid.width,
                      map.grid.height, map.grid.resolution);
  return text;
}

}  // namespace bw
