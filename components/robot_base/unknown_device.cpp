#include "components/robot_base/unknown_device.hpp"

#include <algorithm>
#include <string_view>

namespace bw {

void UnknownDevice::add(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    is_heard_ = true;
    is_text_ &= byte == '\r' || byte == '\n' || byte == '\t' || (byte >= 32 && byte <= 126);
    std::ranges::rotate(newest_, newest_.begin() + 1);
    newest_.back() = static_cast<char>(byte);
    const std::string_view seen(newest_.data(), newest_.size());
    kobuki_headers_ += seen.ends_with("\xAA\x55") ? 1 : 0;
    rplidar_headers_ += seen.ends_with("\xA5\x5A") ? 1 : 0;
    error_words_ += seen == "ERROR" ? 1 : 0;
  }
}

std::string UnknownDevice::likeness() const {
  constexpr int kNoChance = 3;
  if (!is_heard_) return "nothing comes";
  if (kobuki_headers_ >= kNoChance) return "it speaks as a Kobuki does (AA 55)";
  if (rplidar_headers_ >= 1 && rplidar_headers_ >= kobuki_headers_)
    return "it speaks as an RPLIDAR does (A5 5A)";
  if (!is_text_) return "another device, or another speed of the line";
  return error_words_ == 0 ? "it speaks in text" : "it speaks in text, as a Parallax Eddie does (ERROR)";
}

}  // namespace bw
