// The part of robot_base that outlives its instances: hears `emergency_stop` in every state, and keeps the
// latch.
#pragma once

#include <functional>
#include <optional>

#include "components/robot_base/adaptor/emergency_stop_file.hpp"
#include "components/robot_base/emergency_stop.hpp"
#include "runtime/component.hpp"

namespace bw {

class EmergencyStopInputs {
 public:
  void configure(Setup& setup);

  /// From now on listed buttons have to be heard, and `on_change` is called with what is pressed or lifted.
  void begin(Time now, const EmergencyStopOptions& options, std::function<void(Time)> on_change);
  void end() { on_change_ = nullptr; }
  void step(Time now);
  /// Names that came after what they said. Now and then.
  void name();

  const EmergencyStop& stop() const { return stop_; }
  std::optional<std::string> refusal() const;
  /// What is to be said of it.
  std::string release();

 private:
  void hear(bool is_pressed, const Tick& tick);
  /// Into the file, when it is not what is there.
  void keep();

  EmergencyStop stop_;
  bool has_buttons_ = false;
  EmergencyStop::Record kept_;
  std::unique_ptr<EmergencyStopFile> file_;  ///< null in lock-step
  Writers* writers_ = nullptr;
  Logger log_;
  std::function<void(Time)> on_change_;  ///< null: nobody is active
};

}  // namespace bw
