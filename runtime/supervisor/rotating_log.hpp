// What a child prints, in a file that does not grow without end. A disk that takes no more costs lines and nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace bw {

class RotatingLog {
 public:
  /// At `most` bytes NAME becomes NAME.1, in place of the one before.
  explicit RotatingLog(std::filesystem::path path, std::uint64_t most = 10'000'000)
      : path_(std::move(path)), most_(most) {}
  ~RotatingLog();
  RotatingLog(const RotatingLog&) = delete;
  RotatingLog& operator=(const RotatingLog&) = delete;

  void write(std::string_view text);
  /// Why it does not write; empty: it does.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// The last line, of 500 bytes at most, on disk or not.
  [[nodiscard]] std::string last_words() const;
  /// From now on they are another run's.
  void forget_last_words() { last_.clear(); }

 private:
  bool open();

  std::filesystem::path path_;
  std::uint64_t most_;
  int file_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t lost_ = 0;
  std::string fault_;
  std::string last_;
};

}  // namespace bw
