// Lines of standard input, a terminal or not, without waiting for long.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/time.hpp"
#include "runtime/cli/standard_input.hpp"

namespace bw {

class Lines {
 public:
  /// The next whole line; nothing when none came within `limit`.
  std::optional<std::string> wait(Duration limit);
  bool is_over() const { return input_.is_over(); }

 private:
  std::optional<std::string> next();

  cli::StandardInput input_;
  std::string read_;
};

}  // namespace bw
