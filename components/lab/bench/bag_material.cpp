#include "components/lab/bench/bag_material.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

namespace bw {
namespace {

constexpr Duration kLength = Duration::milliseconds(10'000);

class Material {
 public:
  explicit Material(std::uint64_t seed) : random_(seed) {}

  BagMaterial make() {
    every<sensor_msgs::msg::Imu>("/imu", 10, [this](auto& imu, double) { fill(imu); });
    every<nav_msgs::msg::Odometry>("/odom", 20, [this](auto& odom, double t) { fill(odom, t); });
    every<tf2_msgs::msg::TFMessage>("/tf", 20, [this](auto& tf, double t) { fill(tf, t); });
    every<sensor_msgs::msg::LaserScan>("/scan", 25, [this](auto& scan, double t) { fill(scan, t); });
    every<nav_msgs::msg::OccupancyGrid>("/local_costmap", 100,
                                        [this](auto& grid, double t) { fill(grid, t); });
    std::ranges::stable_sort(material_.messages, {}, &BagMaterial::Message::at);
    material_.length = kLength;
    return std::move(material_);
  }

 private:
  template <class M, class Fill>
  void every(const std::string& name, std::int64_t period_ms, Fill fill_in) {
    const TypeDescription& type = MessageTraits<M>::description();
    material_.topics.push_back({.name = name,
                                .type = std::string(type.ros_name),
                                .offered_qos_profiles = bag::to_qos_text({Qos::standard()}),
                                .type_hash = std::string(type.type_hash),
                                .schema_encoding = "ros2msg",
                                .schema_text = bag::schema_text(type)});
    M message;
    for (Duration at; at < kLength; at = at + Duration::milliseconds(period_ms)) {
      fill_in(message, at.to_seconds());
      BagMaterial::Message& made = material_.messages.emplace_back();
      made.topic = material_.topics.size() - 1;
      made.at = at;
      serialize(message, made.cdr);
    }
  }

  double noise(double sigma) { return sigma * normal_(random_); }

  void fill(sensor_msgs::msg::Imu& imu) {
    imu.header().frame_id("imu_link");
    imu.angular_velocity().z(noise(0.02));
    imu.linear_acceleration().x(noise(0.1));
    imu.linear_acceleration().z(9.81 + noise(0.1));
  }
  void fill(nav_msgs::msg::Odometry& odom, double t) {
    odom.header().frame_id("odom");
    odom.child_frame_id("base_link");
    odom.pose().pose().position().x(t + noise(0.001));
    odom.pose().pose().orientation().w(1.0);
    odom.twist().twist().linear().x(1.0 + noise(0.01));
    for (std::size_t i = 0; i < 36; i += 7) odom.pose().covariance()[i] = 1e-3 * (1.0 + t);
  }
  void fill(tf2_msgs::msg::TFMessage& tf, double t) {
    tf.transforms().resize(1);
    auto& transform = tf.transforms()[0];
    transform.header().frame_id("odom");
    transform.child_frame_id("base_link");
    transform.transform().translation().x(t + noise(0.001));
    transform.transform().rotation().w(1.0);
  }
  /// A corridor 4 m wide, its end 20 m away.
  void fill(sensor_msgs::msg::LaserScan& scan, double t) {
    constexpr int kBeams = 1081;
    constexpr double kAperture = 4.712389;  // 270 degrees [rad]
    scan.header().frame_id("base_scan");
    scan.ranges().resize(kBeams);
    scan.intensities().resize(kBeams);
    for (int i = 0; i < kBeams; ++i) {
      const double angle = kAperture * (static_cast<double>(i) / (kBeams - 1) - 0.5);
      const double wall = 2.0 / std::max(std::abs(std::sin(angle)), 1e-3);
      const double range = std::min(wall, (20.0 - t) / std::max(std::cos(angle), 1e-3));
      const auto k = static_cast<std::size_t>(i);
      scan.ranges()[k] = static_cast<float>(range + noise(0.01));
      scan.intensities()[k] = std::floor(static_cast<float>(200.0 - range + noise(3.0)));
    }
  }
  /// 10 m at 5 cm: walls with their inflation, and what one sweep leaves of single cells.
  void fill(nav_msgs::msg::OccupancyGrid& grid, double t) {
    constexpr int kSide = 200;
    grid.header().frame_id("odom");
    grid.info().width(kSide);
    grid.info().height(kSide);
    grid.data().resize(kSide * kSide);
    for (int row = 0; row < kSide; ++row) {
      for (int column = 0; column < kSide; ++column) {
        const double from_wall =
            std::abs(std::abs(row - 100) - 40 - 3.0 * std::sin(0.1 * (column + 20.0 * t)));
        const double cost = 100.0 * std::exp(-0.3 * from_wall);
        grid.data()[static_cast<std::size_t>(row * kSide + column)] =
            static_cast<std::int8_t>(random_() % 200 == 0 ? 100 : static_cast<int>(cost));
      }
    }
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  BagMaterial material_;
};

}  // namespace

BagMaterial make_bag_material(std::uint64_t seed) { return Material(seed).make(); }

}  // namespace bw
