// A Kobuki at the port that the robot file names. For the adaptor only.
#pragma once

#include "components/robot_base/driver.hpp"
#include "components/robot_base/kobuki/kobuki.hpp"
#include "runtime/serial/port_options.hpp"

namespace bw {

struct KobukiDriverOptions {
  PortOptions port;
  kobuki::KobukiOptions base;

  template <class Visitor>
  void fields(Visitor& v) {
    port.fields(v);
    base.fields(v);
  }
};

class KobukiDriver final : public kobuki::Kobuki {
 public:
  KobukiDriver(const KobukiDriverOptions& options, const DriverContext& context)
      : Kobuki(options.base, context.robot.wheel_radii(), context.open_link(options.port, stop_frame())) {}
};

}  // namespace bw
