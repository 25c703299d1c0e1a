#include "components/lab/bench/explore/bench_explore.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <queue>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/global_planner/planner.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/buildings/bases.hpp"
#include "components/lab/bench/buildings/known_map.hpp"
#include "components/lab/bench/buildings/route_follower.hpp"
#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/model/distance_transform.hpp"
#include "components/model/random.hpp"
#include "components/slam/map_painter.hpp"
#include "components/slam/slam.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using buildings::Building;
using nlohmann::ordered_json;

constexpr double kStep = 0.1;      // [s] between two scans
constexpr int kMapEvery = 20;      // steps, as slam publishes it
constexpr double kLongest = 7200;  // [s]
constexpr int kBeams = 360;
constexpr double kReach = 12.0;  // [m] of the laser
constexpr double kWanted = 0.98;
constexpr double kOdometryScale = 1.003;

/// The cells that the footprint can reach in the true map, from the start of the route.
class ReachableCells {
 public:
  ReachableCells(const Building& building, double radius) : map_(buildings::known_map(building)) {
    const std::vector<float> clearance = distance_field(map_, {});
    reachable_.assign(map_.cells.size(), false);
    const Vector2 start = building.route.front();
    std::vector<std::size_t> open{map_.index(map_.column_of(start.x()), map_.row_of(start.y()))};
    reachable_[open[0]] = true;
    const auto width = static_cast<std::size_t>(map_.width);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++count_;
      for (const std::size_t next : {at - 1, at + 1, at - width, at + width}) {
        if (next >= map_.cells.size() || reachable_[next] || map_.cells[next] != OccupancyGrid::kFree)
          continue;
        if (static_cast<double>(clearance[next]) < radius + 0.5 * map_.resolution) continue;
        reachable_[next] = true;
        open.push_back(next);
      }
    }
  }
  const OccupancyGrid& map() const { return map_; }
  bool at(std::size_t cell) const { return reachable_[cell]; }
  std::size_t count() const { return count_; }

  /// Share that `made`, in the same frame, has as free.
  double known_in(const OccupancyGrid& made) const {
    std::size_t known = 0;
    for (int row = 0; row < map_.height; ++row)
      for (int column = 0; column < map_.width; ++column) {
        if (!reachable_[map_.index(column, row)]) continue;
        const Vector2 p = map_.center(column, row);
        const int c = made.column_of(p.x());
        const int r = made.row_of(p.y());
        if (made.contains(c, r) && made.at(c, r) >= 0 && made.at(c, r) < 65) ++known;
      }
    return static_cast<double>(known) / static_cast<double>(count_);
  }

 private:
  OccupancyGrid map_;
  std::vector<bool> reachable_;
  std::size_t count_ = 0;
};

class World {
 public:
  World(const Building& building, std::uint64_t seed)
      : walls_(building.walls),
        random_(seed),
        X_WB_{building.route.front().x(), building.route.front().y(), 0.0} {}

  slam::Scan scan(Time time) {
    LaserSweep sweep{.time = time,
                     .angle_min = -std::numbers::pi,
                     .angle_increment = 2.0 * std::numbers::pi / kBeams,
                     .range_min = 0.1,
                     .range_max = kReach};
    ranges_.clear();
    for (int i = 0; i < kBeams; ++i) {
      const double hit = walls_.ray_hit(
          X_WB_.position(), direction(X_WB_.theta + sweep.angle_min + i * sweep.angle_increment), kReach);
      ranges_.push_back(hit >= kReach ? std::numeric_limits<float>::infinity()
                                      : static_cast<float>(hit + random_.normal(0.0, 0.01)));
    }
    sweep.ranges = ranges_;
    return slam::scan_of(sweep, {});
  }
  void drive(const Twist2& twist) {
    const Pose2 before = X_WB_;
    X_WB_ = advance_exact(X_WB_, twist, kStep);
    const Pose2 step = inverse(before) * X_WB_;
    X_OB_ = X_OB_ * Pose2{kOdometryScale * step.x, kOdometryScale * step.y,
                          kOdometryScale * step.theta + random_.normal(0.0, 0.002) * std::abs(twist.omega)};
    travel_ += step.position().norm();
  }
  bool touches(double radius) const { return walls_.clearance(X_WB_.position(), radius) < radius; }
  const Pose2& X_OB() const { return X_OB_; }
  const Pose2& X_WB() const { return X_WB_; }
  double travel() const { return travel_; }

 private:
  buildings::WallIndex walls_;
  Random random_;
  Pose2 X_WB_;
  Pose2 X_OB_;
  std::vector<float> ranges_;
  double travel_ = 0.0;
};

