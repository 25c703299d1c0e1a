// Tables that are compressed by gzip, whole and cut.
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <zlib.h>

#include "tests/runtime/recording/import/tables.hpp"

namespace bw::imports {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path write_compressed(const std::filesystem::path& file, const std::string& text) {
  const gzFile out = gzopen(file.c_str(), "wb");
  EXPECT_EQ(gzwrite(out, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
  EXPECT_EQ(gzclose(out), Z_OK);
  return file;
}

// Lines of two and of three beams in one table without a header, and a transform that is told once.
constexpr const char* kScans = R"(
tables:
  - file: scans.csv*
    columns: [t, "ranges[*]"]
    stamp: {column: t}
    messages:
      - topic: /tf_static
        type: tf2_msgs/msg/TFMessage
        once: true
        constants: {"transforms[0].child_frame_id": laser, "transforms[0].transform.translation.x": 22 cm}
      - topic: /scan
        type: sensor_msgs/msg/LaserScan
        fields:
          ranges: ranges
          angle_min: {by_count: {2: -0.5, 3: -1}, of: ranges}
          angle_increment: {by_count: {2: 1, 3: 1}, of: ranges}
)";
constexpr const char* kText = "1,2.5,3.5\n2,4,5,6\n3,7,8\n";

TEST(CompressedTables, HaveRowsOfDifferentLength) {
  const Tables tables;
  write_compressed(tables / "scans.csv.gz", kText);
  const ImportedLog log = tables.import(kScans);
  const auto scans = messages_of<sensor_msgs::msg::LaserScan>(log, "/scan");
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_THAT(scans[0].ranges(), ElementsAre(2.5F, 3.5F));
  EXPECT_FLOAT_EQ(scans[0].angle_min(), -0.5F);
  EXPECT_FLOAT_EQ(scans[0].angle_max(), 0.5F);
  EXPECT_THAT(scans[1].ranges(), ElementsAre(4.0F, 5.0F, 6.0F));
  EXPECT_FLOAT_EQ(scans[1].angle_min(), -1.0F);
  EXPECT_FLOAT_EQ(scans[1].angle_max(), 1.0F);
  const auto transforms = messages_of<tf2_msgs::msg::TFMessage>(log, "/tf_static");
  ASSERT_EQ(transforms.size(), 1U) << "once";
  EXPECT_NEAR(transforms[0].transforms().at(0).transform().translation().x(), 0.22, 1e-12);
}

// The bytes count, not the name.
TEST(CompressedTables, AreToldByTheirBytes) {
  const Tables tables;
  write_compressed(tables / "scans.csv", kText);
  EXPECT_EQ(messages_of<sensor_msgs::msg::LaserScan>(tables.import(kScans), "/scan").size(), 3U);
  tables.write("scans.csv", kText);
  EXPECT_EQ(messages_of<sensor_msgs::msg::LaserScan>(tables.import(kScans), "/scan").size(), 3U);
}

TEST(CompressedTables, ThatAreCutOrDamagedAreRefusedWithTheByte) {
  const Tables tables;
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += std::to_string(i) + "," + std::to_string(i * 7919 % 1000) + ",1\n";
  const auto file = write_compressed(tables / "scans.csv.gz", text);
  const auto size = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, size / 2);
  EXPECT_THAT(tables.refusal(kScans), HasSubstr("scans.csv.gz: byte " + std::to_string(size / 2) +
                                                ": the compressed data end in the middle: the file is cut"));
  write_compressed(file, text);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(static_cast<long>(size) - 8)
      .write("xxxx", 4);
  EXPECT_THAT(tables.refusal(kScans), HasSubstr(": incorrect data check"));
}

// What is wrong in a line is told as of any table.
TEST(CompressedTables, NameTheLine) {
  const Tables tables;
  write_compressed(tables / "scans.csv.gz", "1,2,3\n2,x,3\n");
  EXPECT_THAT(tables.refusal(kScans),
              HasSubstr("scans.csv.gz:2: column 2 (ranges) = 'x': is no finite number"));
  write_compressed(tables / "scans.csv.gz", "1,2,3,4,5\n");
  EXPECT_THAT(tables.refusal(kScans), HasSubstr("scans.csv.gz:1:"));
}

}  // namespace
}  // namespace bw::imports
