// Standard input, a terminal or not, without ever waiting for longer than asked.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/time.hpp"

namespace bw::cli {

class StandardInput {
 public:
  StandardInput();
  ~StandardInput();
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

  /// What came within `limit`; nothing when nothing did.
  std::optional<std::string> wait(Duration limit);
  /// What is there now. Nothing when Ctrl-C has emptied the terminal since somebody saw that it had input.
  std::optional<std::string> take();
  /// Leaves it to others from now on; wait() only waits.
  void ignore() { is_over_ = true; }
  /// It was closed, or is ignored.
  [[nodiscard]] bool is_over() const { return is_over_; }

 private:
  int descriptor_;
  bool is_over_ = false;
};

}  // namespace bw::cli
