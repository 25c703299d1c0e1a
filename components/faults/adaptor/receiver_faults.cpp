// What goes wrong with a receiver of satellites beside fixes that are lost or late (runtime/faults/message_faults.cpp).
#include <cmath>
#include <numbers>

#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "components/model/random.hpp"
#include "runtime/fault.hpp"

namespace bw {
namespace {

using sensor_msgs::msg::NavSatFix;

/// Metres on a sphere of the Earth's mean radius: exact to 0.5 %, and a fault needs no more.
void move(NavSatFix& fix, double east, double north) {
  constexpr double kDegreesPerMetre = 180.0 / (std::numbers::pi * 6'371'000.0);
  fix.longitude(fix.longitude() +
                east * kDegreesPerMetre / std::cos(fix.latitude() * std::numbers::pi / 180.0));
  fix.latitude(fix.latitude() + north * kDegreesPerMetre);
}

struct StepParameters {
  double east = 5.0, north = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("east", east, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "all fixes are wrong by this"});
    v("north", north, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "and by this"});
  }
};

struct ReceiverStep final : Fault {
  void configure(FaultSetup& setup) override {
    const auto step = setup.parameters<StepParameters>();
    setup.messages<NavSatFix>("gps/fix", [step](NavSatFix& fix, const FaultTick&) {
      move(fix, step.east, step.north);
      return kPasses;
    });
  }
};

struct OutlierParameters {
  double share = 0.02, distance = 42.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("share", share, {.min = 0, .max = 1, .doc = "of the fixes"});
    v("distance", distance,
      {.unit = "m", .min = 0, .max = 1e5, .doc = "that these are wrong, in any direction"});
  }
};

struct ReceiverOutliers final : Fault {
  void configure(FaultSetup& setup) override {
    const auto options = setup.parameters<OutlierParameters>();
    setup.messages<NavSatFix>(
        "gps/fix", [options, random = Random(setup.seed())](NavSatFix& fix, const FaultTick&) mutable {
          const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
          if (random.uniform() < options.share)
            move(fix, options.distance * std::cos(direction), options.distance * std::sin(direction));
          return kPasses;
        });
  }
};

}  // namespace

BW_FAULT(ReceiverStep, "receiver_step", "all fixes are wrong by the same, as under a reflecting wall")
BW_FAULT(ReceiverOutliers, "receiver_outliers", "some fixes are far off")

}  // namespace bw
