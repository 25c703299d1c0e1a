#include "components/laser/rplidar/protocol.hpp"

#include <string_view>

namespace bw::laser {
namespace {

constexpr std::uint8_t kSync = 0xA5;
constexpr std::uint8_t kAnswerSync = 0x5A;
constexpr std::uint32_t kLengthMask = 0x3FFF'FFFF;
constexpr std::uint32_t kStream = 1;

std::uint16_t u16(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

}  // namespace

std::vector<std::uint8_t> request(Command command) { return {kSync, static_cast<std::uint8_t>(command)}; }

std::vector<std::uint8_t> request(Command command, std::uint16_t payload) {
  std::vector<std::uint8_t> bytes = {kSync, static_cast<std::uint8_t>(command), 2,
                                     static_cast<std::uint8_t>(payload & 0xFF),
                                     static_cast<std::uint8_t>(payload >> 8)};
  std::uint8_t checksum = 0;
  for (const std::uint8_t byte : bytes) checksum ^= byte;
  bytes.push_back(checksum);
  return bytes;
}

std::size_t size_of(AnswerType type) {
  switch (type) {
    case AnswerType::info:
      return kInfoSize;
    case AnswerType::health:
      return kHealthSize;
    case AnswerType::sample_times:
      return kSampleTimesSize;
    case AnswerType::nodes:
      return kNodeSize;
  }
  return 0;
}

std::optional<AnswerType> read_header(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderSize || bytes[0] != kSync || bytes[1] != kAnswerSync) return std::nullopt;
  const std::uint32_t word =
      static_cast<std::uint32_t>(u16(bytes, 2)) | static_cast<std::uint32_t>(u16(bytes, 4)) << 16;
  for (const AnswerType type :
       {AnswerType::info, AnswerType::health, AnswerType::sample_times, AnswerType::nodes}) {
    if (bytes[6] != static_cast<std::uint8_t>(type)) continue;
    const bool is_stream = word >> 30 == kStream;
    const bool is_sound =
        (word & kLengthMask) == size_of(type) && is_stream == (type == AnswerType::nodes) && word >> 30 <= 1;
    return is_sound ? std::optional(type) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<Model> Info::family() const {
  const int major = model >> 4;
  if (major <= 1) return Model::a1;
  if (major == 2) return Model::a2;
  if (major == 3) return Model::a3;
  if (major <= 5) return Model::c1;
  return major <= 8 ? std::optional(Model::s) : std::nullopt;
}

std::string Info::text() const {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const std::optional<Model> known = family();
  std::string text = known ? std::string(text_of(*known)) : "unknown";
  text += " (model " + std::to_string(model) + "), firmware " + std::to_string(firmware_major) + ".";
  if (firmware_minor < 10) text += "0";
  text += std::to_string(firmware_minor) + ", hardware " + std::to_string(hardware) + ", serial number ";
  for (const std::uint8_t byte : serial_number) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

Info read_info(std::span<const std::uint8_t, kInfoSize> bytes) {
  Info info{.model = bytes[0], .firmware_major = bytes[2], .firmware_minor = bytes[1], .hardware = bytes[3]};
  for (std::size_t i = 0; i < info.serial_number.size(); ++i) info.serial_number[i] = bytes[4 + i];
  return info;
}

std::optional<Health> read_health(std::span<const std::uint8_t, kHealthSize> bytes) {
  if (bytes[0] > 2) return std::nullopt;
  return Health{.status = static_cast<Health::Status>(bytes[0]), .code = u16(bytes, 1)};
}

Duration read_sample_time(std::span<const std::uint8_t, kSampleTimesSize> bytes) {
  return {u16(bytes, 0) * std::int64_t{1000}};
}

}  // namespace bw::laser
