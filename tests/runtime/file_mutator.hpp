// Files as accidents and enemies leave them: cut, bits and bytes changed, lengths made huge, pieces missing or twice.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace bw::test {

class FileMutator {
 public:
  explicit FileMutator(std::uint64_t seed) : random_(seed) {}

  /// One in eight is cut; then one to four changes.
  std::string operator()(std::string bytes) {
    if (below(8) == 0) bytes.resize(below(bytes.size()));
    for (std::size_t k = 1 + below(4); k > 0 && !bytes.empty(); --k) change(bytes);
    return bytes;
  }
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

 private:
  void change(std::string& bytes) {
    // What may be a length or an index of 4 or 8 bytes, no number, a large one, zero.
    static const std::array<std::string, 7> kWords{
        std::string("\xff\xff\xff\x7f"),        std::string("\xff\xff\xff\xff"),
        std::string("\0\0\0\x80", 4),           std::string("\xff\xff\xff\xff\xff\xff\xff\x7f"),
        std::string("\0\0\0\0\0\0\xf8\x7f", 8), std::string("\0\0\0\0\0\0\x50\x7e", 8),
        std::string("\0\0\0\0\0\0\0\0", 8)};
    const std::size_t at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random_());
        return;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        return;
      case 2:  // a piece is missing
        bytes.erase(at, below(64));
        return;
      case 3:  // or comes twice
        bytes.insert(at, bytes.substr(below(bytes.size()), below(64)));
        return;
      default: {
        const std::string& word = kWords[below(kWords.size())];
        bytes.replace(at, std::min(word.size(), bytes.size() - at), word);
      }
    }
  }

  std::mt19937_64 random_;
};

}  // namespace bw::test
