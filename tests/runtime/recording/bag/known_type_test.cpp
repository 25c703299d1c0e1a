// Types of a bag against those of the build. The texts are as ROS 2's packages have them: comments, defaults,
// constants.
#include "runtime/recording/bag/known_type.hpp"

#include <gmock/gmock.h>

#include "runtime/recording/bag/ros2msg.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

BagTopic topic(const std::string& type, const std::string& text) {
  return {.name = "/a", .type = type, .schema_encoding = "ros2msg", .schema_text = text};
}

TEST(KnownType, EveryTypeOfTheBuildIsItself) {
  for (const TypeDescription* type : all_types()) {
    const KnownType known = known_type(topic(std::string(type->ros_name), schema_text(*type)));
    EXPECT_EQ(known.type, type) << type->ros_name << ": " << known.why;
  }
}

// A recording from a robot of another distribution, known by its schema or by its hash alone.
TEST(KnownType, LayoutsOfOtherDistributionsAreThemselves) {
  int by_text = 0;
  for (const TypeDescription* layout : other_layouts()) {
    const std::string name(layout->ros_name);
    const KnownType known = known_type(topic(name, schema_text(*layout)));
    ASSERT_NE(known.type, nullptr) << name << ": " << known.why;
    EXPECT_EQ(known.type->type_hash, layout->type_hash) << name;
    by_text += known.type == layout ? 1 : 0;
    const BagTopic hashed{.name = "/a", .type = name, .type_hash = std::string(layout->type_hash)};
    ASSERT_NE(known_type(hashed).type, nullptr) << name;
    EXPECT_EQ(known_type(hashed).type->type_hash, layout->type_hash) << name;
  }
  EXPECT_GT(by_text, 0);
  const BagTopic stranger{.name = "/a", .type = "nav2_msgs/action/Spin_Goal", .type_hash = "RIHS01_0"};
  EXPECT_EQ(known_type(stranger).type, nullptr);
}

TEST(KnownType, CommentsDefaultsConstantsAndShortNamesDoNotMatter) {
  const std::string text =
      "# This is a sweep.\r\n"
      "uint8 A_CONSTANT=3  # not on the wire\n"
      "string ANOTHER = 'with # inside'\n"
      "std_msgs/msg/Header header # timestamp in the header is\n"
      "\n"
      "float32 angle_min 1.5\n"
      "float32   angle_max\t# [rad]\n"
      "float32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
      "float32[] ranges\nfloat32[] intensities\n" +
      std::string(80, '=') + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
      std::string(80, '=') + "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
  const KnownType known = known_type(topic("sensor_msgs/msg/LaserScan", text));
  EXPECT_NE(known.type, nullptr);
  EXPECT_THAT(known.why, IsEmpty());
}

TEST(KnownType, NamesTheFirstFieldThatDiffers) {
  const auto why = [](const char* text) { return known_type(topic("geometry_msgs/msg/Twist", text)).why; };
  EXPECT_THAT(why("Vector3 linear\nVector3 turn\n"),
              HasSubstr("geometry_msgs/Vector3 turn where this build has geometry_msgs/Vector3 angular"));
  EXPECT_THAT(why("Vector3 linear\n"),
              HasSubstr("has nothing where this build has geometry_msgs/Vector3 angular"));
  EXPECT_THAT(why("Vector3 linear\nVector3 angular\nfloat64 more\n"),
              HasSubstr("float64 more where this build has nothing"));
  EXPECT_THAT(
      why("Vector3 linear\nVector3 angular\n===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat32 y\nfloat64 z\n"),
      HasSubstr("float32 linear.y where this build has float64 linear.y"));
}

TEST(KnownType, ATextThatContainsItselfEnds) {
  const std::string circle = "A a\n===\nMSG: p/A\nA a\n";
  EXPECT_FALSE(first_difference(parse_ros2msg("p/msg/B", circle), parse_ros2msg("p/msg/B", circle)));
}

TEST(KnownType, WithoutAHashAndASchemaTheNameMustDo) {
  const BagTopic old{.name = "/a", .type = "geometry_msgs/msg/Twist"};
  EXPECT_EQ(known_type(old).type, find_type("geometry_msgs/msg/Twist"));
  const BagTopic unknown{.name = "/a", .type = "my_msgs/msg/Mine"};
  EXPECT_EQ(known_type(unknown).type, nullptr);
  EXPECT_THAT(known_type(unknown).why, IsEmpty());
}

}  // namespace
}  // namespace bw::bag