/// One robot that explores one building.
class Drive {
 public:
  Drive(const Building& building, std::uint64_t seed, const explore::ExplorerOptions& options)
      : world_(building, seed),
        footprint_(buildings::robot_of(buildings::DrivenBase::kobuki).outline()),
        reachable_(building, footprint_.radius),
        slam_(slam::SlamOptions{}),
        painter_(0.05, world_.X_WB()),
        X_WM_(world_.X_WB()),
        explorer_(options) {}

  Exploration run() {
    for (int k = 0; k * kStep < kLongest; ++k) {
      const slam::Tracked tracked = slam_.add(world_.scan(Time::seconds(k * kStep)), world_.X_OB());
      while (slam_.advance()) {
      }
      X_MB_ = X_WM_ * slam_.pose(tracked.placement);
      if (k == 0) explorer_.resume(X_MB_);
      if (k % kMapEvery == 0) use_map();
      if (explorer_.state() == explore::ExploreState::complete) break;
      go_on();
      const bool touches = world_.touches(footprint_.radius);
      if (touches && !touches_) ++result_.contacts;
      touches_ = touches;
    }
    result_.is_complete = explorer_.state() == explore::ExploreState::complete;
    result_.goals = explorer_.goals();
    result_.failed = explorer_.failed();
    result_.given_up = explorer_.given_up();
    if (result_.length == 0.0) result_.length = world_.travel();
    return result_;
  }

 private:
  void use_map() {
    painter_.finish(slam_);
    const OccupancyGrid map = painter_.grid();
    result_.known = reachable_.known_in(map);
    if (result_.known >= kWanted && result_.length_98 == 0.0) result_.length_98 = world_.travel();
    planner_.set_map(map, footprint_);
    const explore::ExploreStep step =
        explorer_.look(explore::find_frontiers(map, X_MB_.position(), {.radius = footprint_.radius}));
    if (step.goal) goal_ = step.goal;
    if (explorer_.state() == explore::ExploreState::returning && result_.length == 0.0)
      result_.length = world_.travel();
    plan();
  }

  void plan() {
    follower_.reset();
    if (!goal_) return;
    const PathResult planned = planner_.plan(X_MB_, *goal_);
    if (planned.status != PathStatus::ok) return end(false);
    std::vector<Vector2> route;
    for (const Pose2& X : planned.path) route.push_back(X.position());
    if (planned.length < kArrived) return end(true);
    follower_ = std::make_unique<buildings::RouteFollower>(route, buildings::FollowerOptions{});
  }

  void go_on() {
    if (!follower_) return;
    const auto twist = follower_->next(X_MB_);
    if (!twist) return end(true);
    world_.drive(*twist);
  }

  void end(bool reached) {
    follower_.reset();
    goal_.reset();
    explorer_.goal_ended(reached);
  }

  static constexpr double kArrived = 0.1;  // [m]

  World world_;
  Footprint footprint_;
  ReachableCells reachable_;
  slam::Slam slam_;
  slam::MapPainter painter_;
  Pose2 X_WM_;
  explore::Explorer explorer_;
  Planner planner_;
  std::optional<Pose2> goal_;
  std::unique_ptr<buildings::RouteFollower> follower_;
  Pose2 X_MB_;
  bool touches_ = false;
  Exploration result_;
};

std::string line_of(const std::string& building, const Exploration& e, const Exploration& nearest,
                    double tour) {
  return fmt::format(
      "{:<14}{} {:.2f} % known, {:.0f} m (98 % after {:.0f} m), contacts {}, goals {}, not reached {}, given up {}; nearest "
      "frontier {:.2f} % {:.0f} m (98 % after {:.0f} m); tour that knows it {:.0f} m\n",
      building, e.is_complete ? "complete" : "not complete", 100.0 * e.known, e.length, e.length_98,
      e.contacts, e.goals, e.failed, e.given_up, 100.0 * nearest.known, nearest.length, nearest.length_98,
      tour);
}

ordered_json json_of(const Exploration& e) {
  return {{"complete", e.is_complete},  {"known", e.known},      {"length_m", e.length},
          {"length_98_m", e.length_98}, {"goals", e.goals},      {"failed", e.failed},
          {"given_up", e.given_up},     {"contacts", e.contacts}};
}

}  // namespace

Exploration explore_building(const Building& building, std::uint64_t seed,
                             const explore::ExplorerOptions& options) {
  return Drive(building, seed, options).run();
}

