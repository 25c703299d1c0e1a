#include "runtime/serial/topic_link.hpp"

#include <utility>

namespace bw {

TopicLink::TopicLink(Setup& setup, const std::string& in, const std::string& out) {
  state_ = {.is_open = true, .device = out, .fault = {}, .openings = 1};
  out_ = setup.output<std_msgs::msg::UInt8MultiArray>(out, Qos::standard(1000));
  setup.input<std_msgs::msg::UInt8MultiArray>(
      in, Qos::standard(1000), [this](const auto& message, const Tick&) {
        waiting_.insert(waiting_.end(), message.data().begin(), message.data().end());
      });
}

std::span<const std::uint8_t> TopicLink::read() {
  read_ = std::exchange(waiting_, {});
  return read_;
}

bool TopicLink::write(std::span<const std::uint8_t> bytes) {
  std_msgs::msg::UInt8MultiArray message;
  message.data().assign(bytes.begin(), bytes.end());
  out_.publish(message);
  return true;
}

}  // namespace bw
