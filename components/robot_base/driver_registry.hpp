// How a driver joins those that `base: {driver: NAME}` of a robot file chooses from, in this tree or in a
// library of another project that a graph names under `plugins:`.
//
//   struct TrolleyOptions { ... template <class Visitor> void fields(Visitor& v) { ... } };
//   class Trolley final : public bw::Driver {
//    public:
//     Trolley(const TrolleyOptions& options, const bw::DriverContext& context);
//     ...
//   };
//   BW_DRIVER(Trolley, TrolleyOptions, "trolley")
//
// Its parameters stand beside `driver` in the section `base` of the robot file. Making one opens no device
// and moves nothing.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/robot_base/driver.hpp"
#include "runtime/base/any_options.hpp"

namespace bw {

struct DriverType {
  AnyOptions defaults;
  std::function<std::unique_ptr<Driver>(const AnyOptions& options, const DriverContext& context)> make;
};

/// Throws std::logic_error when another one has that name.
bool register_driver(std::string_view name, DriverType type);
/// Null when nobody has that name.
const DriverType* find_driver(std::string_view name);
/// Sorted.
std::vector<std::string> registered_drivers();

template <class D, class Options>
bool register_driver_type(std::string_view name) {
  return register_driver(name,
                         {AnyOptions(Options{}), [](const AnyOptions& options, const DriverContext& context) {
                            return std::make_unique<D>(options.as<Options>(), context);
                          }});
}

}  // namespace bw

/// Makes a driver class known when its library is loaded. One per class, at namespace scope.
#define BW_DRIVER(driver, options, name)                      \
  [[maybe_unused]] static const bool bw_registered_##driver = \
      ::bw::register_driver_type<driver, options>(name);
