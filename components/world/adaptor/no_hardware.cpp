#include "components/world/adaptor/no_hardware.hpp"

#include <optional>
#include <string>

#include "runtime/serial/port_options.hpp"

namespace bw {
namespace {

/// What of section `base` says whether there is a device behind it.
struct BesideAWorld {
  static constexpr bool leaves_other_keys = true;
  std::string driver, port;

  template <class Visitor>
  void fields(Visitor& v) {
    v("driver", driver, {.doc = "what speaks to the base"});
    v("port", port, {.doc = "where it is plugged in"});
  }
  std::optional<std::string> violated_rule() const {
    if (port.empty() || port == kEmulatorPort) return std::nullopt;
    return "driver " + driver + " at " + port +
           " would move a real robot by a simulated world; with --emulate there is an emulator behind the cable, with "
           "--set robot.base.driver=simulated there is no cable";
  }
};

}  // namespace

void refuse_hardware(Setup& setup, const Robot& robot) {
  if (robot.base.driver != "simulated") setup.shared<BesideAWorld>("robot.base");
}

}  // namespace bw
