#include "components/robot_base/eddie/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace bw::eddie {

std::string command(std::string_view word, std::initializer_list<int> numbers) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text(word);
  for (const int number : numbers) {
    const unsigned bits = static_cast<unsigned>(number) & 0xFFFFU;
    text += ' ';
    bool has_begun = false;
    for (int shift = 12; shift >= 0; shift -= 4) {
      const unsigned digit = bits >> static_cast<unsigned>(shift) & 0xFU;
      has_begun |= digit != 0 || shift == 0;
      if (has_begun) text += kDigits[digit];
    }
  }
  return text + '\r';
}

int to_word(double value) {
  if (!std::isfinite(value)) return 0;
  return static_cast<int>(std::lround(std::clamp(value, -32'768.0, 32'767.0)));
}

std::optional<std::string> error_of(std::string_view line) {
  constexpr std::string_view kError = "ERROR", kReason = " - ";
  if (!line.starts_with(kError)) return std::nullopt;
  line.remove_prefix(kError.size());
  if (line.starts_with(kReason)) line.remove_prefix(kReason.size());
  return std::string(line);
}

std::optional<std::vector<std::uint32_t>> numbers_of(std::string_view line, std::size_t digits) {
  std::vector<std::uint32_t> numbers;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    std::uint32_t number = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number, 16);
    if (word.size() != digits || error != std::errc{} || rest != word.data() + word.size())
      return std::nullopt;
    numbers.push_back(number);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return numbers;
}

std::optional<Distances> distances_of(std::string_view line) {
  const auto numbers = numbers_of(line, 8);
  if (!numbers || numbers->size() != 2) return std::nullopt;
  return Distances{static_cast<std::int32_t>((*numbers)[0]), static_cast<std::int32_t>((*numbers)[1])};
}

}  // namespace bw::eddie
