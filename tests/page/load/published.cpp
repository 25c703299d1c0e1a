#include "tests/page/load/published.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "runtime/ros/dds_names.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {

Published::Published(const std::vector<std::string>& topics)
    : participant_({.network = dds::Network::from_environment(dds::Transport::localhost)}),
      received_(topics.size()) {
  for (const std::string& topic : topics) {
    dds::Endpoint writer;
    const bool is_there = eventually([&] {
      for (const dds::Endpoint& end : participant_.endpoints()) {
        if (end.is_writer && end.topic == dds_topic(topic)) writer = end;
      }
      return writer.is_writer;
    });
    if (!is_there) throw std::runtime_error("nobody publishes " + topic);
    // Reliable, and as deep as what can come between two looks at it.
    Qos qos = writer.qos;
    qos.depth = 10'000;
    readers_.push_back(participant_.create_reader(
        {.topic = writer.topic, .type = writer.type, .qos = qos, .user_data = {}}, [] {}));
  }
}

std::uint64_t Published::count(std::size_t topic, Time begin, Time end) {
  dds::Sample sample;
  while (readers_[topic]->take(sample)) received_[topic].push_back(sample.received);
  return static_cast<std::uint64_t>(
      std::ranges::count_if(received_[topic], [&](Time t) { return t >= begin && t < end; }));
}

}  // namespace bw::test