double tour_length(const Building& building) {
  const double radius = buildings::robot_of(buildings::DrivenBase::kobuki).outline().radius;
  const ReachableCells reachable(building, radius);
  const OccupancyGrid& map = reachable.map();
  std::vector<bool> seen(map.cells.size(), false);
  std::size_t count = 0;
  const auto look = [&](const Vector2& from) {
    for (int beam = 0; beam < 2 * kBeams; ++beam) {
      const Vector2 step = direction(beam * std::numbers::pi / kBeams) * (0.5 * map.resolution);
      Vector2 p = from;
      for (double range = 0.0; range < kReach; range += 0.5 * map.resolution, p += step) {
        const int column = map.column_of(p.x());
        const int row = map.row_of(p.y());
        if (!map.contains(column, row) || map.at(column, row) != OccupancyGrid::kFree) break;
        const std::size_t cell = map.index(column, row);
        if (!seen[cell] && reachable.at(cell)) ++count;
        seen[cell] = true;
      }
    }
  };
  // A wavefront over cells that can be reached, in steps of 8 neighbours, to the nearest that was not seen.
  std::size_t at =
      map.index(map.column_of(building.route.front().x()), map.row_of(building.route.front().y()));
  const auto width = static_cast<std::size_t>(map.width);
  const auto centre = [&](std::size_t cell) {
    return map.center(static_cast<int>(cell % width), static_cast<int>(cell / width));
  };
  double length = 0.0;
  double since_look = 0.0;
  look(centre(at));
  while (static_cast<double>(count) < kWanted * static_cast<double>(reachable.count())) {
    std::vector<std::size_t> before(map.cells.size(), std::numeric_limits<std::size_t>::max());
    std::vector<double> far(map.cells.size(), std::numeric_limits<double>::infinity());
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    open.emplace(0.0, at);
    far[at] = 0.0;
    std::optional<std::size_t> found;
    while (!open.empty() && !found) {
      const auto [so_far, cell] = open.top();
      open.pop();
      if (so_far > far[cell]) continue;
      if (!seen[cell]) {
        found = cell;
        break;
      }
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const std::size_t next = cell + static_cast<std::size_t>(dy) * width + static_cast<std::size_t>(dx);
          if (next >= map.cells.size() || !reachable.at(next)) continue;
          const double total = so_far + std::hypot(dx, dy) * map.resolution;
          if (total >= far[next]) continue;
          far[next] = total;
          before[next] = cell;
          open.emplace(total, next);
        }
    }
    if (!found) break;
    std::vector<std::size_t> path{*found};
    while (path.back() != at) path.push_back(before[path.back()]);
    for (auto next = path.rbegin() + 1; next != path.rend() && !seen[*found]; ++next) {
      const double step = (centre(*next) - centre(at)).norm();
      length += step;
      since_look += step;
      at = *next;
      if (since_look < 0.5 && at != *found) continue;
      since_look = 0.0;
      look(centre(at));
    }
  }
  return length;
}

int bench_explore(const BenchExploreArguments& arguments) {
  ordered_json drives = ordered_json::array();
  std::string sums;
  for (const buildings::BuildingKind kind : arguments.kinds) {
    std::vector<double> known;
    std::vector<double> to_nearest;
    std::vector<double> to_tour;
    int contacts = 0;
    int complete = 0;
    for (int i = 0; i < arguments.seeds; ++i) {
      const std::uint64_t seed = arguments.first + static_cast<std::uint64_t>(i);
      const Building building = buildings::make_building(kind, seed);
      const Exploration explored = explore_building(building, seed, {});
      const Exploration nearest = explore_building(building, seed, {.gain_scale = 0.0});
      const double tour = tour_length(building);
      std::fputs(line_of(building.name, explored, nearest, tour).c_str(), stdout);
      std::fflush(stdout);
      known.push_back(explored.known);
      to_nearest.push_back(explored.length / nearest.length);
      if (explored.length_98 > 0.0) to_tour.push_back(explored.length_98 / tour);
      contacts += explored.contacts;
      complete += explored.is_complete ? 1 : 0;
      drives.push_back({{"building", building.name},
                        {"explored", json_of(explored)},
                        {"nearest_frontier", json_of(nearest)},
                        {"tour_m", tour}});
    }
    sums += fmt::format(
        "{}: complete {} of {}, known {:.2f} % in the median, {:.2f} % at least; contacts {}; path to that of the nearest "
        "frontier {:.2f}, at 98 % to that of a tour that knows the building {:.2f} (medians)\n",
        buildings::to_text(kind), complete, arguments.seeds, 100.0 * quantile(known, 0.5),
        100.0 * quantile(known, 0.0), contacts, quantile(to_nearest, 0.5), quantile(to_tour, 0.5));
  }
  std::fputs(sums.c_str(), stdout);
  write_json(arguments.json, {{"drives", drives}});
  return 0;
}

}  // namespace bw
