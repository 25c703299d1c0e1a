// The driver against the emulated device, byte by byte over a cable without a middleware: what goes over it,
// what is told when something is wrong, and how long that takes. Time is an argument; a step is 5 ms.
#include "components/laser/rplidar/rplidar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "components/emulators/rplidar/rplidar_device.hpp"
#include "components/laser/scan.hpp"

namespace bw::laser {
namespace {

using emulators::LaserView;
using emulators::RplidarDevice;
using emulators::RplidarDeviceOptions;
using emulators::RplidarFaults;
using Bytes = std::vector<std::uint8_t>;
using Level = RplidarStatus::Level;

/// The host's end; the test is the cable.
class Cable final : public ByteLink {
 public:
  const LinkState& update(Time) override {
    if (!state.is_open && is_plugged) {
      state = {.is_open = true, .device = "test", .fault = {}, .openings = state.openings + 1};
      from_device.clear();
    } else if (!is_plugged) {
      state.is_open = false;
      state.fault = "the cable is pulled";
    }
    return state;
  }
  std::span<const std::uint8_t> read() override {
    read_ = std::exchange(from_device, {});
    return read_;
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    if (!state.is_open) return false;
    to_device.insert(to_device.end(), bytes.begin(), bytes.end());
    written.insert(written.end(), bytes.begin(), bytes.end());
    return true;
  }
  void close(Time, const std::string&) override { state.is_open = false; }
  bool set_dtr(bool is_set) override {
    dtr = is_set;
    return true;
  }

  bool is_plugged = true;
  bool dtr = true;  ///< as an opened port has it
  LinkState state;
  Bytes from_device, to_device, written;

 private:
  Bytes read_;
};

/// Host and device in a room whose wall is at x = 2 m, and at 3 m all round elsewhere.
struct Rig {
  explicit Rig(const RplidarDeviceOptions& device_options = {}, const RplidarOptions& options = {})
      : device(device_options, 1), host(options, cable) {
    for (int i = 0; i < 1440; ++i) {
      const double angle = -3.14159265358979 + i * view_increment;
      room.push_back(static_cast<float>(std::cos(angle) > 2.0 / 3.0 ? 2.0 / std::cos(angle) : 3.0));
    }
  }

  void step() {
    now = now + Duration::milliseconds(5);
    if (cable.is_plugged) device.receive(now, std::exchange(cable.to_device, {}));
    const auto sent = device.step(now, {-3.14159265358979, view_increment, room});
    if (cable.is_plugged) cable.from_device.insert(cable.from_device.end(), sent.begin(), sent.end());
    for (Revolution& one : host.poll(now)) revolutions.push_back(std::move(one));
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 0.005 + 0.5); ++i) step();
  }
  /// [s] until the driver says so, at most `limit`.
  std::optional<double> time_until(Level level, double limit) {
    const Time start = now;
    while (host.status().level != level && (now - start).to_seconds() < limit) step();
    return host.status().level == level ? std::optional((now - start).to_seconds()) : std::nullopt;
  }

  double view_increment = 2.0 * 3.14159265358979 / 1440.0;
  std::vector<float> room;
  Time now = Time::seconds(100.0);
  Cable cable;
  RplidarDevice device;
  Rplidar host;
  std::vector<Revolution> revolutions;
};

TEST(Rplidar, ScansAndSaysWhatItIs) {
  Rig rig;
  rig.run(3.0);
  const RplidarStatus status = rig.host.status();
  EXPECT_EQ(status.level, Level::good) << status.text;
  ASSERT_TRUE(rig.host.info());
  EXPECT_EQ(rig.host.info()->family(), Model::a1);
  // 7 Hz of 2000 measurements a second: 285.7 in a revolution. Ends are known to one of them.
  EXPECT_NEAR(status.rate, 7.0, 7.0 / 285.0);
  EXPECT_NEAR(static_cast<double>(status.points), 285.7, 1.0);
  ASSERT_GE(rig.revolutions.size(), 12U) << "(3 s - 0.6 s of spin-up - first part of a turn) x 7";
  EXPECT_EQ(status.counters.at("losses_of_step"), 0U);
  EXPECT_EQ(status.counters.at("bytes_thrown_away"), 0U);
  EXPECT_EQ(status.counters.at("restarts"), 0U);
  // Whole requests in their order: stop, info, health, sample times, scan. Nothing else, and nothing before.
  EXPECT_EQ(rig.cable.written, (Bytes{0xA5, 0x25, 0xA5, 0x50, 0xA5, 0x52, 0xA5, 0x59, 0xA5, 0x20}));
}

