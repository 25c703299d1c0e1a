// The base's rows of the failsafe table: its causes of a stop, the age of commands, and which of them holds.
#pragma once

#include <array>

#include "components/robot_base/base_guard.hpp"
#include "runtime/component.hpp"

namespace bw {

class BaseFailsafes {
 public:
  BaseFailsafes() = default;
  BaseFailsafes(Setup& setup, const BaseGuardOptions& options);

  void show(const BaseOutput& output) const;

 private:
  std::array<Failsafe, kStopCauses> causes_;
  Failsafe silent_;
};

}  // namespace bw
