// The drivers of this tree.
#include "components/robot_base/adaptor/eddie_driver.hpp"
#include "components/robot_base/adaptor/kobuki_driver.hpp"
#include "components/robot_base/adaptor/simulated_driver.hpp"
#include "components/robot_base/driver_registry.hpp"

namespace bw {

BW_DRIVER(SimulatedDriver, SimulatedDriverOptions, "simulated")
BW_DRIVER(KobukiDriver, KobukiDriverOptions, "kobuki")
BW_DRIVER(EddieDriver, EddieDriverOptions, "eddie")

}  // namespace bw
