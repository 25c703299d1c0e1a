// How an Eddie board reads its line: characters up to a carriage return, at most 254 of them; what is neither
// printable nor a tab is ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace bw::emulators {

struct EditedLine {
  std::string text;
  bool has_overflown = false;
};

class LineEditor {
 public:
  static constexpr std::size_t kMaxCharacters = 254;

  /// A line, when this byte ends one.
  std::optional<EditedLine> take(std::uint8_t byte) {
    constexpr std::uint8_t kReturn = 0x0D, kTab = 0x09;
    if (byte == kReturn) return std::exchange(line_, {});
    if (byte != kTab && (byte < 32 || byte > 126)) return std::nullopt;
    if (line_.text.size() < kMaxCharacters) {
      line_.text.push_back(static_cast<char>(byte));
    } else {
      line_.has_overflown = true;
    }
    return std::nullopt;
  }

 private:
  EditedLine line_;
};

}  // namespace bw::emulators
