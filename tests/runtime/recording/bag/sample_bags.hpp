// Small bags of real messages, and ways to break them.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/type_registry.hpp"
#include "tests/idl/cdr_writer.hpp"
#include "tests/runtime/recording/bag/mcap_files.hpp"

namespace bw::bag {

/// One message of a bag: topic, log time [ns], bytes.
using Taken = std::tuple<std::string, std::int64_t, std::string>;

inline const std::vector<std::string>& sample_types() {
  static const std::vector<std::string> types = {"nav_msgs/msg/Odometry", "sensor_msgs/msg/LaserScan",
                                                 "std_msgs/msg/String"};
  return types;
}

/// `count` messages, 1 ms apart, of the three types in turn.
inline std::vector<Taken> sample_messages(int count) {
  std::vector<Taken> all;
  test::RandomPayload random(7, 6);
  for (int i = 0; i < count; ++i) {
    const std::string& type = sample_types()[static_cast<std::size_t>(i) % 3];
    const auto cdr = random(*find_type(type));
    all.emplace_back("/" + type, (i + 1) * 1'000'000, std::string(cdr.begin(), cdr.end()));
  }
  return all;
}

inline void declare_samples(mcap::Writer& writer) {
  for (std::uint16_t id = 1; id <= 3; ++id) {
    const TypeDescription& type = *find_type(sample_types()[id - 1U]);
    const std::string text = schema_text(type);
    writer.add_schema({.id = id,
                       .name = std::string(type.ros_name),
                       .encoding = "ros2msg",
                       .data = {text.begin(), text.end()}});
    writer.add_channel({.id = id,
                        .schema_id = id,
                        .topic = "/" + std::string(type.ros_name),
                        .message_encoding = "cdr",
                        .metadata = {{"topic_type_hash", std::string(type.type_hash)}}});
  }
}

inline void write_samples(mcap::Writer& writer, const std::vector<Taken>& messages) {
  std::uint16_t next = 0;
  for (const auto& [topic, time, data] : messages) {
    const auto stamp = static_cast<std::uint64_t>(time);
    writer.write(mcap::Message{.channel_id = static_cast<std::uint16_t>(next++ % 3 + 1),
                               .log_time = stamp,
                               .publish_time = stamp,
                               .data = mcap::as_bytes(data)});
  }
}

/// A closed file of several chunks, an attachment and a metadata record.
inline void write_sample_bag(const std::filesystem::path& file, const std::vector<Taken>& messages,
                             Compression compression, std::uint64_t chunk_size = 4096) {
  mcap::Writer writer(create_file(file), {.compression = compression, .chunk_size = chunk_size});
  declare_samples(writer);
  writer.write(mcap::Attachment{
      .log_time = 3, .create_time = 0, .name = "graph.yaml", .media_type = "text/yaml", .data = {'x', 'y'}});
  write_samples(writer, messages);
  writer.write(mcap::Metadata{.name = "bandwagon", .entries = {{"version", "1"}}});
  writer.close();
}

/// The same messages without chunks, indexes and summary, as the format allows.
inline std::string loose_sample_bag(const std::vector<Taken>& messages) {
  Bytes out(mcap::kMagic.begin(), mcap::kMagic.end());
  append(out, mcap::Header{"ros2", "another"});
  for (std::uint16_t id = 1; id <= 3; ++id) {
    const TypeDescription& type = *find_type(sample_types()[id - 1U]);
    const std::string name(type.ros_name);
    append(out, mcap::Schema{.id = id, .name = name, .encoding = "ros2msg", .data = {}});
    append(out,
           mcap::Channel{
               .id = id, .schema_id = id, .topic = "/" + name, .message_encoding = "cdr", .metadata = {}});
  }
  std::uint16_t next = 0;
  for (const auto& [topic, time, data] : messages) {
    const auto stamp = static_cast<std::uint64_t>(time);
    append(out, mcap::Message{.channel_id = static_cast<std::uint16_t>(next++ % 3 + 1),
                              .log_time = stamp,
                              .publish_time = stamp,
                              .data = mcap::as_bytes(data)});
  }
  mcap::append_data_end(out, 0);
  append(out, mcap::Footer{});
  out.insert(out.end(), mcap::kMagic.begin(), mcap::kMagic.end());
  return {out.begin(), out.end()};
}

/// As rosbag2 of Humble makes it.
inline void write_sample_sqlite(const std::filesystem::path& file, const std::vector<Taken>& messages) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  std::string sql =
      "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
      "INSERT INTO schema VALUES(3, 'humble');"
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
      " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
      " data BLOB NOT NULL);"
      "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
  for (int id = 1; id <= 3; ++id) {
    const std::string& type = sample_types()[static_cast<std::size_t>(id) - 1];
    sql +=
        "INSERT INTO topics VALUES(" + std::to_string(id) + ", '/" + type + "', '" + type + "', 'cdr', '');";
  }
  int next = 0;
  for (const auto& [topic, time, data] : messages) {
    sql += "INSERT INTO messages(topic_id, timestamp, data) VALUES(" + std::to_string(next++ % 3 + 1) + ", " +
           std::to_string(time) + ", x'";
    for (const char c : data) {
      constexpr const char* kDigits = "0123456789abcdef";
      sql += kDigits[static_cast<unsigned char>(c) >> 4U];
      sql += kDigits[static_cast<unsigned char>(c) & 15U];
    }
    sql += "');";
  }
  ASSERT_EQ(sqlite3_exec(database, ("BEGIN;" + sql + "COMMIT;").c_str(), nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
}

/// What is read, and what is said to be wrong.
struct Reading {
  std::vector<Taken> messages;
  std::vector<BagFault> faults;
};

inline Reading read_all(const Bag& bag) {
  Reading out{.messages = {}, .faults = bag.faults()};
  const auto messages = bag.messages({});
  BagMessage m;
  for (Step step = messages->next(m); step != Step::end; step = messages->next(m)) {
    if (step == Step::damaged) {
      out.faults.push_back(messages->fault());
    } else {
      out.messages.emplace_back(bag.topics()[m.topic].name, m.log_time.nanoseconds,
                                std::string(m.data.begin(), m.data.end()));
    }
  }
  return out;
}

}  // namespace bw::bag
