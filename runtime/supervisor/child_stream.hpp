// One stream of a child, its standard output or error: from a pipe into its log and onto our own.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <unistd.h>

#include "runtime/supervisor/rotating_log.hpp"

namespace bw {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }
  [[nodiscard]] int get() const { return number_; }
  void reset() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

/// What the terminal, or who reads us, does not take at once is in the logs alone: nobody who looks on holds us up.
void pass_on(int descriptor, std::string_view text);

class ChildStream {
 public:
  /// `to`: our own descriptor that shows it.
  ChildStream(const std::filesystem::path& log, int to) : log_(log), to_(to) {}

  /// The end of a new pipe, for the child to write to. Throws std::runtime_error.
  Descriptor open();
  /// What is there by now, 256 kB at most: who prints without end does not keep us from the others.
  void drain();
  void close_pipe() { pipe_.reset(); }

  /// Readable when something is there; -1: none is open.
  [[nodiscard]] int descriptor() const { return pipe_.get(); }
  [[nodiscard]] std::string last_words() const { return log_.last_words(); }
  /// Why the log does not take it; empty: it does, or it was told.
  [[nodiscard]] std::string news_of_fault();

 private:
  RotatingLog log_;
  int to_;
  Descriptor pipe_;
  bool is_fault_told_ = false;
};

}  // namespace bw
