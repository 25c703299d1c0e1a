// Small MCAP files for tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/recording/bag/mcap_messages.hpp"
#include "runtime/recording/bag/mcap_writer.hpp"
#include "tests/folder.hpp"

namespace bw::bag::mcap {

using test::Folder;

/// The words of the refusal.
inline std::string said_by(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// One message as the tests compare them.
struct Sample {
  std::uint16_t channel = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string data;
  bool operator==(const Sample&) const = default;
  friend void PrintTo(const Sample& s, std::ostream* out) {
    *out << s.channel << "@" << s.log_time << " " << s.data;
  }
};

inline BytesView as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Two channels of one schema, and one without.
inline void declare(Writer& writer) {
  writer.add_schema({.id = 1, .name = "std_msgs/msg/String", .encoding = "ros2msg", .data = {'s', 't', 'r'}});
  writer.add_channel(
      {.id = 1, .schema_id = 1, .topic = "/a", .message_encoding = "cdr", .metadata = {{"k", "v"}}});
  writer.add_channel({.id = 2, .schema_id = 1, .topic = "/b", .message_encoding = "cdr", .metadata = {}});
  writer.add_channel({.id = 7, .schema_id = 0, .topic = "/c", .message_encoding = "json", .metadata = {}});
}

inline void write_all(Writer& writer, const std::vector<Sample>& samples) {
  for (const Sample& s : samples) {
    writer.write(Message{.channel_id = s.channel,
                         .log_time = s.log_time,
                         .publish_time = s.publish_time,
                         .data = as_bytes(s.data)});
  }
}

/// `count` messages 1 ms apart, of all three channels, which compress well.
inline std::vector<Sample> rising(int count) {
  constexpr std::uint16_t kChannels[] = {1, 2, 7};
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back({.channel = kChannels[i % 3],
                       .log_time = static_cast<std::uint64_t>(i) * 1'000'000,
                       .publish_time = static_cast<std::uint64_t>(i) * 1'000'000 + 5,
                       .data = std::string(40 + i % 7, static_cast<char>('a' + i % 26))});
  }
  return samples;
}

struct ReadBack {
  std::vector<Sample> samples;
  std::vector<Fault> faults;
};

inline ReadBack read_back(const std::filesystem::path& path, const Selection& selection = {}) {
  const ByteSource file(path);
  const Contents contents = read_contents(file);
  ReadBack out;
  Messages messages(file, contents, selection);
  Message message;
  for (Step step = messages.next(message); step != Step::end; step = messages.next(message)) {
    if (step == Step::damaged) {
      out.faults.push_back(messages.fault());
      continue;
    }
    out.samples.push_back({message.channel_id, message.log_time, message.publish_time,
                           std::string(message.data.begin(), message.data.end())});
  }
  return out;
}

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A new file each time: file systems make sure that one that is written over reaches the disk, which takes
/// its time.
inline void write_content(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

}  // namespace bw::bag::mcap
