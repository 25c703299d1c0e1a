// The words of Slamtec's RPLIDAR protocol: requests to the device, the headers of its answers, and what the
// short answers hold.
// All numbers on the wire are little endian. Source: the public headers of Slamtec's SDK (sl_lidar_cmd.h,
// sl_lidar_protocol.h).
//
//   request   A5 command                                        without payload
//             A5 command size payload xor                       bit 7 of the command is set; xor of all bytes before it
//   answer    A5 5A, u32: length in bits 0..29 and 1 in bits 30..31 for an endless stream, u8 type; then the data
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/base/time.hpp"

namespace bw::laser {

enum class Command : std::uint8_t {
  scan = 0x20,  ///< starts the stream of nodes
  stop = 0x25,
  reset = 0x40,         ///< restarts the firmware; no answer
  info = 0x50,          ///< model, firmware, serial number
  health = 0x52,        ///< what the device thinks of itself
  sample_times = 0x59,  ///< firmware 1.17 and later
  motor_rpm = 0xA8,     ///< u16, S series
  motor_pwm = 0xF0,     ///< u16, A2 and A3
};

std::vector<std::uint8_t> request(Command command);
std::vector<std::uint8_t> request(Command command, std::uint16_t payload);

enum class AnswerType : std::uint8_t { info = 0x04, health = 0x06, sample_times = 0x15, nodes = 0x81 };

constexpr std::size_t kHeaderSize = 7;
constexpr std::size_t kInfoSize = 20;
constexpr std::size_t kHealthSize = 3;
constexpr std::size_t kSampleTimesSize = 4;
constexpr std::size_t kNodeSize = 5;

/// The header of an answer of one of those types with the length it must have; nothing otherwise.
std::optional<AnswerType> read_header(std::span<const std::uint8_t> bytes);
std::size_t size_of(AnswerType type);

/// What the motor hangs on.
enum class Model : std::uint8_t { automatic, a1, a2, a3, c1, s };
constexpr auto choice_table(Model) {
  return choices<Model>({{Model::automatic, "auto"},
                         {Model::a1, "a1"},
                         {Model::a2, "a2"},
                         {Model::a3, "a3"},
                         {Model::c1, "c1"},
                         {Model::s, "s"}});
}

struct Info {
  std::uint8_t model = 0;
  std::uint8_t firmware_major = 0;
  std::uint8_t firmware_minor = 0;
  std::uint8_t hardware = 0;
  std::array<std::uint8_t, 16> serial_number{};

  /// The family, by the upper four bits of the model; nothing for one that is none of them.
  std::optional<Model> family() const;
  /// "A1, firmware 1.29, hardware 7, serial number 0123..."
  std::string text() const;
};
Info read_info(std::span<const std::uint8_t, kInfoSize> bytes);

struct Health {
  enum class Status : std::uint8_t { good = 0, warning = 1, error = 2 };
  Status status = Status::good;
  std::uint16_t code = 0;
};
/// Nothing for a status that there is not.
std::optional<Health> read_health(std::span<const std::uint8_t, kHealthSize> bytes);

/// Between two nodes of the standard scan.
Duration read_sample_time(std::span<const std::uint8_t, kSampleTimesSize> bytes);

}  // namespace bw::laser