// Wall at 2 m ahead: the view's beams are 0.25 degree apart and the device rounds to 1/64, so a sample is of
// a ray at most 0.133 degree beside its own; at 45 degrees (2.83 m) that is 2.83 x tan 45 x 0.00232 = 6.6 mm.
TEST(Rplidar, SeesTheWallWhereItStands) {
  Rig rig;
  rig.run(3.0);
  ASSERT_FALSE(rig.revolutions.empty());
  const Scan scan = to_scan(rig.revolutions.back(), {.beams = 360});
  for (int degrees = -45; degrees <= 45; ++degrees) {
    const double truth = 2.0 / std::cos(degrees * 3.14159265358979 / 180.0);
    EXPECT_NEAR(scan.ranges[static_cast<std::size_t>(180 + degrees)], truth, 0.0068) << degrees;
  }
  EXPECT_NEAR(scan.ranges[0], 3.0, 0.00013);
  EXPECT_NEAR(scan.scan_time, 1.0 / 7.0, 0.001);
}

// The motor of an A1 stands while DTR is set, and runs while it is cleared.
TEST(Rplidar, LetsTheMotorOfAnA1RunByDtr) {
  Rig rig;
  EXPECT_TRUE(rig.cable.dtr);
  rig.run(1.0);
  EXPECT_FALSE(rig.cable.dtr);
  rig.host.stop(rig.now);
  EXPECT_TRUE(rig.cable.dtr);
  Rig other({.model = 0x28});
  other.run(1.0);
  EXPECT_TRUE(other.cable.dtr) << "an A2's motor does not hang on it";
}

// An A2 is told how fast to rotate: PWM 600 = 0258h, A5^F0 = 55, ^02 = 57, ^58 = 0F, ^02 = 0D.
TEST(Rplidar, TellsTheMotorOfAnA2) {
  Rig rig({.model = 0x28, .rate = 10.0, .sample_time = 250e-6});
  rig.run(3.0);
  EXPECT_NEAR(rig.host.status().rate, 10.0, 0.03);
  const Bytes pwm = {0xA5, 0xF0, 0x02, 0x58, 0x02, 0x0D};
  EXPECT_NE(std::search(rig.cable.written.begin(), rig.cable.written.end(), pwm.begin(), pwm.end()),
            rig.cable.written.end());
  rig.host.stop(rig.now);
  rig.run(0.05);
  EXPECT_FALSE(rig.device.is_scanning());
  rig.host.stop(rig.now);
  rig.run(0.005);
  EXPECT_LT(rig.device.revolution_rate(), 10.0) << "slows down";
}

TEST(Rplidar, ASilentDeviceIsToldWithin300Ms) {
  Rig rig;
  rig.run(3.0);
  rig.device.set_faults({.silent = true});
  const auto told = rig.time_until(Level::error, 2.0);
  ASSERT_TRUE(told);
  EXPECT_LE(*told, 0.3);
  rig.run(1.0);
  EXPECT_GE(rig.host.status().counters.at("restarts"), 1U);
  rig.device.set_faults({});
  EXPECT_TRUE(rig.time_until(Level::good, 5.0)) << rig.host.status().text;
}

TEST(Rplidar, APulledCableIsToldAtOnceAndComesBack) {
  Rig rig;
  rig.run(3.0);
  rig.cable.is_plugged = false;
  const auto told = rig.time_until(Level::error, 1.0);
  ASSERT_TRUE(told);
  EXPECT_LE(*told, 0.005);
  EXPECT_EQ(rig.host.status().text, "the cable is pulled");
  rig.run(1.0);
  const std::size_t before = rig.revolutions.size();
  rig.cable.is_plugged = true;
  EXPECT_TRUE(rig.time_until(Level::good, 2.0)) << rig.host.status().text;
  rig.run(0.5);
  EXPECT_GT(rig.revolutions.size(), before);
  EXPECT_EQ(rig.host.status().counters.at("openings"), 2U);
}

// A topic, or an adapter that stays: nothing comes, nothing goes.
TEST(Rplidar, SaysWhenNobodyAnswers) {
  Rig rig;
  rig.device.set_faults({.silent = true});
  rig.run(6.0);
  EXPECT_EQ(rig.host.status().level, Level::error);
  EXPECT_EQ(rig.host.status().text, "no answer: is it an RPLIDAR, and has it power?");
  EXPECT_GE(rig.host.status().counters.at("resets"), 1U);
  EXPECT_TRUE(rig.revolutions.empty());
}

TEST(Rplidar, SaysWhenAnswersAreNoise) {
  Rig rig;
  rig.run(1.0);
  rig.device.set_faults({.garbage = true});
  rig.run(5.0);
  EXPECT_EQ(rig.host.status().level, Level::error);
  EXPECT_GT(rig.host.status().counters.at("bytes_thrown_away"), 1000U);
}

