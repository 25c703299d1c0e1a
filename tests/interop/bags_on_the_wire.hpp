// What the tests of `record` and of `replay` as topics share: messages, bags, and the program as a process.
#pragma once

#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <std_msgs/msg/string.hpp>

#include "runtime/dds/participant.hpp"
#include "runtime/recording/bag/bag_writer.hpp"
#include "runtime/recording/bag/qos_text.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {

using bag::Bytes;

inline Bytes text(const std::string& data) {
  std_msgs::msg::String message;
  message.data(data);
  Bytes cdr;
  serialize(message, cdr);
  return cdr;
}

/// A type that is not ours: `size` bytes, after the encapsulation.
inline Bytes unknown(std::size_t size, std::uint8_t first) {
  Bytes cdr = {0, 1, 0, 0};
  for (std::size_t i = 0; i < size; ++i) cdr.push_back(static_cast<std::uint8_t>(first + i));
  return cdr;
}

inline dds::ParticipantOptions local() {
  return {.network = dds::Network::from_environment(dds::Transport::localhost)};
}

inline const std::string kStringHash{MessageTraits<std_msgs::msg::String>::type_hash};

inline dds::EndpointOptions endpoint(const std::string& topic, const std::string& type, const Qos& qos,
                                     const std::string& hash = {}) {
  return {.topic = dds_topic(topic),
          .type = dds_type(type),
          .qos = qos,
          .user_data = user_data_of(hash),
          .heartbeat = Duration::milliseconds(50)};
}

inline bool is_matched(const dds::Writer& writer) {
  return eventually([&] { return writer.matched_readers() > 0; });
}

/// A message of a bag.
struct Recorded {
  std::string topic;
  Bytes cdr;
  bool operator==(const Recorded&) const = default;
  friend void PrintTo(const Recorded& r, std::ostream* out) {
    *out << r.topic << " of " << r.cdr.size() << " bytes";
  }
};

inline std::vector<Recorded> messages_of(const std::filesystem::path& path, const std::string& topic = {}) {
  const auto recording = bag::open_bag(path);
  std::vector<Recorded> out;
  const auto messages = recording->messages({});
  for (bag::BagMessage m; messages->next(m) == bag::Step::message;) {
    const std::string& name = recording->topics()[m.topic].name;
    if (topic.empty() || name == topic) out.push_back({name, {m.data.begin(), m.data.end()}});
  }
  return out;
}

inline Outcome bandwagon(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
  return run_to_end(arguments, std::chrono::seconds(60));
}

/// A verb of the program that goes on until Ctrl-C, seen by discovery when this object is there.
class Running {
 public:
  explicit Running(std::vector<std::string> arguments) {
    const dds::Participant witness(local());
    arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
    process_ = std::make_unique<Process>(arguments);
    is_there_ = eventually([&] { return !witness.remote_participants().empty() || !process_->running(); });
  }
  bool is_there() { return is_there_ && process_->running(); }
  Process& process() { return *process_; }
  /// Ctrl-C.
  Outcome stop() {
    process_->signal(SIGINT);
    const int status = process_->wait(std::chrono::seconds(20)).value_or(-1);
    return {.status = status, .out = process_->out(), .err = process_->err()};
  }

 private:
  std::unique_ptr<Process> process_;
  bool is_there_ = false;
};

}  // namespace bw::test
