#include "tests/interop/cable/commands_on_wire.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace bw::test {

std::vector<WireCommand> WireReader::read(const std::vector<Chunk>& chunks) {
  std::vector<WireCommand> commands;
  for (const Chunk& chunk : chunks) {
    if (chunk.plugging != plugging_) bytes_.clear();
    plugging_ = chunk.plugging;
    bytes_.append(chunk.bytes.begin(), chunk.bytes.end());
    bool is_command = false;
    int speed = 0;
    while (take_frame(is_command, speed))
      if (is_command) commands.push_back({chunk.time, chunk.plugging, speed});
  }
  return commands;
}

bool KobukiWire::take_frame(bool& is_command, int& speed) {
  const auto byte = [this](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(bytes_[i]));
  };
  is_command = false;
  const std::size_t start = std::min(bytes_.find("\xaa\x55"), bytes_.size());
  bytes_.erase(0, start);
  if (bytes_.size() < 4 || bytes_.size() < 4 + byte(2)) return false;
  const std::size_t end = 3 + byte(2);
  unsigned checksum = 0;
  for (std::size_t i = 2; i < end; ++i) checksum ^= byte(i);
  for (std::size_t i = 3; checksum == byte(end) && i + 1 < end; i += 2 + byte(i + 1)) {
    if (byte(i) != 1 || byte(i + 1) != 4 || i + 5 >= end) continue;
    is_command = true;
    speed = static_cast<std::int16_t>(byte(i + 2) | byte(i + 3) << 8);
  }
  bytes_.erase(0, end + 1);
  return true;
}

bool EddieWire::take_frame(bool& is_command, int& speed) {
  const std::size_t end = bytes_.find('\r');
  if (end == std::string::npos) return false;
  const std::string line = bytes_.substr(0, end);
  bytes_.erase(0, end + 1);
  unsigned left = 0, right = 0;
  const bool is_speed = std::sscanf(line.c_str(), "GOSPD %x %x", &left, &right) == 2;
  is_command = is_speed || line.starts_with("STOP");
  const int fastest =
      std::max(std::abs(static_cast<std::int16_t>(left)), std::abs(static_cast<std::int16_t>(right)));
  speed = is_speed ? fastest : 0;
  return true;
}

}  // namespace bw::test