TEST(Rplidar, RefusesAnotherModel) {
  Rig rig({}, {.model = Model::a2});
  rig.run(3.0);
  EXPECT_EQ(rig.host.status().level, Level::error);
  EXPECT_NE(rig.host.status().text.find("a1 (model 24)"), std::string::npos) << rig.host.status().text;
  EXPECT_NE(rig.host.status().text.find("wants model a2"), std::string::npos) << rig.host.status().text;
  EXPECT_FALSE(rig.device.is_scanning());
  Rig unknown;
  unknown.device.set_faults({.other_model = true});
  unknown.run(3.0);
  EXPECT_NE(unknown.host.status().text.find("unknown (model 225)"), std::string::npos)
      << unknown.host.status().text;
}

TEST(Rplidar, TellsSickness) {
  Rig warned({.health = 1, .health_code = 7});
  warned.run(3.0);
  EXPECT_EQ(warned.host.status().level, Level::warning);
  EXPECT_EQ(warned.host.status().text, "scanning; the device warns of itself (code 7)");
  EXPECT_FALSE(warned.revolutions.empty());
  Rig broken({.health = 2, .health_code = 300});
  broken.run(3.0);
  EXPECT_EQ(broken.host.status().level, Level::error);
  EXPECT_EQ(broken.host.status().text, "the device says that it is broken (code 300)");
  EXPECT_GE(broken.host.status().counters.at("resets"), 1U);
  EXPECT_TRUE(broken.revolutions.empty());
}

// 7 Hz at 0.4 of the speed are 2.8: warned of, and the scans say so themselves: 1 / 2.8 = 0.357 s.
TEST(Rplidar, ASlowHeadIsWarnedOfAndMeasured) {
  Rig rig;
  rig.device.set_faults({.slow = 0.4});
  rig.run(5.0);
  EXPECT_EQ(rig.host.status().level, Level::warning);
  EXPECT_EQ(rig.host.status().text, "turns slower than 4.0 Hz");
  ASSERT_FALSE(rig.revolutions.empty());
  EXPECT_NEAR(to_scan(rig.revolutions.back(), {}).scan_time, 1.0 / 2.8, 0.001);
}

// While it slows down nothing is measured: silence, and a new beginning. Then nodes come, all of one angle: 5
// s are time to spin up.
TEST(Rplidar, AHeadThatStandsIsAnError) {
  Rig rig;
  rig.run(3.0);
  rig.device.set_faults({.slow = 0.0});
  const auto told = rig.time_until(Level::error, 1.0);
  ASSERT_TRUE(told);
  EXPECT_LE(*told, 0.3);
  rig.run(7.0);
  EXPECT_EQ(rig.host.status().level, Level::error);
  EXPECT_EQ(rig.host.status().text, "the head does not turn");
}

// One byte in 500 flipped and one in 500 lost: counted, and scans go on.
TEST(Rplidar, ABadCableIsCountedAndScansGoOn) {
  Rig rig;
  rig.device.set_faults({.corrupt = 0.002, .lost = 0.002});
  rig.run(10.0);
  EXPECT_GT(rig.host.status().counters.at("losses_of_step"), 50U)
      << "19,000 nodes, one of 50 hurt so that it shows";
  EXPECT_GT(rig.revolutions.size(), 55U);
  int unknown = 0;
  int beams = 0;
  for (const Revolution& one : rig.revolutions) {
    for (const float range : to_scan(one, {}).ranges) {
      unknown += std::isnan(range) ? 1 : 0;
      ++beams;
    }
  }
  EXPECT_LT(unknown, beams / 50) << "a lost node is between neighbours who are not";
}

// A program that begins while the device still scans for the one before it.
TEST(Rplidar, StopsAScanThatIsUnderWay) {
  Rig rig;
  rig.device.receive(rig.now, Bytes{0xA5, 0x20});
  for (int i = 0; i < 400; ++i) {
    rig.now = rig.now + Duration::milliseconds(5);
    const auto sent = rig.device.step(rig.now, {-3.14159265358979, rig.view_increment, rig.room});
    rig.cable.from_device.insert(rig.cable.from_device.end(), sent.begin(), sent.end());
  }
  EXPECT_TRUE(rig.time_until(Level::good, 2.0)) << rig.host.status().text;
  EXPECT_EQ(rig.host.status().counters.at("restarts"), 0U);
}

TEST(Rplidar, AClockThatGoesBackIsABeginning) {
  Rig rig;
  rig.run(3.0);
  rig.now = Time::seconds(50.0);
  EXPECT_TRUE(rig.time_until(Level::good, 2.0));
  rig.run(2.0);
  EXPECT_EQ(rig.host.status().level, Level::good) << rig.host.status().text;
  for (const Revolution& one : rig.revolutions) EXPECT_GT((one.next - one.first).to_seconds(), 0.0);
}

}  // namespace
}  // namespace bw::laser
