// Kinds of faults of a clock: of the components that they are of, in what these see and stamp. The machine's is left alone.
#include "runtime/fault.hpp"

namespace bw {
namespace {

struct StepParameters {
  double by = 3600.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("by", by,
      {.unit = "s", .min = -1e6, .max = 1e6, .doc = "it is wrong by this at once; below 0 it goes back"});
  }
};

struct ClockStep final : Fault {
  void configure(FaultSetup& setup) override {
    const Duration by = Duration::seconds(setup.parameters<StepParameters>().by);
    setup.clock([by](Duration) { return by; });
  }
};

struct RateParameters {
  double ppm = 500.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("ppm", ppm, {.min = -1e5, .max = 1e6, .doc = "it gains so many millionths; below 0 it loses them"});
  }
};

struct ClockRate final : Fault {
  void configure(FaultSetup& setup) override {
    const double share = setup.parameters<RateParameters>().ppm * 1e-6;
    setup.clock([share](Duration since) { return Duration::seconds(share * since.to_seconds()); });
  }
};

}  // namespace

BW_FAULT(ClockStep, "clock_step", "the clock of a component or process is set; at the end it is set right")
BW_FAULT(ClockRate, "clock_rate",
         "the clock of a component or process runs fast or slow; at the end it is set right")

}  // namespace bw
