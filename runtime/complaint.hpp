// What is wrong at present, so that it is told once when it begins, when it changes, and when it is over.
#pragma once

#include <string>
#include <utility>

namespace bw {

class Complaint {
 public:
  /// `at_first`: what is wrong before anything was heard; empty: nothing.
  explicit Complaint(std::string at_first = {}) : what_(std::move(at_first)) {}

  /// True when it is news; empty: nothing is wrong.
  bool is_news(const std::string& what) {
    if (what == what_) return false;
    what_ = what;
    return true;
  }
  explicit operator bool() const { return !what_.empty(); }
  const std::string& what() const { return what_; }

 private:
  std::string what_;
};

}  // namespace bw
