// Lines of standard input, a terminal or not, without waiting for long.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/time.hpp"

namespace bw {

class Lines {
 public:
  /// The next whole line; nothing when none came within `limit`.
  std::optional<std::string> wait(Duration limit);
  bool is_over() const { return is_over_; }

 private:
  std::optional<std::string> next();

  std::string read_;
  bool is_over_ = false;
};

}  // namespace bw
