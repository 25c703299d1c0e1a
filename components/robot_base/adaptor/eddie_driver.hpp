// An Eddie at the port that the robot file names. For the adaptor only.
#pragma once

#include <optional>
#include <string>

#include "components/robot_base/driver.hpp"
#include "components/robot_base/eddie/eddie.hpp"
#include "runtime/serial/port_options.hpp"

namespace bw {

struct EddieDriverOptions {
  PortOptions port;
  eddie::EddieOptions base;

  template <class Visitor>
  void fields(Visitor& v) {
    port.fields(v);
    base.fields(v);
  }
  std::optional<std::string> violated_rule() const { return base.violated_rule(); }
};

class EddieDriver final : public eddie::Eddie {
 public:
  EddieDriver(const EddieDriverOptions& options, const DriverContext& context)
      : Eddie(options.base, context.robot, context.open_link(options.port, stop_frame())) {}
};

}  // namespace bw
