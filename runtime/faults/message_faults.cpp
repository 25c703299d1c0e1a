// Kinds of faults of any topic: messages that are lost, late, or of another time. What is of one sense only is registered under
// its name with its topic.
#include <cstring>
#include <random>

#include "runtime/fault.hpp"

namespace bw {
namespace {

/// In [0, 1), the same on every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1.0p-53; }

struct LostParameters {
  double share = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("share", share, {.min = 0, .max = 1, .doc = "of the messages, at random; 1: all, as by a cut"});
  }
};

class Lost final : public Fault {
 public:
  explicit Lost(std::string topic = {}) : topic_(std::move(topic)) {}
  void configure(FaultSetup& setup) override {
    const auto options = setup.parameters<LostParameters>();
    setup.bytes(topic_, [options, random = std::mt19937_64(setup.seed())](auto&, const FaultTick&) mutable {
      return uniform(random) < options.share ? kLost : kPasses;
    });
  }

 private:
  std::string topic_;
};

struct LateParameters {
  double delay = 0.3, jitter = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("delay", delay, {.unit = "s", .min = 0, .max = 60, .doc = "at least; their stamps are left alone"});
    v("jitter", jitter,
      {.unit = "s", .min = 0, .max = 60, .doc = "at most so much more, at random: one may overtake another"});
  }
};

class Late final : public Fault {
 public:
  explicit Late(std::string topic = {}) : topic_(std::move(topic)) {}
  void configure(FaultSetup& setup) override {
    const auto options = setup.parameters<LateParameters>();
    setup.bytes(topic_, [options, random = std::mt19937_64(setup.seed())](auto&, const FaultTick&) mutable {
      return Passage{.is_lost = false,
                     .held = Duration::seconds(options.delay + options.jitter * uniform(random))};
    });
  }

 private:
  std::string topic_;
};

struct StampParameters {
  double by = -1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("by", by,
      {.unit = "s",
       .min = -1e6,
       .max = 1e6,
       .doc = "added to the stamp: below 0 old, above 0 of the future"});
  }
};

/// The stamp of a header, with which the bytes begin: int32 seconds, uint32 nanoseconds behind 4 bytes of encapsulation.
void shift_stamp(std::vector<std::uint8_t>& cdr, Duration by) {
  constexpr std::size_t kSeconds = 4, kNanoseconds = 8, kEnd = 12;
  constexpr std::int64_t kSecond = 1'000'000'000;
  if (cdr.size() < kEnd || cdr[1] != 1) return;  // little-endian, as this program writes
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  std::memcpy(&seconds, cdr.data() + kSeconds, sizeof(seconds));
  std::memcpy(&nanoseconds, cdr.data() + kNanoseconds, sizeof(nanoseconds));
  const std::int64_t time = seconds * kSecond + nanoseconds + by.nanoseconds;
  const std::int64_t whole = time >= 0 ? time / kSecond : -((-time + kSecond - 1) / kSecond);
  seconds = static_cast<std::int32_t>(whole);
  nanoseconds = static_cast<std::uint32_t>(time - whole * kSecond);
  std::memcpy(cdr.data() + kSeconds, &seconds, sizeof(seconds));
  std::memcpy(cdr.data() + kNanoseconds, &nanoseconds, sizeof(nanoseconds));
}

class Stamps final : public Fault {
 public:
  explicit Stamps(std::string topic = {}) : topic_(std::move(topic)) {}
  void configure(FaultSetup& setup) override {
    const Duration by = Duration::seconds(setup.parameters<StampParameters>().by);
    const auto change = [by](auto& cdr, const FaultTick&) {
      shift_stamp(cdr, by);
      return kPasses;
    };
    setup.bytes(topic_, change, "std_msgs/msg/Header");
  }

 private:
  std::string topic_;
};

template <class Kind>
bool add(const char* name, const std::string& doc, const std::string& topic = {}) {
  return register_fault({name, doc, [topic] { return std::make_unique<Kind>(topic); }});
}

[[maybe_unused]] const bool kRegistered =
    add<Lost>("lost", "messages are lost: some, or all as if the network were cut") &&
    add<Late>("late", "messages come late, out of order with jitter") &&
    add<Stamps>("stamps", "messages have wrong stamps and come in time") &&
    add<Lost>("laser_silent", "sweeps are lost", "scan") &&
    add<Late>("laser_late", "sweeps come late", "scan") &&
    add<Stamps>("laser_stamps", "sweeps have wrong stamps", "scan") &&
    add<Lost>("receiver_lost", "fixes are lost", "gps/fix") &&
    add<Late>("receiver_late", "fixes come late", "gps/fix") &&
    add<Lost>("gyro_lost", "readings of the inertial unit are lost", "imu");

}  // namespace
}  // namespace bw
