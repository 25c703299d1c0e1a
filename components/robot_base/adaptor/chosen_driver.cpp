#include "components/robot_base/adaptor/chosen_driver.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "components/robot_base/driver_registry.hpp"
#include "runtime/parameters/config_error.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/serial/device_link.hpp"

namespace bw {
namespace {

class FieldCounter final : public FieldVisitor {
 public:
  int fields = 0;

 private:
  void visit(std::string_view, FieldRef, const Field&) override { ++fields; }
};

/// A driver without any leaves those that stand there for another one alone: `--set
/// robot.base.driver=simulated`.
bool has_fields(AnyOptions options) {
  FieldCounter counter;
  options.fields(counter);
  return counter.fields > 0;
}

/// The whole section: which driver, and its parameters.
struct BaseSection {
  std::string driver;
  AnyOptions options;

  template <class Visitor>
  void fields(Visitor& v) {
    v("driver", driver, {.doc = "what speaks to the base"});
    options.fields(v);
  }
  std::optional<std::string> violated_rule() const { return options.violated_rule(); }
};

[[noreturn]] void refuse_unknown(const std::string& driver) {
  const std::vector<std::string> names = registered_drivers();
  const std::vector<std::string_view> known(names.begin(), names.end());
  Violation violation;
  violation.key = "robot.base.driver";
  violation.value = driver;
  violation.rule = unknown_rule("driver", driver, known);
  throw ConfigError(std::vector<Violation>{std::move(violation)});
}

}  // namespace

std::unique_ptr<Driver> make_chosen_driver(Setup& setup, const Robot& robot,
                                           std::function<void(Time now)> wake) {
  const std::string& name = robot.base.driver;
  const DriverType* type = find_driver(name);
  if (type == nullptr) refuse_unknown(name);
  BaseSection section{.driver = name, .options = type->defaults};
  if (has_fields(type->defaults)) section = setup.shared<BaseSection>("robot.base", std::move(section));
  return type->make(
      section.options,
      {.setup = setup,
       .robot = robot,
       .open_link =
           [&setup, &name](const PortOptions& port, std::vector<std::uint8_t> stop_frame) {
             if (stop_frame.empty() && !setup.is_lockstep())
               setup.log().warn(
                   "driver {} names no stop frame: its base is not stopped when this process is killed or hangs",
                   name);
             return device_link(setup, "base", port, std::move(stop_frame));
           },
       .wake = std::move(wake)});
}

}  // namespace bw
