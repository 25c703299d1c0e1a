// A bag of messages that a test writes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/schema.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw {

class TestBag {
 public:
  explicit TestBag(const std::filesystem::path& file) : writer_(removed(file), {}) {}

  template <class Message>
  void add(const std::string& topic, double log_seconds, const Message& message) {
    std::vector<std::uint8_t> bytes;
    serialize(message, bytes);
    add_bytes(topic, std::string(MessageTraits<Message>::ros_name), log_seconds, bytes);
  }
  void add_bytes(const std::string& topic, const std::string& type, double log_seconds,
                 const std::vector<std::uint8_t>& bytes) {
    std::size_t& number = topics_.try_emplace(topic, topics_.size()).first->second;
    if (number == writer_topics_)
      writer_topics_ = writer_.add_topic({.name = topic, .type = type, .schema_encoding = "ros2msg"}) + 1;
    writer_.write(number, Time::seconds(log_seconds), Time::seconds(log_seconds), bytes);
  }
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& entries) {
    writer_.add_metadata(name, entries);
  }
  void close() { writer_.close(); }

 private:
  static const std::filesystem::path& removed(const std::filesystem::path& file) {
    std::filesystem::remove(file);
    return file;
  }

  bag::BagWriter writer_;
  std::map<std::string, std::size_t> topics_;
  std::size_t writer_topics_ = 0;
};

}  // namespace bw
