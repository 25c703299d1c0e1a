#include "components/slam/sparsification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "components/slam/graph_file.hpp"
#include "components/slam/map_painter.hpp"
#include "components/slam/slam.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

Eigen::Matrix3d variances(double xy, double theta) { return Eigen::Vector3d{xy, xy, theta}.asDiagonal(); }

// Submap 1 between 0 and 2 on the drive, seen again by 5 and 6. All poses are of no turn, so that covariances of
// what is composed are sums, plus what the turn does with the arm.
TEST(Sparsification, EdgesOfWhatLeavesGoToTheSurestLoop) {
  std::vector<Pose2> poses(7);
  for (std::size_t k = 0; k < 5; ++k) poses[k] = {4.0 * static_cast<double>(k), 0.0, 0.0};
  poses[5] = {4.0, 0.3, 0.0};
  poses[6] = {4.0, -0.3, 0.0};
  std::vector<Edge> edges;
  const auto add = [&](std::size_t from, std::size_t to, const Eigen::Matrix3d& C, bool loop) {
    edges.push_back({from, to, {inverse(poses[from]) * poses[to], C}, loop});
  };
  for (std::size_t k = 1; k < 7; ++k) add(k - 1, k, variances(1e-5, 1e-6), false);
  add(1, 5, variances(2e-3, 1e-5), true);
  add(1, 6, variances(1e-3, 1e-5), true);
  const auto rest = marginalise(1, edges, poses);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->anchor, 6U) << "the surer one of the two";
  // Of 8 edges the four of submap 1 are gone; submap 6 has three of them instead: a loop to 5, and of the drive.
  ASSERT_EQ(rest->edges.size(), 7U);
  const auto found = [&](std::size_t from, std::size_t to, bool loop) {
    const auto at = std::ranges::find_if(
        rest->edges, [&](const Edge& e) { return e.from == from && e.to == to && e.loop == loop; });
    EXPECT_NE(at, rest->edges.end()) << from << " to " << to;
    return *at;
  };
  for (const auto& [from, to, loop] : {std::tuple(0U, 6U, false), {2U, 6U, false}, {5U, 6U, true}}) {
    const Edge edge = found(from, to, loop);
    EXPECT_LT(test::distance(edge.X.X, inverse(poses[from]) * poses[to]), 1e-12) << from;
  }
  // 2e-3 + 1e-3, and of the turn of both by the arm of 0.6 m: 5 sees 1 and 6 from where it stands, 0.3 m from 1.
  const Eigen::Matrix3d C = found(5, 6, true).X.covariance;
  EXPECT_NEAR(C(1, 1), 3e-3, 1e-12);
  EXPECT_NEAR(C(2, 2), 2e-5, 1e-12);
}

