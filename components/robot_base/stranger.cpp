#include "components/robot_base/stranger.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bw {

void Stranger::add(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) newest_[count_++ % newest_.size()] = byte;
}

std::string Stranger::likeness() const {
  const std::size_t size = std::min<std::size_t>(count_, newest_.size());
  if (size == 0) return "nothing comes";
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(newest_[(count_ - size + i) % newest_.size()]);
  const auto has = [&](std::uint8_t first, std::uint8_t second) {
    const std::array<std::uint8_t, 2> pair = {first, second};
    return !std::ranges::search(bytes, pair).empty();
  };
  if (has(0xAA, 0x55)) return "it speaks as a Kobuki does (AA 55)";
  if (has(0xA5, 0x5A)) return "it speaks as an RPLIDAR does (A5 5A)";
  const auto is_text = [](std::uint8_t byte) {
    return byte == '\r' || byte == '\n' || byte == '\t' || (byte >= 32 && byte <= 126);
  };
  if (!std::ranges::all_of(bytes, is_text)) return "another device, or another speed of the line";
  const std::string text(bytes.begin(), bytes.end());
  return text.find("ERROR") == std::string::npos ? "it speaks in text"
                                                 : "it speaks in text, as a Parallax Eddie does (ERROR)";
}

}  // namespace bw
