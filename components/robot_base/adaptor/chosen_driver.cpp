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

}  // namespace

std::unique_ptr<Driver> make_chosen_driver(Setup& setup, const Robot& robot,
                                           std::function<void(Time now)> wake) {
  const std::string& name = robot.base.driver;
  const DriverType* type = find_driver(name);
  if (type == nullptr) {
    const std::vector<std::string> names = registered_drivers();
    const std::vector<std::string_view> known(names.begin(), names.end());
    Violation violation;
    violation.key = "robot.base.driver";
    violation.value = name;
    violation.rule = unknown_rule("driver", name, known);
    throw ConfigError(std::move(violation));
  }
  const auto section = setup.shared<BaseSection>("robot.base", {.driver = name, .options = type->defaults});
  return type->make(
      section.options,
      {.setup = setup,
       .robot = robot,
       .open_link = [&setup](const PortOptions& port) { return device_link(setup, "base", port); },
       .wake = std::move(wake)});
}

}  // namespace bw
