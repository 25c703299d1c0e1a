#include "components/program/calibrate/geometry_lines.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr WheelGeometry kFound{.radius = 0.0351234, .ratio = 1.00123, .separation = 0.231};

TEST(GeometryLines, AreWhatARobotFileTakes) {
  EXPECT_EQ(geometry_lines(kFound),
            "wheel_radius: 0.0351234\nwheel_radius_ratio: 1.00123\nwheel_separation: 0.231\n");
}

TEST(GeometryLines, ReplaceValuesAndLeaveAllElse) {
  EXPECT_EQ(with_geometry("# head\nname: x\nwheel_radius: 0.035           # [m] driver\n"
                          "wheel_separation: 0.230 # [m]\nlimits:\n  wheel_radius: 1\n",
                          kFound),
            "# head\nname: x\nwheel_radius: 0.0351234           # [m] driver\n"
            "wheel_radius_ratio: 1.00123   # right over left, by `bandwagon calibrate odometry`\n"
            "wheel_separation: 0.231 # [m]\nlimits:\n  wheel_radius: 1\n");
  EXPECT_EQ(with_geometry("wheel_separation: 1\nwheel_radius_ratio: 1.0\nwheel_radius: 2", kFound),
            "wheel_separation: 0.231\nwheel_radius_ratio: 1.00123\nwheel_radius: 0.0351234");
}

TEST(GeometryLines, AFileWithoutThemIsRefused) {
  EXPECT_THROW(with_geometry("name: x\nwheel_radius: 1\n", kFound), std::runtime_error);
  EXPECT_THROW(with_geometry("{wheel_radius: 1, wheel_separation: 2}", kFound), std::runtime_error);
  EXPECT_THROW(with_geometry("", kFound), std::runtime_error);
}

}  // namespace
}  // namespace bw
