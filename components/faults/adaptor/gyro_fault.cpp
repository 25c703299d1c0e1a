// What goes wrong with an inertial unit beside readings that are lost (runtime/faults/message_faults.cpp).
#include <sensor_msgs/msg/imu.hpp>

#include "runtime/fault.hpp"

namespace bw {
namespace {

struct BiasParameters {
  double bias = 0.05;

  template <class Visitor>
  void fields(Visitor& v) {
    v("bias", bias, {.unit = "rad/s", .min = -10, .max = 10, .doc = "added to the turn rate"});
  }
};

struct GyroBias final : Fault {
  void configure(FaultSetup& setup) override {
    const double bias = setup.parameters<BiasParameters>().bias;
    setup.messages<sensor_msgs::msg::Imu>("imu", [bias](sensor_msgs::msg::Imu& imu, const FaultTick&) {
      imu.angular_velocity().z(imu.angular_velocity().z() + bias);
      return kPasses;
    });
  }
};

}  // namespace

BW_FAULT(GyroBias, "gyro_bias", "the turn rate is wrong by the same")

}  // namespace bw
