#include "runtime/serial/device_link.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include <std_msgs/msg/u_int8_multi_array.hpp>

namespace bw {
namespace {

/// Bytes as messages, in lock-step: always plugged in.
class TopicLink final : public ByteLink {
 public:
  TopicLink(Setup& setup, const std::string& in, const std::string& out) {
    state_ = {.is_open = true, .device = out, .fault = {}, .openings = 1};
    out_ = setup.output<std_msgs::msg::UInt8MultiArray>(out, Qos::standard(1000));
    setup.input<std_msgs::msg::UInt8MultiArray>(
        in, Qos::standard(1000), [this](const auto& message, const Tick&) {
          waiting_.insert(waiting_.end(), message.data().begin(), message.data().end());
        });
  }

  const LinkState& update(Time) override { return state_; }
  std::span<const std::uint8_t> read() override {
    read_ = std::exchange(waiting_, {});
    return read_;
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    std_msgs::msg::UInt8MultiArray message;
    message.data().assign(bytes.begin(), bytes.end());
    out_.publish(message);
    return true;
  }
  void close(Time, const std::string&) override { ++state_.openings; }

 private:
  LinkState state_;
  Output<std_msgs::msg::UInt8MultiArray> out_;
  std::vector<std::uint8_t> waiting_;
  std::vector<std::uint8_t> read_;
};

std::string topic(const std::string& name, const char* direction) { return "sim/" + name + "/" + direction; }

}  // namespace

std::unique_ptr<ByteLink> device_link(Setup& setup, const std::string& name, const PortOptions& options) {
  if (options.port == kEmulatorPort && setup.is_lockstep())
    return std::make_unique<TopicLink>(setup, topic(name, "from_device"), topic(name, "to_device"));
  throw std::runtime_error("serial ports are not there yet");
}

std::unique_ptr<ByteLink> emulator_link(Setup& setup, const std::string& name) {
  if (setup.is_lockstep())
    return std::make_unique<TopicLink>(setup, topic(name, "to_device"), topic(name, "from_device"));
  throw std::runtime_error("pseudo-terminals are not there yet");
}

}  // namespace bw
