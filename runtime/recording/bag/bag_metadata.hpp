// The metadata.yaml beside the files of a rosbag2 bag. Written in version 8, the newest whose QoS is a text
// as Humble reads it, with what Jazzy shows more; versions 4 to 9 are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bw::bag {

struct TopicMetadata {
  std::string name;
  std::string type;  ///< nav_msgs/msg/Odometry
  std::string serialization_format = "cdr";
  std::string offered_qos_profiles;  ///< YAML text (qos_text.hpp)
  std::string type_hash;             ///< empty before version 7
  std::uint64_t message_count = 0;
};

struct FileMetadata {
  std::string path;            ///< relative to the bag's folder
  std::uint64_t start = 0;     ///< [ns]
  std::uint64_t duration = 0;  ///< [ns]
  std::uint64_t message_count = 0;
};

struct BagMetadata {
  int version = 8;
  std::string storage = "mcap";  ///< or sqlite3
  std::uint64_t start = 0;       ///< [ns]
  std::uint64_t duration = 0;    ///< [ns]
  std::uint64_t message_count = 0;
  std::vector<TopicMetadata> topics;
  std::vector<FileMetadata> files;
  std::string ros_distro;  ///< whose layouts the messages have; empty: not told, as before version 8
};

/// As rosbag2 has it, ROS_DISTRO; without it Jazzy's, whose layouts this program speaks then.
[[nodiscard]] std::string default_ros_distro();
/// That of a bag, by its metadata records; empty when it does not tell.
[[nodiscard]] std::string ros_distro_in(
    const std::map<std::string, std::map<std::string, std::string>>& records);

/// The text of a metadata.yaml of version 8.
[[nodiscard]] std::string to_yaml(const BagMetadata& metadata);

/// The same without its top key: what the MCAP metadata record `rosbag2` holds.
[[nodiscard]] std::string to_record(const BagMetadata& metadata);

/// Throws std::runtime_error ("file:line: what is wrong").
[[nodiscard]] BagMetadata read_bag_metadata(const std::filesystem::path& file);

}  // namespace bw::bag
