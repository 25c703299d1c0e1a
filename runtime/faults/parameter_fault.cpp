// A component's parameters are others while it acts: what an emulated device offers as faults (components/emulators), or a
// simulated world.
#include "runtime/fault.hpp"

namespace bw {

struct OtherParameters final : Fault {
  void configure(FaultSetup& setup) override { setup.changes_parameters_of_component(); }
};

BW_FAULT(OtherParameters, "parameters",
         "parameters of a component are others, as faults.silent of base_emulator")

}  // namespace bw