TEST(Sparsification, WithoutALoopThatAgreesNothingLeaves) {
  const std::vector<Pose2> poses{{}, {4.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  std::vector<Edge> edges;
  for (std::size_t k = 1; k < 4; ++k)
    edges.push_back({k - 1, k, {inverse(poses[k - 1]) * poses[k], variances(1e-4, 1e-5)}, false});
  EXPECT_FALSE(marginalise(0, edges, poses));
  // 1 m off with 1 cm of noise: chi-square 10,000.
  edges.push_back({0, 3, {Pose2{1.0, 0.0, 0.0}, variances(1e-4, 1e-5)}, true});
  EXPECT_FALSE(marginalise(0, edges, poses));
}

// One scan a submap, at places given; every beam is as long as `view`.
struct Visits {
  std::vector<Submap> submaps;
  std::vector<Pose2> X_MS;
  Nodes nodes;
  double view = 5.0;
  int beams = 360;

  void add(const Pose2& X_MB) {
    const std::size_t k = submaps.size();
    RangeImage image;
    image.angle_min = -std::numbers::pi * beams / 360.0;
    image.angle_increment = std::numbers::pi / 180.0;
    image.millimetres.assign(static_cast<std::size_t>(beams), static_cast<std::uint16_t>(1000.0 * view));
    nodes.emplace(k, Node{{}, {k, {}, 0.0}, std::make_shared<const RangeImage>(image)});
    Submap submap;
    submap.first_node = k;
    submap.last_node = k + 1;
    submaps.push_back(submap);
    X_MS.push_back(X_MB);
  }
  bool first_is_seen_again() const {
    std::vector<std::size_t> all(submaps.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return is_seen_again(0, all, submaps, X_MS, nodes);
  }
};

constexpr Pose2 kHere{};
constexpr Pose2 kAway{9.0, 0.0, 0.0};

TEST(Sparsification, APlaceIsSeenAgainByTwoVisitsOfItsOwn) {
  Visits visits;
  const auto drive = [&visits](const Pose2& X, int count) {
    for (int i = 0; i < count; ++i) visits.add(X);
  };
  drive(kHere, 5);  // waits there: one visit, the first
  EXPECT_FALSE(visits.first_is_seen_again());
  drive(kAway, 3);
  drive({0.5, 0.5, 2.0}, 2);
  EXPECT_FALSE(visits.first_is_seen_again());
  drive(kAway, 3);
  drive({0.0, 1.1, 0.0}, 1);
  EXPECT_FALSE(visits.first_is_seen_again()) << "1.1 m beside";
  drive(kAway, 3);
  drive({0.0, -0.9, 0.0}, 1);
  EXPECT_TRUE(visits.first_is_seen_again());
}

TEST(Sparsification, NotThroughAWallAndNotWithTheBackToIt) {
  const auto seen_from = [](double view, int beams, const Pose2& later) {
    Visits visits;
    visits.view = view;
    visits.beams = beams;
    for (const Pose2& X : {kHere, kAway, kAway, later, kAway, kAway, later}) visits.add(X);
    return visits.first_is_seen_again();
  };
  EXPECT_TRUE(seen_from(0.65, 360, {0.0, 0.5, 0.0}));
  EXPECT_FALSE(seen_from(0.4, 360, {0.0, 0.5, 0.0})) << "beams of both end 10 cm before the other";
  EXPECT_TRUE(seen_from(5.0, 180, {0.5, 0.0, 0.7})) << "turned by 40 of 45 degrees";
  EXPECT_FALSE(seen_from(5.0, 180, {0.5, 0.0, 0.9})) << "turned by 52";
}

// Ten times round the corridors; a box stands in one for the first three rounds.
struct Rounds {
  explicit Rounds(Slam& made) : slam(made) {}

  void drive() {
    StaticObstacles shapes = test::square_of_corridors();
    if (count < 3) test::add_box(shapes, {-1.0, -3.6}, {-0.4, -3.1});
    test::Scanner scanner(shapes, 0.01, 7 + static_cast<std::uint64_t>(count), {.beams = 180});
    const std::vector<Vector2> corners{{-5.0, -4.0}, {5.0, -4.0},  {5.0, 4.0},
                                       {-5.0, 4.0},  {-5.0, -4.0}, {-4.8, -4.0}};
    const std::vector<Pose2> X_WB = test::drive_along(corners, 0.2);
    const std::vector<Pose2> steps = test::odometry_of(X_WB, 0.01, 0.01);
    for (std::size_t k = 0; k < X_WB.size(); ++k, ++scans) {
      if (k == 0 && count > 0) X_start = X_OB * inverse(steps[0]) * Pose2{-0.2, 0.0, 0.0};
      X_OB = X_start * steps[k];
      slam.add(scanner.scan(Time::seconds(0.4 * scans), X_WB[k]), X_OB);
      while (slam.advance()) {
      }
    }
    ++count;
    X_WB0 = X_WB.front();
  }
  std::size_t there() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(slam.map(), [](const Submap& s) { return !s.marginalised; }));
  }
  // Cells that are occupied where the box was, in the frame of the first pose.
  int box() const {
    const OccupancyGrid grid = render(placed_scans(slam, X_WB0), 0.05);
    int occupied = 0;
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column) {
        const Vector2 p = grid.center(column, row);
        if (p.x() > -1.1 && p.x() < -0.3 && p.y() > -3.75 && p.y() < -3.25 && grid.at(column, row) > 50)
          ++occupied;
      }
    return occupied;
  }

  Slam& slam;
  Pose2 X_OB;
  Pose2 X_start;
  Pose2 X_WB0;
  int count = 0;
  int scans = 0;
};

// Once three rounds are there it is as large as it gets; a box that left is gone after two rounds without it, and not
// before one that was there. The graph, submaps gone, is saved and read as it is.
TEST(Sparsification, TheMapStaysAsLargeAsThePlace) {
  Slam slam{SlamOptions{}};
  Rounds rounds(slam);
  std::vector<std::size_t> there;
  std::vector<std::size_t> nodes;
  std::vector<std::size_t> edges;
  std::vector<int> box;
  for (int k = 0; k < 10; ++k) {
    rounds.drive();
    there.push_back(rounds.there());
    nodes.push_back(slam.nodes().size());
    edges.push_back(slam.edges().size());
    box.push_back(rounds.box());
  }
  EXPECT_GE(there[2], 15U) << "two rounds of 36 m and more, in submaps of 4 m that overlap by half";
  for (std::size_t k = 3; k < there.size(); ++k) {
    EXPECT_LE(static_cast<double>(there[k]), 1.2 * static_cast<double>(there[2])) << "round " << k + 1;
    EXPECT_LE(static_cast<double>(nodes[k]), 1.2 * static_cast<double>(nodes[2])) << "round " << k + 1;
    EXPECT_LE(static_cast<double>(edges[k]), 1.2 * static_cast<double>(edges[2])) << "round " << k + 1;
  }
  EXPECT_GE(box[2], 16) << "0.6 m of its near side and some of the others, on cells of 5 cm";
  EXPECT_EQ(box[5], 0) << "three rounds after it left";

  const std::string bytes = graph_bytes({{}, slam.save()});
  const GraphReading reading = read_graph(bytes);
  ASSERT_TRUE(reading.graph) << reading.fault;
  EXPECT_TRUE(graph_bytes(*reading.graph) == bytes);
}

}  // namespace
}  // namespace bw::slam
