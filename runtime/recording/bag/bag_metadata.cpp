#include "runtime/recording/bag/bag_metadata.hpp"

#include <cstdlib>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

namespace bw::bag {
namespace {

constexpr const char* kTopKey = "rosbag2_bagfile_information";
constexpr int kOldest = 4;  // before, files were named with the folder in front
constexpr int kNewest = 9;

void write_body(YAML::Emitter& out, const BagMetadata& m) {
  const auto nanoseconds = [&out](const char* key, const char* inner, std::uint64_t value) {
    out << YAML::Key << key << YAML::Value << YAML::BeginMap << YAML::Key << inner << YAML::Value << value
        << YAML::EndMap;
  };
  out << YAML::BeginMap;
  out << YAML::Key << "version" << YAML::Value << 8;
  out << YAML::Key << "storage_identifier" << YAML::Value << m.storage;
  nanoseconds("duration", "nanoseconds", m.duration);
  nanoseconds("starting_time", "nanoseconds_since_epoch", m.start);
  out << YAML::Key << "message_count" << YAML::Value << m.message_count;
  out << YAML::Key << "topics_with_message_count" << YAML::Value << YAML::BeginSeq;
  for (const TopicMetadata& topic : m.topics) {
    out << YAML::BeginMap << YAML::Key << "topic_metadata" << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "name" << YAML::Value << topic.name;
    out << YAML::Key << "type" << YAML::Value << topic.type;
    out << YAML::Key << "serialization_format" << YAML::Value << topic.serialization_format;
    out << YAML::Key << "offered_qos_profiles" << YAML::Value << YAML::DoubleQuoted
        << topic.offered_qos_profiles;
    out << YAML::Key << "type_description_hash" << YAML::Value << YAML::DoubleQuoted << topic.type_hash;
    out << YAML::EndMap;
    out << YAML::Key << "message_count" << YAML::Value << topic.message_count << YAML::EndMap;
  }
  out << YAML::EndSeq;
  out << YAML::Key << "compression_format" << YAML::Value << YAML::DoubleQuoted << "";
  out << YAML::Key << "compression_mode" << YAML::Value << YAML::DoubleQuoted << "";
  out << YAML::Key << "relative_file_paths" << YAML::Value << YAML::BeginSeq;
  for (const FileMetadata& file : m.files) out << file.path;
  out << YAML::EndSeq;
  out << YAML::Key << "files" << YAML::Value << YAML::BeginSeq;
  for (const FileMetadata& file : m.files) {
    out << YAML::BeginMap << YAML::Key << "path" << YAML::Value << file.path;
    nanoseconds("starting_time", "nanoseconds_since_epoch", file.start);
    nanoseconds("duration", "nanoseconds", file.duration);
    out << YAML::Key << "message_count" << YAML::Value << file.message_count << YAML::EndMap;
  }
  out << YAML::EndSeq;
  out << YAML::Key << "custom_data" << YAML::Value << YAML::BeginMap << YAML::EndMap;
  out << YAML::Key << "ros_distro" << YAML::Value << YAML::DoubleQuoted << m.ros_distro;
  out << YAML::EndMap;
}

/// Reads keys that must be there, and says where when they are not.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    const std::string line = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
    throw std::runtime_error(file_ + line + ": " + what);
  }
  YAML::Node child(const YAML::Node& node, const char* key) const {
    if (!node.IsMap()) fail(node.Mark(), std::string("must be a map with the key ") + key);
    YAML::Node found = node[key];
    if (!found) fail(node.Mark(), std::string("the key ") + key + " is missing");
    return found;
  }
  template <class T>
  T value(const YAML::Node& node, const char* key) const {
    const YAML::Node found = child(node, key);
    try {
      return found.as<T>();
    } catch (const YAML::Exception&) {
      fail(found.Mark(), std::string(key) + " is not what it should be");
    }
  }
  YAML::Node list(const YAML::Node& node, const char* key) const {
    YAML::Node found = child(node, key);
    if (!found.IsSequence()) fail(found.Mark(), std::string(key) + " must be a list");
    return found;
  }
  BagMetadata read(const YAML::Node& body) const;

