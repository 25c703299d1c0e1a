// Commands and replies of an Eddie's board, as text: words and hexadecimal numbers, two's complement where
// they are signed, one line each way, ended by CR (components/robot_base/eddie/README.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw::eddie {

/// "GOSPD 64 FFCE\r" of (100, -50); numbers are sent in 16 bits.
std::string command(std::string_view word, std::initializer_list<int> numbers = {});

/// Nearest number of 16 bits; not finite: 0.
int to_word(double value);

/// The reason of "ERROR - reason", "" of "ERROR" alone; nothing for other lines.
std::optional<std::string> error_of(std::string_view line);

/// Unsigned numbers of exactly so many digits each, parted by blanks; nothing unless the line is that.
std::optional<std::vector<std::uint32_t>> numbers_of(std::string_view line, std::size_t digits);

/// "LLLLLLLL RRRRRRRR".
struct Distances {
  std::int32_t left = 0, right = 0;
};
std::optional<Distances> distances_of(std::string_view line);

}  // namespace bw::eddie
