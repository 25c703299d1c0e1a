// What goes wrong with a laser beside sweeps that are lost, late or of another time (runtime/faults/message_faults.cpp).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/model/random.hpp"
#include "runtime/fault.hpp"

namespace bw {
namespace {

using sensor_msgs::msg::LaserScan;

struct LaserFrozen final : Fault {
  void configure(FaultSetup& setup) override {
    setup.messages<LaserScan>("scan", [this](LaserScan& scan, const FaultTick& tick) {
      if (tick.occurrence != occurrence_) kept_ = scan.ranges();
      occurrence_ = tick.occurrence;
      scan.ranges() = kept_;
      return kPasses;
    });
  }
  std::vector<float> kept_;
  std::int64_t occurrence_ = -1;
};

struct NoiseParameters {
  double sigma = 0.1, share = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("sigma", sigma, {.unit = "m", .min = 0, .max = 10, .doc = "standard deviation added to each range"});
    v("share", share,
      {.min = 0, .max = 1, .doc = "of the beams that end anywhere between 0 and their range"});
  }
};

struct LaserNoise final : Fault {
  void configure(FaultSetup& setup) override {
    const auto options = setup.parameters<NoiseParameters>();
    setup.messages<LaserScan>(
        "scan", [options, random = Random(setup.seed())](LaserScan& scan, const FaultTick&) mutable {
          for (float& range : scan.ranges()) {
            const bool is_stray = random.uniform() < options.share;
            const double error = options.sigma * random.normal();
            if (!std::isfinite(range)) continue;
            const double was = range;
            range = static_cast<float>(is_stray ? random.uniform(0.0, was) : std::max(0.0, was + error));
          }
          return kPasses;
        });
  }
};

}  // namespace

BW_FAULT(LaserFrozen, "laser_frozen", "the same sweep with new stamps")
BW_FAULT(LaserNoise, "laser_noise", "ranges are noisy, some beams end in the air")

}  // namespace bw