 private:
  TopicMetadata read_topic(const YAML::Node& entry, int version) const;

  std::string file_;
};

TopicMetadata Reader::read_topic(const YAML::Node& entry, int version) const {
  const YAML::Node inner = child(entry, "topic_metadata");
  TopicMetadata topic{.name = value<std::string>(inner, "name"),
                      .type = value<std::string>(inner, "type"),
                      .serialization_format = value<std::string>(inner, "serialization_format"),
                      .message_count = value<std::uint64_t>(entry, "message_count")};
  // A text until version 8, a list from 9 on.
  const YAML::Node qos = child(inner, "offered_qos_profiles");
  topic.offered_qos_profiles = qos.IsScalar() ? qos.Scalar() : YAML::Dump(qos);
  if (version >= 7) topic.type_hash = value<std::string>(inner, "type_description_hash");
  return topic;
}

BagMetadata Reader::read(const YAML::Node& body) const {
  BagMetadata m;
  m.version = value<int>(body, "version");
  if (m.version < kOldest || m.version > kNewest) {
    fail(child(body, "version").Mark(), "version " + std::to_string(m.version) + " is not read; 4 to 9 are");
  }
  m.storage = value<std::string>(body, "storage_identifier");
  m.duration = value<std::uint64_t>(child(body, "duration"), "nanoseconds");
  m.start = value<std::uint64_t>(child(body, "starting_time"), "nanoseconds_since_epoch");
  m.message_count = value<std::uint64_t>(body, "message_count");
  for (const YAML::Node& entry : list(body, "topics_with_message_count")) {
    m.topics.push_back(read_topic(entry, m.version));
  }
  if (const auto format = value<std::string>(body, "compression_format"); !format.empty()) {
    fail(child(body, "compression_format").Mark(),
         "files compressed from outside (" + format +
             ") are not read; decompress them, or record with chunk compression");
  }
  for (const YAML::Node& path : list(body, "relative_file_paths"))
    m.files.push_back({.path = path.as<std::string>("")});
  if (m.version >= 8) m.ros_distro = value<std::string>(body, "ros_distro");
  if (m.version < 5) return m;
  const YAML::Node files = list(body, "files");
  for (std::size_t i = 0; i < files.size() && i < m.files.size(); ++i) {
    m.files[i].start = value<std::uint64_t>(child(files[i], "starting_time"), "nanoseconds_since_epoch");
    m.files[i].duration = value<std::uint64_t>(child(files[i], "duration"), "nanoseconds");
    m.files[i].message_count = value<std::uint64_t>(files[i], "message_count");
  }
  return m;
}

}  // namespace

std::string default_ros_distro() {
  const char* name = std::getenv("ROS_DISTRO");
  return name == nullptr || *name == '\0' ? "jazzy" : name;
}

std::string ros_distro_in(const std::map<std::string, std::map<std::string, std::string>>& records) {
  const auto record = records.find("rosbag2");
  if (record == records.end() || !record->second.contains("serialized_metadata")) return {};
  try {
    return YAML::Load(record->second.at("serialized_metadata"))["ros_distro"].as<std::string>("");
  } catch (const YAML::Exception&) {  // whoever wrote it, its messages can be read without
    return {};
  }
}

std::string to_yaml(const BagMetadata& metadata) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << kTopKey << YAML::Value;
  write_body(out, metadata);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

std::string to_record(const BagMetadata& metadata) {
  YAML::Emitter out;
  write_body(out, metadata);
  return std::string(out.c_str()) + "\n";
}

BagMetadata read_bag_metadata(const std::filesystem::path& file) {
  const Reader reader(file.string());
  try {
    return reader.read(reader.child(YAML::LoadFile(file.string()), kTopKey));
  } catch (const YAML::Exception& error) {
    reader.fail(error.mark, error.msg);
  }
}

}  // namespace bw::bag
