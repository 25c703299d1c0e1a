// The driver that the robot file chooses. For the adaptor only.
#pragma once

#include <functional>
#include <memory>

#include "components/robot_base/driver.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Of section `base`, which is read strictly by its own field list. Throws ConfigError for a driver that
/// nobody registered.
std::unique_ptr<Driver> make_chosen_driver(Setup& setup, const Robot& robot,
                                           std::function<void(Time now)> wake);

}  // namespace bw
