// A cable of topics, for lock-step: bytes are messages, hashed, recorded and replayed as all others. Always
// plugged in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <std_msgs/msg/u_int8_multi_array.hpp>

#include "runtime/base/byte_link.hpp"
#include "runtime/component.hpp"

namespace bw {

class TopicLink final : public ByteLink {
 public:
  TopicLink(Setup& setup, const std::string& in, const std::string& out);

  const LinkState& update(Time) override { return state_; }
  std::span<const std::uint8_t> read() override;
  bool write(std::span<const std::uint8_t> bytes) override;
  void close(Time, const std::string&) override { ++state_.openings; }

 private:
  LinkState state_;
  Output<std_msgs::msg::UInt8MultiArray> out_;
  std::vector<std::uint8_t> waiting_;
  std::vector<std::uint8_t> read_;
};

}  // namespace bw
